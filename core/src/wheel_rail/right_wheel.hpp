// Represents a right wheel on its rail in one position, and its requested results.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "contactd/solve_wheel_rail.hpp"
#include "geometry/position.hpp"
#include "wheel_rail/position/height_search.hpp"
#include "wheel_rail/position/placement.hpp"
#include "wheel_rail/position/traction_history.hpp"

namespace contactd {

class RightWheel {
   public:
    using Patches = std::vector<WheelRailEstimates::Patch>;

    /// All arguments except the state must outlive this object. The observer also ends searches. `before` is the state
    /// from which a transient step starts. The state must be valid for the set-up (validate).
    RightWheel(const WheelRailSetup& setup, const geometry::Profiles& profiles, const InfluenceSource& influences,
               const WheelRailState& state, const Observer& observer, std::shared_ptr<const Patches> before = nullptr);

    WheelRailSolution solve(Observer& observer);
    /// Solves at this height, independently of height and force in the state.
    WheelRailSolution at(double z, Observer& observer);
    WheelRailGeometry locate();
    std::optional<double> first_contact_height() const;
    /// Returns whether a contact bends away from its plane by more than most_bend, at position.z or at the height that
    /// Hertz's theory expects for Fz.
    bool bends();

    const WheelRailSetup& setup() const { return setup_; }
    const WheelRailState& state() const { return state_; }
    /// Returns the same wheel in another position, or with other tolerances. Both arguments must outlive it.
    RightWheel with(const WheelRailSetup& setup, const WheelRailState& state) const {
        return {setup, profiles_, influences_, state, observer_, before_};
    }
    /// Sets the start of searches and solvers, also between the solves of one search. After a solve it contains the
    /// start of the next step. Without it, each solve starts from zero. Reads the estimates of the previous step and
    /// stores those of this one. Without previous estimates, results are bitwise equal to those without this call.
    void start_from(WheelRailEstimates& estimates) {
        estimates_ = &estimates;
        has_tractions_ = !estimates.patches.empty();
    }
    /// Sets the start of a transient step. It is a copy, because estimates change during a search.
    void go_on_from(Patches before) { before_ = std::make_shared<const Patches>(std::move(before)); }
    /// Sets the velocity, which does not affect positions.
    void set_velocity(const WheelsetVelocity& velocity) { state_.velocity = velocity; }
    geometry::Position& position() { return position_; }
    /// Returns the search for the height that produces a force.
    HeightTask height_task(double Fz);
    ContactProblem problem_of(const geometry::CandidatePatch& found) const;
    ContactSolution solve(ContactProblem problem, const geometry::CandidatePatch& found, Observer& observer) const;

   private:
    void check_depth(double z) const;
    /// Adds the frames of both profiles at its z to an answer.
    template <class Answer>
    void place_profiles(Answer& answer) const;
    /// Returns the height that Hertz's theory expects for Fz, or position.z.
    double expected_height();
    /// Returns whether the force decreases while the wheel is lowered from its solved height, if regions have a
    /// weighted interaction. Uses normal contact only.
    bool falls_where_regions_merge(const WheelRailSolution& solution, Observer& observer) const;
    /// Counts the regions of overlap.
    std::size_t regions_at(double z) const;
    WheelRailSolution at(double z, std::vector<geometry::CandidatePatch> candidates, Observer& observer);
    Placement placed(double z, std::vector<geometry::CandidatePatch> candidates, Observer& observer) const;
    /// Describes the target of a solve: a height, or a normal force of one of the patches.
    struct Load {
        double z;  ///< height, which is approximate for a single patch with a force
        std::optional<double> Fn{};
        std::size_t patch = 0;  ///< patch that carries Fn
    };
    WheelRailSolution solve(const Placement& placement, const Load& load, Observer& observer);
    /// Returns the solution without forces on the wheel.
    WheelRailPatch solve(const geometry::CandidatePatch& found, ContactProblem problem,
                         const InfluenceSource& influences, Observer& observer) const;
    ContactSolution solve(ContactProblem problem, const geometry::CandidatePatch& found,
                          const InfluenceSource& influences, Observer& observer) const;
    WheelRailForces forces_of(const WheelRailPatch& patch, const geometry::CandidatePatch& found, double z) const;
    TractionHistory history_of(const std::vector<geometry::CandidatePatch>& candidates) const;
    /// Returns the force by a simplified model, which does not depend on elements and costs less than their arrays.
    double simplified_force(double z, std::vector<geometry::CandidatePatch> candidates, Observer& observer) const;
    WheelRailSolution under_force(double Fz, Observer& observer);
    /// Finds the height by the full theory; `solution` becomes that of the last solve.
    HeightFound carry(double Fz, HeightTask& task, WheelRailSolution& solution, Observer& observer);
    HeightFound carry_by_simplified_model(HeightTask& task, WheelRailSolution& solution, Observer& observer);

    const WheelRailSetup& setup_;
    const geometry::Profiles& profiles_;
    const InfluenceSource& influences_;
    const Observer& observer_;
    WheelRailState state_;  // a search may change its pitch rate
    geometry::Position position_;
    WheelRailEstimates* estimates_ = nullptr;
    bool has_tractions_ = false;  // whether there are tractions of the previous step
    std::shared_ptr<const Patches> before_;
};

}  // namespace contactd
