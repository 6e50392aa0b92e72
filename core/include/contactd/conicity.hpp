// Defines the contacts and the equivalent conicity of a rigid wheelset on rigid rails as plain values. Cones of the
// equivalent conicity roll with the same wavelength as the wheelset. Lengths are in mm, angles in rad; in track
// coordinates y is to the right and z down.
#pragma once

#include <vector>

#include "contactd/profile_evidence.hpp"
#include "contactd/profile_spec.hpp"

namespace contactd {

/// Selects the roll of the wheelset: as both contacts require, or neglected, with a separate height of each wheel.
enum class WheelsetRoll { demanded, neglected };

struct ConicitySettings {
    /// Without roll, the conicity of a cone is exact. With roll, it also depends on the radii and the distances.
    WheelsetRoll roll = WheelsetRoll::neglected;
    double contact_distance = 1500;  ///< distance between the contact points of both wheels, 2e (mm)
    double tolerance = 1e-3;         ///< tolerance of the radius difference between the shifts at which it is computed
                                     ///< (mm)

    bool operator==(const ConicitySettings&) const = default;
};

/// Describes a contact of a rigid wheel with a rigid rail.
struct RigidContact {
    double y = 0, z = 0;  ///< in track coordinates
    double angle = 0;     ///< angle of the rail's tangent at the contact, atan2(dz, dy): negative at the right wheel's
                          ///< flange
    double radius = 0;    ///< radius of the wheel at the contact
    double height = 0;    ///< z of the wheelset, relative to wheels that touch z = 0 with this nominal radius
    double wheel_y = 0, rail_y = 0;  ///< in the coordinates of the profiles; the rail is rotated by its cant
    bool at_end = false;             ///< whether the contact is at the end of a profile, reached before the bodies
                                     ///< separate

    bool operator==(const RigidContact&) const = default;
};

/// Describes the contacts of both wheels.
struct WheelsetContacts {
    double shift = 0, roll = 0;
    RigidContact left, right;

    double radius_difference() const { return right.radius - left.radius; }
    bool operator==(const WheelsetContacts&) const = default;
};

/// Requests contacts at a list of shifts.
struct ContactsRequest {
    std::vector<double> shifts;  ///< shifts of the wheelset to the right (mm)
    WheelsetRoll roll = WheelsetRoll::neglected;

    bool operator==(const ContactsRequest&) const = default;
};

/// Holds the points that the curves of one side pass through, in the coordinates of the profiles. The rail is rotated
/// by its cant.
struct PlacedProfiles {
    std::vector<ProfilePoint> wheel, rail;
    double wheel_origin = 0;     ///< distance from the middle of the axle to y = 0 of the wheel's profile
    ProfilePoint rail_origin{};  ///< position relative to the middle of the track
    ProfileEvidence wheel_evidence{}, rail_evidence{};

    bool operator==(const PlacedProfiles&) const = default;
};

/// Holds the profiles of both sides, each as if it were the right one.
struct ProfilesOfSides {
    PlacedProfiles left, right;

    bool operator==(const ProfilesOfSides&) const = default;
};

/// Requests conicities at a list of amplitudes.
struct ConicityRequest {
    std::vector<double> amplitudes;  ///< half of the lateral motion (mm)
    ConicitySettings settings{};

    bool operator==(const ConicityRequest&) const = default;
};

struct EquivalentConicity {
    double amplitude = 0;   ///< half of the lateral motion (mm)
    double integrated = 0;  ///< computed from the wavelength of the kinematic motion; NaN without oscillation
    double harmonic = 0;    ///< computed from the first harmonic of the radius difference; NaN without a centre
    double wavelength = 0;  ///< length of the kinematic motion (mm); infinite without a radius difference
};

}  // namespace contactd
