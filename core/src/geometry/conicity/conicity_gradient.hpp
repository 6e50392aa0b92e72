// Computes the gradient of the harmonic conicity by the profiles of a wheelset on its track.
#pragma once

#include <vector>

#include "contactd/conicity.hpp"
#include "contactd/equivalent_conicity.hpp"
#include "contactd/observer.hpp"
#include "contactd/wheelset_contacts.hpp"

namespace contactd::geometry {

/// Holds the gradient (1/mm) by the points of the curves of one side, and by y and z of its rail's origin. Points of
/// the rail are those of WheelOverRail, which are rotated by the cant.
struct SideGradient {
    std::vector<ProfilePoint> wheel, rail;
    ProfilePoint rail_origin;
};
struct ConicityGradient {
    double harmonic = 0;  ///< the conicity itself, by the quadrature of the gradient
    SideGradient left, right;
};

/// Returns the gradient of the harmonic conicity at an amplitude (mm). Between leaps of the contact point, the radius
/// changes by psi + z' (psi_r' - psi_w')/(z_w'' - z_r'') at the contact, with psi the changes of heights. A leap moves
/// by the difference of the changes of both gaps over that of the slopes, and its jump of the radius counts. Throws
/// InvalidArgument ("settings.roll") unless roll is neglected, for which the gradient is exact, ("amplitudes[0]") as
/// equivalent_conicities and where there is no oscillation, and Cancelled. The conicity of EN 15302 has no gradient.
ConicityGradient harmonic_gradient(const WheelsetOnTrack& wheelset, double amplitude,
                                   const ConicitySettings& settings = {}, const Observer& observer = Observer());

/// Returns the gradient by the points of a rail's curve without cant, which also move its origin unless the track gives
/// it. `side` is one of the sides whose rail this is.
std::vector<ProfilePoint> by_rail_points(const SideGradient& side, const ProfileCurve& rail, const Track& track);

}  // namespace contactd::geometry
