// Defines the load of a step: position and motion of the bodies, and the initial state of the step.
#pragma once

#include <optional>
#include <vector>

#include "contactd/friction.hpp"
#include "contactd/gap.hpp"

namespace contactd {

/// Holds the pressure and the tractions on the upper body, each empty (zero) or of shape [ny, nx] (N/mm^2).
struct SurfaceState {
    std::vector<double> pressure, traction_x, traction_y;
    /// Holds the yield stress of a layer that hardens or softens, in the same form; empty means that it has not flowed
    /// yet. It is not needed for estimates.
    std::vector<double> yield_stress{};
    std::vector<double> friction_coefficient{};  ///< for friction with memory, in the same form; empty: the static
                                                 ///< coefficient

    bool empty() const { return pressure.empty() && traction_x.empty() && traction_y.empty(); }
    bool operator==(const SurfaceState&) const = default;
};

struct ContactLoad {
    std::optional<Gap> gap;  ///< undeformed distance h without the approach
    /// Exactly one of these two is prescribed. The approach is delta (mm), with the gap before deformation h - delta.
    /// With a prescribed normal force (N, >= 0), the approach is computed.
    std::optional<double> approach, Fn;
    Motion motion{};  ///< not used without friction
    /// Holds the rigid slip of each element in addition to that of `motion`, for surfaces that do not move like a
    /// plane. For a shift it is a distance in the step (mm); for rolling it is per distance rolled, like creepages.
    /// Both are empty, or both have shape [ny, nx].
    RigidSlip rigid_slip{};
    /// Speed at which the upper surface passes through the contact (mm/s), for temperatures of wheels on rails. If
    /// absent, the speed is that of TemperatureRequest.
    std::optional<double> upper_speed{};
    SurfaceState previous;       ///< at the end of the previous step, where a shift or a transient step starts
    SurfaceState initial;        ///< initial estimates of the solvers
    bool derivatives = false;    ///< whether the solution includes them
    bool displacements = false;  ///< whether the solution includes displacements and the elastic energy
};

/// Throws InvalidArgument ("approach" or "Fn") unless exactly one of them is prescribed.
void require_load(const ContactLoad& load);

}  // namespace contactd
