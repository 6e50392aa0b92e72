// Computes the equivalent conicity of a wheelset on a track. Cones of this conicity roll with the same wavelength.
#pragma once

#include <span>
#include <vector>

#include "contactd/conicity.hpp"
#include "contactd/observer.hpp"
#include "contactd/wheelset_contacts.hpp"

namespace contactd {

/// Computes the conicity for amplitudes in two ways:
/// - The kinematic motion y'' = -dr(y)/(2e r0) along the track has the wavelength L(A), found from its energy integral;
///   e r0 (2 pi/L)^2 is the conicity (EN 15302).
/// - The harmonic approximation is 1/(pi A) times the integral of dr/2(A sin t) sin t over a turn.
/// dr is the right wheel's radius minus the left one's, and r0 the mean of the nominal radii. If both sides differ, the
/// wheelset oscillates about the position where dr = 0, which is searched up to 32 mm from the middle of the track. If
/// dr vanishes over the whole motion, the conicity is zero. Throws InvalidArgument for amplitudes that are not positive
/// or reach beyond the profiles and for rollers ("left.track.roller_radius"), and Cancelled.
std::vector<EquivalentConicity> equivalent_conicities(const WheelsetOnTrack& wheelset,
                                                      std::span<const double> amplitudes,
                                                      const ConicitySettings& settings = {},
                                                      const Observer& observer = Observer());

}  // namespace contactd
