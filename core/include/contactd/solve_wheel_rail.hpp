// From profiles, a wheelset's position and its motion to contact forces.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "contactd/contact_influence.hpp"
#include "contactd/observer.hpp"
#include "contactd/patch_strips.hpp"
#include "contactd/wheel_rail_estimates.hpp"
#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_solution.hpp"
#include "contactd/wheel_rail_state.hpp"

namespace contactd {

/// Who makes the operators of a problem, of which only set-up and motion are of any meaning, on the strips of its
/// patch. Patches of one size ask again and again. The observer hears of tables that are built, and ends that.
using InfluenceSource = std::function<ContactInfluence(const ContactProblem&, const PatchStrips&, Observer&)>;

/// One wheel on its rail: keeps the curves of the profiles and, where it makes them itself, the operators of the grids
/// that occurred last. Safe to use from several threads at once; answers depend on the state alone.
class WheelRailContact {
   public:
    /// Half-spaces where no source is given; other bodies, and conformal fem, need one. Throws InvalidArgument naming
    /// the field, and Cancelled when the observer says so while profiles are read.
    explicit WheelRailContact(WheelRailSetup setup, InfluenceSource source = nullptr, const Observer& observer = {});

    /// No contact is an answer, and so is one that has not converged, or has warnings. Throws InvalidArgument where the
    /// state makes no sense ("position.z" where the wheel stands far inside the rail), and Cancelled.
    WheelRailSolution solve(const WheelRailState& state, Observer& observer) const;

    /// Solves within the tolerances, from where a step before has ended; the solves of a search for a force start from
    /// each other. `estimates` become those for the next step, and mean nothing where this throws.
    WheelRailSolution solve(const WheelRailState& state, WheelRailEstimates& estimates, Observer& observer) const;
    /// Solves one state of several of a step that is searched for; estimates.end_step() ends it.
    WheelRailSolution solve_within_step(const WheelRailState& state, WheelRailEstimates& estimates,
                                        Observer& observer) const;

    /// The search for contacts alone: at position.z or, where Fz is given, where Hertz's theory expects that force.
    /// Throws as solve.
    WheelRailGeometry locate(const WheelRailState& state, const Observer& observer = {}) const;

    /// position.z at which wheel and rail begin to touch (mm); nothing where they are not above each other.
    std::optional<double> first_contact_height(const WheelRailState& state, const Observer& observer = {}) const;

    /// Returns this contact with another friction; it shares what is cached. Throws InvalidArgument ("friction.mu",
    /// ...).
    WheelRailContact with_friction(const WheelRailFriction& friction) const;

    const WheelRailSetup& setup() const;

   private:
    struct Parts;
    explicit WheelRailContact(std::shared_ptr<const Parts> parts);
    std::shared_ptr<const Parts> parts_;
};

/// One step of a contact that is not kept.
WheelRailSolution solve_wheel_rail(const WheelRailSetup& setup, const WheelRailState& state, Observer& observer);

/// Both wheels of a wheelset that is free to roll: at the height and the roll at which each presses on its rail as
/// told, heights that agree to `height_tolerance` (mm). Set-ups are those of one left and one right wheel. Throws as
/// WheelRailContact::solve, and InvalidArgument ("Fz_left", "left", ...).
WheelsetSolution solve_wheelset(const WheelRailContact& left, const WheelRailContact& right, const WheelsetState& state,
                                Observer& observer, double height_tolerance = 1e-6);
/// Solves within the tolerances, from where a step before has ended.
WheelsetSolution solve_wheelset(const WheelRailContact& left, const WheelRailContact& right, const WheelsetState& state,
                                WheelsetEstimates& estimates, Observer& observer, double height_tolerance = 1e-6);

}  // namespace contactd
