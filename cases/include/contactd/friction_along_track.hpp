// Friction that the program CONTACT varies along the track (V = 2).
#pragma once

#include <optional>
#include <vector>

namespace contactd {

/// The numbers of a friction law L at a place (mm), in the order of CONTACT's files: FSTAT FKIN (L = 0); FKIN F1 SABSH1
/// F2 SABSH2 (L = 2, 3, 4); FREF TREF DFHEAT DTHEAT (L = 6). More may follow, such as MEMDST MEM_S0.
struct ContactFrictionAtPlace {
    double place = 0;
    std::vector<double> values;
};

/// Interpolates each number linearly between places, which ascend; it is constant beyond them.
std::vector<double> friction_along_track(const std::vector<ContactFrictionAtPlace>& track, double place);

/// Two neighbouring places (mm), and by how much their coefficients of friction differ.
struct ThinFriction {
    double from = 0, to = 0;
    double difference = 0;
};

/// Returns the places around `place` if a straight line between their friction is a guess: more than 3 m, a revolution
/// of a wheel, lie between them, and at some slip velocity, or temperature, coefficients differ by more than 0.1.
std::optional<ThinFriction> thin_friction(int law, const std::vector<ContactFrictionAtPlace>& track, double place);

}  // namespace contactd
