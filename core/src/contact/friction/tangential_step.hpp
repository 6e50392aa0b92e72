// The tangential half of a step: shift or rolling, the motion prescribed or found from forces.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "contact/rolling/rolling.hpp"
#include "contact/support/contact_elements.hpp"
#include "contact/support/entering_particles.hpp"
#include "contact/tangential/prescribed_force.hpp"
#include "contactd/contact.hpp"
#include "contactd/contact_influence.hpp"
#include "contactd/observer.hpp"
#include "friction_solver.hpp"

namespace contactd {

/// Tractions on all elements of the grid, on the upper body (N/mm^2).
struct Tractions {
    std::vector<double> pressure;
    Field tangential;
    /// A layer that yields (N/mm^2) and kinetic friction have these at the end of the step; else empty.
    std::vector<double> yield_stress{}, friction_coefficient{};
};

/// Whether one or both components of the force are given.
bool prescribes_force(const Motion& motion);

class TangentialStep {
   public:
    /// `problem` has friction; both arguments outlive this.
    TangentialStep(const ContactProblem& problem, const ContactInfluence& influence);

    /// A new step begins: slip is counted from here.
    void begin(const Tractions& before);

    /// The next solve starts from tractions that go with this motion, as good as those that coarser grids tell of.
    /// Where forces are given it starts from the motion, too.
    void expect(const Motion& motion);

    /// Tractions and slip for a pressure and the bounds that friction makes of it. `estimate` is where to start; solves
    /// of a step that follow the first know what that has learnt. Forces are met to the larger one of the tolerances of
    /// `settings` and of the problem's outer settings.
    /// `flow` is that of a layer that hardens, or null.
    RollingSolution solve(std::span<const double> pressure, std::span<const double> bound, const Field& estimate,
                          const SolverSettings& settings, const FlowTask* flow, Observer& observer);

    /// Returns the motion of the request, completed by what prescribed forces found.
    const Motion& motion() const { return motion_; }
    const std::optional<SolverEvidence>& force_evidence() const { return force_evidence_; }
    /// Returns which solver found the tractions of the last solve.
    TangentialSolver solver_used() const { return solver_used_; }
    /// Slip per unit of the motion: dq of creepages, 1 of shifts (mm).
    double unit() const { return unit_; }

   private:
    const Rolling* rolling() const { return std::get_if<Rolling>(&motion_); }
    bool is_steady() const { return rolling() && rolling()->steady(); }
    Field rigid_slip() const;
    /// What slip owes to the step before, in a contact of these pressures.
    Field history(std::span<const double> pressure);
    RollingBodies bodies() const;
    void add_coupling(std::span<const double> pressure, Field& rigid) const;
    void add_free_slip(std::span<const double> pressure, std::span<const double> bound, const Field& rest,
                       RollingSolution& solution) const;
    PrescribedForces prescribed_forces(std::span<const double> bound);
    double reduce_to_bound(PrescribedForces& forces) const;
    RollingSolution solve_for_motion(const Field& rest, std::span<const double> bound, const Field& estimate,
                                     const SolverSettings& settings, Observer& observer);
    RollingSolution solve_for_force(const Field& rest, std::span<const double> bound, const Field& estimate,
                                    const SolverSettings& settings, Observer& observer);
    FrictionSolution solve_at_once(const PrescribedForces& forces, const Field& rest, std::span<const double> bound,
                                   const Field& estimate, const SolverSettings& settings, Observer& observer);
    SolverSettings search_settings() const;
    RollingSolution search(const PrescribedForces& forces, const Field& rest, std::span<const double> bound,
                           const Field& estimate, Observer& observer);
    RollingSolution solve_with(const FrictionTask& task, Observer& observer);
    bool asks_tang_cg() const { return problem_.settings.tangential_solver == TangentialSolver::tangcg; }
    void continue_force_evidence(const SolverEvidence& next);

    const ContactProblem& problem_;
    const ContactInfluence& influence_;
    const std::size_t n_;
    Motion motion_;
    double unit_ = 1;
    // What slip owes to the step before: of particles that were a step upstream, and of those at the same place.
    Field history_, same_place_;
    EnteringParticles entering_;  // of the present pressures
    std::optional<SolverEvidence> force_evidence_;
    FrictionSolver solver_;
    const FlowTask* flow_ = nullptr;  // of the present solve
    TangentialSolver solver_used_ = TangentialSolver::newton;
    double slip_scale_ = 0;  // of the first solve of this step
    bool is_first_ = true;   // solve of this step
    bool estimate_is_good_ = false;
};

}  // namespace contactd
