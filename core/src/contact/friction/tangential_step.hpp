// Solves the tangential half of a step: shift or rolling, with the motion prescribed or computed from forces.
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

/// Holds tractions on all elements of the grid, on the upper body (N/mm^2).
struct Tractions {
    std::vector<double> pressure;
    Field tangential;
};

/// Returns whether one or both components of the force are prescribed.
bool prescribes_force(const Motion& motion);

class TangentialStep {
   public:
    /// `problem` has friction; both arguments must outlive this object.
    TangentialStep(const ContactProblem& problem, const ContactInfluence& influence);

    /// Begins a new step, from which slip is counted.
    void begin(const Tractions& before);

    /// Announces that the next solve starts from tractions that match this motion, and are as good as those of coarser
    /// grids. If forces are prescribed, the solve starts from the motion, too.
    void expect(const Motion& motion);

    /// Returns tractions and slip for a pressure and the friction bounds. `estimate` is the start; later solves of a
    /// step reuse data of the first. Forces are met to the larger of the tolerances of `settings` and of the problem's
    /// outer settings. `flow` is that of a layer that hardens, or null.
    RollingSolution solve(std::span<const double> pressure, std::span<const double> bound, const Field& estimate,
                          const SolverSettings& settings, const FlowTask* flow, Observer& observer);

    /// Returns the motion of the request, completed by components computed for prescribed forces.
    const Motion& motion() const { return motion_; }
    const std::optional<SolverEvidence>& force_evidence() const { return force_evidence_; }
    /// Returns the solver that computed the tractions of the last solve.
    TangentialSolver solver_used() const { return solver_used_; }
    /// Returns slip per unit of the motion: dq for creepages, 1 for shifts (mm).
    double unit() const { return unit_; }

   private:
    const Rolling* rolling() const { return std::get_if<Rolling>(&motion_); }
    bool is_steady() const { return rolling() && rolling()->steady(); }
    Field rigid_slip() const;
    /// Returns the contribution of the previous step to the slip, for a contact with these pressures.
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
    // Hold the contribution of the previous step to the slip, for particles that were a step upstream, and for those at
    // the same place.
    Field history_, same_place_;
    EnteringParticles entering_;  // for the present pressures
    std::optional<SolverEvidence> force_evidence_;
    FrictionSolver solver_;
    const FlowTask* flow_ = nullptr;  // for the present solve
    TangentialSolver solver_used_ = TangentialSolver::newton;
    double slip_scale_ = 0;  // from the first solve of this step
    bool is_first_ = true;   // whether this is the first solve of this step
    bool estimate_is_good_ = false;
};

}  // namespace contactd
