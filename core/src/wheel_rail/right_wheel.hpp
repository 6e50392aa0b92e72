// A right wheel on its rail in one position, and what is asked of it.
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

    /// All but the state must live longer. The observer ends searches, too. `before` is what a step that is not steady
    /// goes on from. The set-up allows the state (validate).
    RightWheel(const WheelRailSetup& setup, const geometry::Profiles& profiles, const InfluenceSource& influences,
               const WheelRailState& state, const Observer& observer, std::shared_ptr<const Patches> before = nullptr);

    WheelRailSolution solve(Observer& observer);
    /// At this height, whatever the state says of height and force.
    WheelRailSolution at(double z, Observer& observer);
    WheelRailGeometry locate();
    std::optional<double> first_contact_height() const;
    /// Whether a contact bends away from its plane by more than most_bend, at position.z or where Hertz's theory
    /// expects Fz.
    bool bends();

    const WheelRailSetup& setup() const { return setup_; }
    const WheelRailState& state() const { return state_; }
    /// Returns the same wheel elsewhere, or with other tolerances; both arguments must live longer.
    RightWheel with(const WheelRailSetup& setup, const WheelRailState& state) const {
        return {setup, profiles_, influences_, state, observer_, before_};
    }
    /// Where searches and solvers start, and those of one search from each other; after a solve, where those of the
    /// next step do. Without it each solve starts from nothing.
    /// Takes what the step before has left, and leaves what this one ends with. Where there is nothing yet, what is
    /// found is to the last bit what it is without.
    void start_from(WheelRailEstimates& estimates) {
        estimates_ = &estimates;
        has_tractions_ = !estimates.patches.empty();
    }
    /// Where a step that is not steady goes on from: a copy, for estimates change during a search.
    void go_on_from(Patches before) { before_ = std::make_shared<const Patches>(std::move(before)); }
    /// Positions do not depend on it.
    void set_velocity(const WheelsetVelocity& velocity) { state_.velocity = velocity; }
    geometry::Position& position() { return position_; }
    /// Returns the search for the height that brings a force.
    HeightTask height_task(double Fz);
    ContactProblem problem_of(const geometry::CandidatePatch& found) const;
    ContactSolution solve(ContactProblem problem, const geometry::CandidatePatch& found, Observer& observer) const;

   private:
    void check_depth(double z) const;
    /// Gives an answer the frames of both profiles at its z.
    template <class Answer>
    void place_profiles(Answer& answer) const;
    /// Where Hertz's theory expects Fz, or position.z.
    double expected_height();
    /// Returns whether the force falls while the wheel is lowered from where it was solved, where regions have a
    /// weighted interaction; by normal contact alone.
    bool falls_where_regions_merge(const WheelRailSolution& solution, Observer& observer) const;
    /// Counts the regions of overlap.
    std::size_t regions_at(double z) const;
    WheelRailSolution at(double z, std::vector<geometry::CandidatePatch> candidates, Observer& observer);
    Placement placed(double z, std::vector<geometry::CandidatePatch> candidates, Observer& observer) const;
    /// Where a wheel is solved: at a height, or where one of its patches carries a normal force.
    struct Load {
        double z;  ///< of a single patch with a force about where that is
        std::optional<double> Fn{};
        std::size_t patch = 0;  ///< which carries Fn
    };
    WheelRailSolution solve(const Placement& placement, const Load& load, Observer& observer);
    /// Without forces on the wheel.
    WheelRailPatch solve(const geometry::CandidatePatch& found, ContactProblem problem,
                         const InfluenceSource& influences, Observer& observer) const;
    ContactSolution solve(ContactProblem problem, const geometry::CandidatePatch& found,
                          const InfluenceSource& influences, Observer& observer) const;
    WheelRailForces forces_of(const WheelRailPatch& patch, const geometry::CandidatePatch& found, double z) const;
    TractionHistory history_of(const std::vector<geometry::CandidatePatch>& candidates) const;
    /// Returns the force by a simplified model, which does not depend on elements, and costs less than their arrays.
    double simplified_force(double z, std::vector<geometry::CandidatePatch> candidates, Observer& observer) const;
    WheelRailSolution under_force(double Fz, Observer& observer);
    /// Finds the height of full theory; `solution` becomes that of the last one.
    HeightFound carry(double Fz, HeightTask& task, WheelRailSolution& solution, Observer& observer);
    HeightFound carry_by_simplified_model(HeightTask& task, WheelRailSolution& solution, Observer& observer);

    const WheelRailSetup& setup_;
    const geometry::Profiles& profiles_;
    const InfluenceSource& influences_;
    const Observer& observer_;
    WheelRailState state_;  // its pitch rate may be searched for
    geometry::Position position_;
    WheelRailEstimates* estimates_ = nullptr;
    bool has_tractions_ = false;  // of the step before
    std::shared_ptr<const Patches> before_;
};

}  // namespace contactd
