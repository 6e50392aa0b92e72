// Searches for the height of a wheelset at which a wheel exerts a given force on its rail.
#pragma once

#include <functional>
#include <optional>

#include "contactd/contact.hpp"
#include "contactd/wheel_rail_estimates.hpp"

namespace contactd {

/// Forces increase with z, but may decrease if patches merge. Then several heights produce the target, and the search
/// finds the one nearest to the first correction. The estimate is cheap and has nearly the shape of the force, so the
/// difference is nearly constant.
struct HeightTask {
    std::function<double(double z)> estimate;  ///< (N), zero above `first_contact_height`
    std::function<double(double& z)> force;    ///< likewise; it may change z slightly to approach the target
    double first_contact_height = 0;           ///< z of first contact (mm)
    double deepest = 0;                        ///< largest useful z (mm)
    double target = 0;                         ///< (N), > 0
    SolverSettings settings;
    HeightCorrection correction{};  ///< result of an earlier search
    /// If > 0, this is the stiffness of a spring below the rail (N/mm). z is then the height of the wheel over the
    /// rail, and the target force decreases with z by this stiffness, from `target` at first contact.
    double spring = 0;
    std::optional<double> shallowest{};  ///< least z of the search (mm); absent: that of first contact
};

struct HeightFound {
    double z = 0;  ///< height of the last computed force
    SolverEvidence evidence;
    HeightCorrection correction{};
    bool falls = false;  ///< whether the force was less at one height than at another above it
    /// Forces (N) on both sides of the height if they jump across the target there, computed less than 1e-6 mm apart.
    struct Jump {
        double above, below;
    };
    std::optional<Jump> jump{};
};

/// Searches the height. Stops without convergence if the force is a thousand times the target although the estimate was
/// corrected.
HeightFound find_height(const HeightTask& task);

}  // namespace contactd
