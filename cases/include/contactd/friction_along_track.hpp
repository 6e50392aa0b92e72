// Describes friction that varies along the track, as in the CONTACT program (V = 2).
#pragma once

#include <optional>
#include <vector>

namespace contactd {

/// Holds the numbers of a friction law L at a place (mm), in the order of CONTACT's files: FSTAT FKIN (L = 0); FKIN F1
/// SABSH1 F2 SABSH2 (L = 2, 3, 4); FREF TREF DFHEAT DTHEAT (L = 6). More numbers may follow, such as MEMDST MEM_S0.
struct ContactFrictionAtPlace {
    double place = 0;
    std::vector<double> values;
};

/// Interpolates each number linearly between places, which must increase. Beyond them it is constant.
std::vector<double> friction_along_track(const std::vector<ContactFrictionAtPlace>& track, double place);

/// Names two neighbouring places (mm), and the difference of their friction coefficients.
struct ThinFriction {
    double from = 0, to = 0;
    double difference = 0;
};

/// Returns the places around `place` if interpolation between them is uncertain: they are more than 3 m apart, about a
/// revolution of a wheel, and at some slip velocity or temperature their coefficients differ by more than 0.1.
std::optional<ThinFriction> thin_friction(int law, const std::vector<ContactFrictionAtPlace>& track, double place);

}  // namespace contactd
