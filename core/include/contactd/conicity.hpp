// A rigid wheelset on rigid rails, as plain values: its contacts, and its equivalent conicity, that of the cones on
// which it would roll with the same wavelength. Lengths in mm, angles in rad; track coordinates have y to the right, z
// down.
#pragma once

#include <vector>

#include "contactd/profile_evidence.hpp"
#include "contactd/profile_spec.hpp"

namespace contactd {

/// The roll of the wheelset: as both contacts require, or neglected, with a separate height of each wheel.
enum class WheelsetRoll { demanded, neglected };

struct ConicitySettings {
    /// Without roll, the conicity of a cone is exact; with it, it also depends on radii and distances.
    WheelsetRoll roll = WheelsetRoll::neglected;
    double contact_distance = 1500;  ///< between the contact points of both wheels, 2e (mm)
    double tolerance = 1e-3;         ///< of the radius difference between the shifts at which it is computed (mm)

    bool operator==(const ConicitySettings&) const = default;
};

/// A contact of a rigid wheel with a rigid rail.
struct RigidContact {
    double y = 0, z = 0;  ///< in track coordinates
    double angle = 0;     ///< of the rail's tangent there, atan2(dz, dy): negative at the right wheel's flange
    double radius = 0;    ///< of the wheel there
    double height = 0;    ///< z of the wheelset, relative to wheels that touch z = 0 with this nominal radius
    double wheel_y = 0, rail_y = 0;  ///< in the profiles; the rail's as the cant turns it
    bool at_end = false;             ///< of the wheel's or the rail's profile, reached before the bodies separate

    bool operator==(const RigidContact&) const = default;
};

/// The contacts of both wheels.
struct WheelsetContacts {
    double shift = 0, roll = 0;
    RigidContact left, right;

    double radius_difference() const { return right.radius - left.radius; }
    bool operator==(const WheelsetContacts&) const = default;
};

/// Requested contacts.
struct ContactsRequest {
    std::vector<double> shifts;  ///< of the wheelset to the right (mm)
    WheelsetRoll roll = WheelsetRoll::neglected;

    bool operator==(const ContactsRequest&) const = default;
};

/// The points through which the curves of a side go, in the coordinates of the profiles; the rail's as the cant turns
/// it.
struct PlacedProfiles {
    std::vector<ProfilePoint> wheel, rail;
    double wheel_origin = 0;     ///< from the middle of the axle to y = 0 of the wheel's profile
    ProfilePoint rail_origin{};  ///< from the middle of the track
    ProfileEvidence wheel_evidence{}, rail_evidence{};

    bool operator==(const PlacedProfiles&) const = default;
};

/// Profiles of both sides, each as if it were a right one.
struct ProfilesOfSides {
    PlacedProfiles left, right;

    bool operator==(const ProfilesOfSides&) const = default;
};

/// Requested conicities.
struct ConicityRequest {
    std::vector<double> amplitudes;  ///< (mm)
    ConicitySettings settings{};

    bool operator==(const ConicityRequest&) const = default;
};

struct EquivalentConicity {
    double amplitude = 0;   ///< half of the lateral motion (mm)
    double integrated = 0;  ///< from the wavelength of the kinematic motion; NaN without oscillation
    double harmonic = 0;    ///< the first harmonic of the radius difference; NaN without a centre
    double wavelength = 0;  ///< of the kinematic motion (mm); infinite without a radius difference
};

}  // namespace contactd
