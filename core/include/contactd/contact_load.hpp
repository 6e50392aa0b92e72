// The load of a step: where the bodies are, how they move, and where the step starts from.
#pragma once

#include <optional>
#include <vector>

#include "contactd/friction.hpp"
#include "contactd/gap.hpp"

namespace contactd {

/// Pressure and tractions on the upper body, each empty (zero) or of shape [ny, nx] (N/mm^2).
struct SurfaceState {
    std::vector<double> pressure, traction_x, traction_y;
    /// A layer that hardens or softens has it, likewise; empty: it has not flowed yet. Estimates need none.
    std::vector<double> yield_stress{};
    std::vector<double> friction_coefficient{};  ///< with memory, likewise; empty: the static one

    bool empty() const { return pressure.empty() && traction_x.empty() && traction_y.empty(); }
    bool operator==(const SurfaceState&) const = default;
};

struct ContactLoad {
    std::optional<Gap> gap;  ///< undeformed distance h without the approach
    /// Either of these two. The approach is delta (mm), the gap before deformation h - delta; with the normal force
    /// (N, >= 0) prescribed instead it is found.
    std::optional<double> approach, Fn;
    Motion motion{};  ///< of no meaning without friction
    /// Rigid slip of each element beside that of `motion`, where the bodies' surfaces are not those of a plane motion:
    /// of a shift over the step (mm), of rolling over the distance rolled, as creepages are. Empty, or both of shape
    /// [ny, nx].
    RigidSlip rigid_slip{};
    SurfaceState previous;       ///< at the end of the step before, where a shift or a transient step starts
    SurfaceState initial;        ///< estimates, where the solvers start
    bool derivatives = false;    ///< whether the solution has those
    bool displacements = false;  ///< whether the solution has those of the surfaces, and the elastic energy
};

/// Throws InvalidArgument ("approach" or "Fn") unless one of the two is prescribed, and only one.
void require_load(const ContactLoad& load);

}  // namespace contactd
