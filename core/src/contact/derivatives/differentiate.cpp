#include "differentiate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "closed_forms/simplified/derivative_table.hpp"
#include "contact/rolling/rolling.hpp"
#include "contact/support/solver_support.hpp"
#include "frozen_contact.hpp"
#include "krylov_space.hpp"

namespace contactd {
namespace {

using Vector = KrylovSpace::Vector;
using Table = DerivativeTable;
using Right = KrylovSpace::Right;

// These are relative tolerances of the linear equations, for the residual of right-hand sides or the change of forces
// in a step. Pressures err by several times their residual at the edge of the contact.
constexpr double residual_tolerance = 2e-5, pressure_tolerance = 1e-7, coupled_tolerance = 1e-6,
                 change_tolerance = 2e-5;
// This tolerance applies if the error of forces is its square.
constexpr double symmetric_tolerance = 7e-4;
// The slipping part counts as at least this much, because the effect of friction is a difference, which is then small.
constexpr double least_slip_part = 0.1;

class Differentiation {
   public:
    Differentiation(const ContactProblem& problem, const ContactInfluence& influence, const ContactSolution& solution,
                    Observer& observer)
        : problem_(problem), solution_(solution), contact_(problem, influence, solution), observer_(observer) {}

    DerivativeTable find() {
        if (contact_.coupled())
            find_together();
        else
            find_one_by_one();
        to_units_of_motion();
        if (is_homogeneous()) follow_friction();
        return table_;
    }

    // Returns the derivative of the pressure of each element by the approach.
    std::vector<double> pressure_by_approach() { return contact_.on_grid(dp_, problem_.grid.size()); }

    SolverEvidence evidence() const { return {iterations_, residual_, converged_, stopwatch_.seconds()}; }

   private:
    // Solves for similar bodies, whose pressures depend only on the approach.
    void find_one_by_one() {
        dp_ = press();
        const Vector dg = contact_.bound_of_pressure(dp_);
        if (!problem_.friction) return;
        const Vector friction = contact_.bound_of_friction();
        if (contact_.tractions() == 0) {
            take(Table::approach, contact_.forces_of_bound(dg));
            take(Table::mu, contact_.forces_of_bound(friction));
            return;
        }
        std::vector<Table::Column> columns(motions.begin(), motions.end());
        std::vector<Right> rights;
        for (int k = 0; k < 3; ++k) rights.push_back(right(contact_.of_motion(k), Vector::Zero(3)));
        const auto add_bound = [&](Table::Column column, const Vector& change) {
            columns.push_back(column);
            rights.push_back(right(contact_.of_bound(change), contact_.forces_of_bound(change)));
        };
        add_bound(Table::approach, dg);
        if (!is_homogeneous()) add_bound(Table::mu, friction);
        const KrylovSpace space =
            solve({[this](const Vector& p, Vector& u) { contact_.tangential(p, u); },
                   [this](const Vector& r, Vector& z, int step) { contact_.precondition_tangential(r, z, step); },
                   contact_.symmetric(), contact_.weights(), contact_.forces_of_tractions()},
                  rights, tolerance());
        for (std::size_t i = 0; i < columns.size(); ++i) take(columns[i], space.sums(i));
    }

    KrylovSpace::Tolerance tolerance() const {
        if (contact_.symmetric()) return {symmetric_tolerance};
        const double part = is_homogeneous() ? std::max(contact_.slip_part(), least_slip_part) : 1;
        return {residual_tolerance, part * change_tolerance, change_of_forces()};
    }

    // Returns pressures for a unit of approach, and their force.
    Vector press() {
        const Eigen::Index size = contact_.pressures();
        const Vector ones = Vector::Ones(size);
        const KrylovSpace space =
            solve({[this](const Vector& p, Vector& u) { contact_.normal(p, u); },
                   [this](const Vector& r, Vector& z, int) { contact_.precondition_normal(r, z); }, true, ones,
                   contact_.element_area() * ones},
                  {{ones, ones.norm(), Vector::Zero(1)}}, {pressure_tolerance});
        table_.values[Table::Fn][Table::approach] = space.sums(0)[0];
        return space.solution(0);
    }

    void find_together() {
        const Eigen::Index pressures = contact_.pressures(), tractions = contact_.tractions();
        const std::array columns{Table::along_x, Table::along_y, Table::about_z, Table::approach, Table::mu};
        std::vector<Right> rights;
        const auto add_right = [&](const Vector& normal, const FrozenContact::Right& tangential, const Vector& known,
                                   double measure = 1) {
            Vector all(pressures + tractions);
            all << normal, tangential.values;
            rights.push_back({all, std::hypot(normal.norm(), tangential.size), known, measure});
        };
        const Vector none = Vector::Zero(pressures);
        for (int k = 0; k < 3; ++k) add_right(none, contact_.of_motion(k), Vector::Zero(4));
        // The effect of friction on pressures is smaller by this factor, and is needed as well.
        add_right(Vector::Ones(pressures), {Vector::Zero(tractions), 0}, Vector::Zero(4),
                  std::min(contact_.mean_friction(), 1.0));
        const Vector dg = contact_.bound_of_friction();
        Vector known(4);
        known << 0, contact_.forces_of_bound(dg);
        add_right(contact_.pressures_of_bound(dg), contact_.of_bound(dg), known);
        const KrylovSpace space =
            solve({[this](const Vector& p, Vector& u) { contact_.all(p, u); },
                   [this](const Vector& r, Vector& z, int step) { contact_.precondition_all(r, z, step); }, false,
                   contact_.weights_of_all(), contact_.forces_of_all(), pressures},
                  rights, {coupled_tolerance, change_tolerance, change_of_all()});
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const Vector sums = space.sums(i);
            table_.values[Table::Fn][columns[i]] = sums[0];
            take(columns[i], sums.tail(3));
            if (columns[i] == Table::approach) dp_ = space.solution(i);
        }
    }

    static Right right(const FrozenContact::Right& from, const Vector& known) {
        return {from.values, from.size, known};
    }

    KrylovSpace solve(LinearEquations equations, const std::vector<Right>& rights,
                      const KrylovSpace::Tolerance& tolerance) {
        KrylovSpace space(std::move(equations));
        space.solve(rights, tolerance, observer_);
        iterations_ += space.steps();
        residual_ = std::max(residual_, space.residual());
        converged_ = converged_ && space.converged();
        return space;
    }

    // Returns the largest change of Fx, Fy and Mz, over the largest of them.
    double relative_change(const Vector& now, const Vector& before) const {
        const Eigen::Vector3d unit(1, 1, 1 / contact_.length());
        const double largest = now.cwiseProduct(unit).cwiseAbs().maxCoeff();
        return (now - before).cwiseProduct(unit).cwiseAbs().maxCoeff() / largest;
    }
    KrylovSpace::Change change_of_forces() const {
        return [this](const Vector& now, const Vector& before) { return relative_change(now, before); };
    }
    // Also includes the change of Fn, over the largest of all.
    KrylovSpace::Change change_of_all() const {
        return [this](const Vector& now, const Vector& before) {
            const double normal = std::abs(now[0] - before[0]) / now.cwiseAbs().maxCoeff();
            return std::max(normal, relative_change(now.tail(3), before.tail(3)));
        };
    }

    void take(Table::Column column, const FrozenContact::Forces& forces) {
        for (int k = 0; k < 3; ++k) table_.values[Table::Fx + k][column] = forces[k];
    }

    // Returns whether tractions are proportional to bounds and motion: slip must not depend on anything else.
    bool is_homogeneous() const {
        const auto* rolling = problem_.friction ? std::get_if<Rolling>(&problem_.motion) : nullptr;
        const bool starts_anew = problem_.previous.empty() || (rolling != nullptr && rolling->steady());
        return !contact_.coupled() && contact_.tractions() > 0 && problem_.friction->mu.size() == 1 && starts_anew &&
               problem_.rigid_slip.empty();
    }

    // Uses Euler's theorem: mu dF/dmu + the motion times dF/d(motion) = F.
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

    // Converts from units of rigid slip: if the bodies roll, spin acts somewhat ahead.
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
    FrozenContact contact_;
    Observer& observer_;
    DerivativeTable table_;
    Vector dp_;  // by the approach
    double residual_ = 0;
    int iterations_ = 0;
    bool converged_ = true;
    Stopwatch stopwatch_;
};

}  // namespace

void differentiate(const ContactProblem& problem, const ContactInfluence& influence, Observer& observer,
                   ContactSolution& solution) {
    const bool has_contact =
        std::any_of(solution.pressure.begin(), solution.pressure.end(), [](double p) { return p > 0; });
    if (!has_contact) {
        solution.warnings.push_back("There is no contact, so there are no derivatives.");
        return;
    }
    Differentiation differentiation(problem, influence, solution, observer);
    DerivativeTable table = differentiation.find();
    table.has_rotation = !is_line_contact(problem);
    solution.evidence.derivatives = differentiation.evidence();
    if (solution.evidence.derivatives->converged) {
        solution.derivatives = named(table, problem);
        solution.pressure_by_approach = differentiation.pressure_by_approach();
        return;
    }
    solution.warnings.push_back(
        "The equations of the derivatives did not reach their tolerance, so there are no derivatives.");
}

}  // namespace contactd
