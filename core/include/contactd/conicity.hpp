// The equivalent conicity of a wheelset on a track, as plain values: that of the cones on which it would roll with the
// same wavelength.
#pragma once

#include <vector>

namespace contactd {

/// The roll of the wheelset: as both contacts demand, or none, where each wheel finds its own height.
enum class WheelsetRoll { demanded, neglected };

struct ConicitySettings {
    /// Without roll a cone has its own conicity; with it, one that also depends on radii and distances.
    WheelsetRoll roll = WheelsetRoll::neglected;
    double contact_distance = 1500;  ///< between the contact points of both wheels, 2e (mm)
    double tolerance = 1e-3;         ///< of the radius difference between the shifts at which it is computed (mm)

    bool operator==(const ConicitySettings&) const = default;
};

/// Conicities that are wanted.
struct ConicityRequest {
    std::vector<double> amplitudes;  ///< (mm)
    ConicitySettings settings{};

    bool operator==(const ConicityRequest&) const = default;
};

struct EquivalentConicity {
    double amplitude = 0;   ///< half of the way from side to side (mm)
    double integrated = 0;  ///< from the wavelength of the kinematic motion; not a number where this does not swing
    double harmonic = 0;    ///< the first harmonic of the radius difference
    double wavelength = 0;  ///< of the kinematic motion (mm)
};

}  // namespace contactd
