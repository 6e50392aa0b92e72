#include "contactd/contact.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "contactd/error.hpp"
#include "contactd/normal.hpp"
#include "contactd/tangential.hpp"
#include "solver_support.hpp"

namespace contactd {
namespace {

// Shows the progress of one solver as a part of the whole computation.
class PartObserver final : public Observer {
   public:
    PartObserver(Observer& whole, double first, double last) : whole_(whole), first_(first), last_(last) {}
    void on_progress(const Progress& part) override {
        Progress progress = part;
        progress.fraction = first_ + part.fraction * (last_ - first_);
        whole_.on_progress(progress);
    }
    bool cancelled() const override { return whole_.cancelled(); }

   private:
    Observer& whole_;
    const double first_, last_;
};

void solve_friction(const ContactProblem& problem, const InfluenceOperator& influence, Observer& observer,
                    ContactSolution& solution) {
    const Friction& friction = *problem.friction;
    std::vector<double> bound = solution.pressure;
    for (double& g : bound) g *= friction.mu;
    const std::vector<double> rigid_x(bound.size(), friction.rigid_shift_x);
    const std::vector<double> rigid_y(bound.size(), friction.rigid_shift_y);
    TangentialSolution tangential = solve_tangential(influence, bound, rigid_x, rigid_y, problem.tangential_settings,
                                                     problem.initial_traction_x, problem.initial_traction_y, observer);
    solution.traction_x = std::move(tangential.traction_x);
    solution.traction_y = std::move(tangential.traction_y);
    solution.tangential = tangential.evidence;
    for (std::size_t i = 0; i < bound.size(); ++i)
        if (bound[i] > 0) solution.element_division[i] = tangential.element_division[i];
}

void check_uncoupled(const ContactProblem& problem) {
    if (problem.given_ics && coupling(problem.given_ics->table) > coupling_tolerance)
        throw InvalidArgument("ics.table",
                              "has xz, zx, yz or zy, which couple normal and tangential contact; with friction this is "
                              "not solved yet: they must be zero");
    if (!problem.given_ics && !problem.bodies.quasi_identical())
        throw InvalidArgument("bodies.lower",
                              "has another (1-2nu)/G than bodies.upper, which couples normal and tangential contact; "
                              "with friction this is not solved yet: both bodies must have the same (1-2nu)/G");
}

void add_up(const Grid& grid, ContactSolution& solution) {
    for (std::size_t i = 0; i < grid.size(); ++i) {
        solution.Fn += solution.pressure[i];
        solution.Fx += solution.traction_x[i];
        solution.Fy += solution.traction_y[i];
        solution.pmax = std::max(solution.pmax, solution.pressure[i]);
        if (solution.element_division[i] == ElementState::adhesion) ++solution.adhesion_elements;
        if (solution.element_division[i] == ElementState::slip) ++solution.slip_elements;
    }
    const double area = grid.element_area();
    solution.Fn *= area;
    solution.Fx *= area;
    solution.Fy *= area;
    solution.contact_elements = solution.adhesion_elements + solution.slip_elements;
    solution.contact_area = solution.contact_elements * area;
    solution.adhesion_area = solution.adhesion_elements * area;
    solution.slip_area = solution.slip_elements * area;
}

}  // namespace

ContactSolution solve_contact(const ContactProblem& problem, const InfluenceOperator& influence, Observer& observer) {
    validate(problem);
    if (influence.size() != problem.grid.size())
        throw InvalidArgument("grid", "has " + std::to_string(problem.grid.size()) +
                                          " elements; the influence coefficients are for " +
                                          std::to_string(influence.size()));
    if (problem.friction) check_uncoupled(problem);
    std::vector<double> gap = problem.undeformed_distance;
    for (double& h : gap) h -= problem.approach;
    ContactSolution solution;
    PartObserver normal_part(observer, 0, problem.friction ? 0.3 : 1);
    NormalSolution normal =
        solve_normal(influence, gap, problem.normal_settings, problem.initial_pressure, normal_part);
    solution.pressure = std::move(normal.pressure);
    solution.normal = normal.evidence;
    const std::size_t n = problem.grid.size();
    solution.element_division.assign(n, ElementState::exterior);
    for (std::size_t i = 0; i < n; ++i)
        if (solution.pressure[i] > 0) solution.element_division[i] = ElementState::slip;  // where no friction holds it
    solution.traction_x.resize(n);
    solution.traction_y.resize(n);
    PartObserver tangential_part(observer, 0.3, 1);
    if (problem.friction) solve_friction(problem, influence, tangential_part, solution);
    add_up(problem.grid, solution);
    return solution;
}

}  // namespace contactd
