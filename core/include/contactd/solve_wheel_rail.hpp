// Computes contact forces from profiles and from position and motion of a wheelset.
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

/// Creates the operators of a problem on the strips of its patch; it uses only the set-up and the motion. It is called
/// repeatedly for patches of one size. The observer receives the progress of tables, and can cancel.
using InfluenceSource = std::function<ContactInfluence(const ContactProblem&, const PatchStrips&, Observer&)>;

/// Represents one wheel on its rail: keeps the curves of the profiles and, unless a source is given, the operators of
/// the grids used last. It is safe to use from several threads at once, and answers depend only on the state.
class WheelRailContact {
   public:
    /// Without a source, bodies are half-spaces. Other bodies, and conformal fem, need one. Throws InvalidArgument,
    /// which names the field, and Cancelled while profiles are read.
    explicit WheelRailContact(WheelRailSetup setup, InfluenceSource source = nullptr, const Observer& observer = {});

    /// Solves a state. The answer may have no contact, may not have converged, or may have warnings. Throws
    /// InvalidArgument for an invalid state ("position.z" if the wheel is far inside the rail), and Cancelled.
    WheelRailSolution solve(const WheelRailState& state, Observer& observer) const;

    /// Solves a state within the tolerances, from the end of the previous step; the solves of a search for a force
    /// start from each other. `estimates` become those for the next step, and are invalid after an exception.
    WheelRailSolution solve(const WheelRailState& state, WheelRailEstimates& estimates, Observer& observer) const;
    /// Solves one of several states in the search for a step; estimates.end_step() ends it.
    WheelRailSolution solve_within_step(const WheelRailState& state, WheelRailEstimates& estimates,
                                        Observer& observer) const;

    /// Searches only for contacts: at position.z or, if Fz is given, at the height where Hertz's theory yields that
    /// force. Throws as solve.
    WheelRailGeometry locate(const WheelRailState& state, const Observer& observer = {}) const;

    /// Returns position.z at first contact of wheel and rail (mm), or nothing if they are not above each other.
    std::optional<double> first_contact_height(const WheelRailState& state, const Observer& observer = {}) const;

    /// Returns this contact with another friction, sharing cached data. Throws InvalidArgument ("friction.mu",
    /// ...).
    WheelRailContact with_friction(const WheelRailFriction& friction) const;

    const WheelRailSetup& setup() const;

   private:
    struct Parts;
    explicit WheelRailContact(std::shared_ptr<const Parts> parts);
    std::shared_ptr<const Parts> parts_;
};

/// Solves one step of a temporary contact.
WheelRailSolution solve_wheel_rail(const WheelRailSetup& setup, const WheelRailState& state, Observer& observer);

/// Solves both wheels of a wheelset with free roll: at the height and roll for the prescribed force of each, with
/// heights that agree to `height_tolerance` (mm). Set-ups are those of one left and one right wheel. Throws as
/// WheelRailContact::solve, and InvalidArgument ("Fz_left", "left", ...).
WheelsetSolution solve_wheelset(const WheelRailContact& left, const WheelRailContact& right, const WheelsetState& state,
                                Observer& observer, double height_tolerance = 1e-6);
/// Solves both wheels within the tolerances, from the end of the previous step.
WheelsetSolution solve_wheelset(const WheelRailContact& left, const WheelRailContact& right, const WheelsetState& state,
                                WheelsetEstimates& estimates, Observer& observer, double height_tolerance = 1e-6);

}  // namespace contactd
