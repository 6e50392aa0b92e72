#include "differentiate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "closed_forms/derivative_table.hpp"
#include "contact/rolling/rolling.hpp"
#include "contact/support/solver_support.hpp"
#include "held_contact.hpp"
#include "krylov_space.hpp"

namespace contactd {
namespace {

using Vector = KrylovSpace::Vector;
using Table = DerivativeTable;

constexpr double usual_tolerance = 2e-5;  // of linear equations, relative
constexpr double coupled_tolerance = 3e-6;
// The same where what is left of them is made up for, so that forces err by its square.
constexpr double symmetric_tolerance = 1e-3;

/// Changes for one unit of an input.
struct Change {
    Vector dp, dq, dg;
    Vector residual{};  // of the tangential equations
};

/// One after the other: pressures follow the approach alone.
class Differentiation {
   public:
    Differentiation(const ContactProblem& problem, const ContactInfluence& influence, const ContactSolution& solution,
                    Observer& observer)
        : problem_(problem), solution_(solution), contact_(problem, influence, solution), observer_(observer) {}

    DerivativeTable find() {
        if (contact_.coupled())
            find_together();
        else
            find_in_turn();
        to_units_of_motion();
        if (is_homogeneous()) follow_friction();
        return table_;
    }

    SolverEvidence evidence() const { return {iterations_, residual_, residual_ <= tolerance_, stopwatch_.seconds()}; }

   private:
    using Map = KrylovSpace::Map;

    void find_in_turn() {
        tolerance_ = contact_.symmetric() ? symmetric_tolerance : usual_tolerance;
        KrylovSpace normal(
            contact_.pressures(), [&](const Vector& p, Vector& u) { contact_.normal(p, u); },
            [&](const Vector& r, Vector& z) { contact_.precondition_normal(r, z); });
        const Vector ones = Vector::Ones(contact_.pressures());
        const auto pressed = solve(normal, ones, ones.norm(), usual_tolerance);
        iterations_ += normal.steps();
        const Vector none = Vector::Zero(contact_.pressures());
        Change by_approach{pressed.x, Vector::Zero(contact_.tractions()), contact_.bound_of_pressure(pressed.x)};
        if (!problem_.friction || contact_.tractions() == 0) {
            take(Table::approach, by_approach);
            if (problem_.friction) take(Table::mu, {none, by_approach.dq, contact_.bound_of_friction()});
            return;
        }
        KrylovSpace tangential(
            contact_.tractions(), [&](const Vector& p, Vector& u) { contact_.tangential(p, u); },
            [&](const Vector& r, Vector& z) { contact_.precondition_tangential(r, z); });
        const auto respond = [&](Table::Column column, Change change, const HeldContact::Right& right) {
            auto found = solve(tangential, right.values, right.size, tolerance_);
            change.dq = std::move(found.x);
            change.residual = contact_.unweighted(std::move(found.residual));
            take(column, change);
            return change;
        };
        for (int k = 0; k < 3; ++k) slips_.push_back(respond(motions[k], {none, {}, none}, contact_.of_slip(k)));
        respond(Table::approach, by_approach, contact_.of_bound(by_approach.dg));
        if (!is_homogeneous()) {
            const Vector dg = contact_.bound_of_friction();
            respond(Table::mu, {none, {}, dg}, contact_.of_bound(dg));
        }
        iterations_ += tangential.steps();
        if (contact_.symmetric()) make_up_for_residuals();
    }

    void find_together() {
        tolerance_ = coupled_tolerance;
        const Eigen::Index pressures = contact_.pressures(), tractions = contact_.tractions();
        KrylovSpace all(
            pressures + tractions, [&](const Vector& p, Vector& u) { contact_.all(p, u); },
            [&](const Vector& r, Vector& z) { contact_.precondition_all(r, z); });
        const auto respond = [&](Table::Column column, const Vector& normal, const HeldContact::Right& tangential,
                                 const Vector& dg, double measure = 1) {
            Vector right(pressures + tractions);
            right << normal, tangential.values;
            const Vector x = solve(all, right, std::hypot(normal.norm(), tangential.size), tolerance_, measure).x;
            const Vector dp = x.head(pressures);
            take(column, {dp, x.tail(tractions), contact_.bound_of_pressure(dp) + dg});
        };
        const Vector ones = Vector::Ones(pressures), none = Vector::Zero(pressures);
        for (int k = 0; k < 3; ++k) respond(motions[k], none, contact_.of_slip(k), none);
        // What friction makes of pressures is so much less, and wanted as well.
        respond(Table::approach, ones, {Vector::Zero(tractions), 0}, none, std::min(contact_.mean_friction(), 1.0));
        const Vector dg = contact_.bound_of_friction();
        respond(Table::mu, contact_.pressures_of_bound(dg), contact_.of_bound(dg), dg);
        iterations_ += all.steps();
    }

    // Residuals count relative to `measure` times the right-hand side.
    KrylovSpace::Solution solve(KrylovSpace& space, const Vector& right, double size, double tolerance,
                                double measure = 1) {
        if (!(measure > 0)) measure = 1;
        auto found = space.solve(right, size, measure * tolerance, observer_);
        residual_ = std::max(residual_, found.relative / measure);
        return found;
    }

    void take(Table::Column column, const Change& change) {
        const std::array<double, 4> forces = contact_.forces(change.dp, change.dq, change.dg);
        for (int row = 0; row < Table::rows; ++row) table_.values[row][column] = forces[row];
        residuals_[column] = change.residual;
    }

    // J x_k = -P e_k and F_k = e_k . dq, so that -x_k . r is what F_k misses for the residual r, but for the product of
    // both errors.
    void make_up_for_residuals() {
        const double area = problem_.grid.element_area();
        for (int column = 0; column < Table::columns; ++column) {
            if (residuals_[column].size() == 0) continue;
            for (int k = 0; k < 3; ++k)
                table_.values[Table::Fx + k][column] -= area * slips_[k].dq.dot(residuals_[column]);
        }
    }

    // Whether tractions double with bounds and motion: where slip owes nothing to anything else.
    bool is_homogeneous() const {
        const auto* rolling = problem_.friction ? std::get_if<Rolling>(&problem_.motion) : nullptr;
        const bool starts_anew = problem_.previous.empty() || (rolling != nullptr && rolling->steady());
        return !contact_.coupled() && contact_.tractions() > 0 && problem_.friction->mu.size() == 1 && starts_anew &&
               problem_.rigid_slip.empty();
    }

    // By Euler: mu dF/dmu + the motion times dF/d(motion) = F.
    void follow_friction() {
        const TangentialForces sum = tangential_forces(problem_.grid, solution_.traction_x, solution_.traction_y);
        const std::array forces{sum.Fx, sum.Fy, sum.Mz};
        std::array<double, 3> motion;
        if (const auto* rolling = std::get_if<Rolling>(&*solution_.motion)) {
            motion = {rolling->xi, rolling->eta, rolling->phi};
        } else {
            const auto& shift = std::get<Shift>(*solution_.motion);
            motion = {shift.rigid_shift.x, shift.rigid_shift.y, shift.rotation};
        }
        for (std::size_t row = 0; row < 3; ++row) {
            auto& values = table_.values[Table::Fx + row];
            double rest = forces[row];
            for (std::size_t k = 0; k < 3; ++k) rest -= motion[k] * values[motions[k]];
            values[Table::mu] = rest / problem_.friction->mu[0];
        }
    }

    // From units of rigid slip: where the bodies roll, spin acts somewhat ahead.
    void to_units_of_motion() {
        const auto* rolling = problem_.friction ? std::get_if<Rolling>(&problem_.motion) : nullptr;
        if (rolling == nullptr) return;
        const double dq = step_length(*rolling, problem_.grid);
        const auto [x, y] = step_of(problem_);
        for (auto& row : table_.values) {
            row[Table::about_z] += rolling->spin_offset * (x * row[Table::along_y] - y * row[Table::along_x]);
            for (const Table::Column motion : motions) row[motion] *= dq;
        }
    }

    static constexpr std::array motions{Table::along_x, Table::along_y, Table::about_z};

    const ContactProblem& problem_;
    const ContactSolution& solution_;
    HeldContact contact_;
    Observer& observer_;
    DerivativeTable table_;
    std::vector<Change> slips_;
    std::array<Vector, Table::columns> residuals_;
    double tolerance_ = 0, residual_ = 0;
    int iterations_ = 0;
    Stopwatch stopwatch_;
};

}  // namespace

void differentiate(const ContactProblem& problem, const ContactInfluence& influence, Observer& observer,
                   ContactSolution& solution) {
    const bool has_contact =
        std::any_of(solution.pressure.begin(), solution.pressure.end(), [](double p) { return p > 0; });
    if (!has_contact) {
        solution.warnings.push_back("There is no contact, and so there are no derivatives.");
        return;
    }
    Differentiation differentiation(problem, influence, solution, observer);
    DerivativeTable table = differentiation.find();
    table.has_turn = !is_line_contact(problem);
    solution.evidence.derivatives = differentiation.evidence();
    if (solution.evidence.derivatives->converged) {
        solution.derivatives = named(table, problem);
        return;
    }
    solution.warnings.push_back("The equations of the derivatives did not reach their tolerance: there are none.");
}

}  // namespace contactd
