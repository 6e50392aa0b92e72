// Computes the gradient of a number by the profiles and the state of a right wheel from that by its contact problems.
#pragma once

#include <vector>

#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_state.hpp"
#include "geometry/adjoint/pair_cotangent.hpp"

namespace contactd::geometry {

/// Selects what happens to the elements of a patch when its reference moves. `exact` moves them, too, as the solver
/// does; such gradients agree with differences of solves, but contain the noise of the discretisation. `design` holds
/// them on the rail, so that gradients carry over the steps of an optimisation.
enum class GradientMode { exact, design };

/// Holds the gradient by the contact problem of a place.
struct ByPlace {
    /// By the distance of rail and wheel at each element, shape [ny, nx]: by the gap at a constant approach. That by
    /// the approach is minus its sum, and has no entry of its own.
    std::vector<double> distance;
    Creepages creepages{0, 0, 0, 0, 0};  ///< by xi, eta, phi and velocity; chi is ignored
    double mu = 0;                       ///< by the coefficient of friction, which may depend on the angle
    ContactReference reference{};        ///< by the plane in other ways, such as the direction of its forces
};

/// Holds the gradient by the points of both curves, and in the state by position y, z, roll and yaw, the velocities,
/// and the deviations of wheel and rail.
struct WheelGradient {
    std::vector<ProfilePoint> wheel, rail;
    WheelRailState state;
};

/// Throws InvalidArgument, which names the field, for set-ups and states whose gradients are not supported: rollers,
/// slices, curved contacts, meshes, simplified models, rigid slip by surfaces, friction that varies along the profile,
/// and steps that are not steady.
void check_gradient(const WheelRailSetup& setup, const WheelRailState& state);

class PlaceGradient {
   public:
    /// The wheel stands at the height of the solution. All arguments must outlive this object. Throws as
    /// check_gradient.
    PlaceGradient(const WheelRailSetup& setup, const WheelRailState& state, const WheelSurface& wheel,
                  const RailSurface& rail, GradientMode mode);

    /// Adds the gradient by a measured place with plane elements. The weights of several regions on each other are
    /// held.
    void add(const ContactPlace& place, const ByPlace& by);
    /// Without track.rail_origin, the points of the rail also move its origin.
    WheelGradient result() const;

   private:
    const WheelRailSetup& setup_;
    const WheelRailState& state_;
    const WheelSurface& wheel_;
    const RailSurface& rail_;
    GradientMode mode_;
    PairCotangent sum_;
    BodyCotangent wheelset_;
    WheelRailState by_velocities_;
};

}  // namespace contactd::geometry
