// The height of a wheelset at which a wheel presses on its rail with a given force.
#pragma once

#include <functional>
#include <optional>

#include "contactd/contact.hpp"
#include "contactd/wheel_rail_estimates.hpp"

namespace contactd {

/// Forces rise with z, but where patches merge they may fall, and several heights bring the target: then the one
/// nearest to where the correction leads at first. The estimate is cheap and close to the shape of the force: what is
/// left is nearly constant.
struct HeightTask {
    std::function<double(double z)> estimate;  ///< (N), zero above `first_contact_height`
    std::function<double(double& z)> force;  ///< likewise; it may move z by little to where it is nearer to the target
    double first_contact_height = 0;         ///< z of first contact (mm)
    double deepest = 0;                      ///< largest z that makes sense (mm)
    double target = 0;                       ///< (N), > 0
    SolverSettings settings;
    HeightCorrection correction{};  ///< as an earlier search has found it
    /// Stiffness of a spring below the rail (N/mm): z is that of the wheel over the rail, and the target force falls by
    /// so much with it, from `target` where they touch.
    double spring = 0;
    std::optional<double> shallowest{};  ///< least z that is looked at (mm); absent: that of first contact
};

struct HeightFound {
    double z = 0;  ///< where the force was computed last
    SolverEvidence evidence;
    HeightCorrection correction{};
    bool falls = false;  ///< the force was less at one height than at another above it
    /// Forces (N) on both sides of the height, where they jump over the target there: they were computed less than
    /// 1e-6 mm apart.
    struct Jump {
        double above, below;
    };
    std::optional<Jump> jump{};
};

/// Stops, without convergence, where the force is a thousand times the target although the estimate was corrected.
HeightFound find_height(const HeightTask& task);

}  // namespace contactd
