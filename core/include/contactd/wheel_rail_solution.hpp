// Defines the contact of a wheel with its rail: places, patches and forces.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "contactd/contact.hpp"

namespace contactd {

/// Describes the reference of a contact, on the rail in track coordinates (mm). Contact coordinates have their origin
/// there: x forwards, y along the rail's surface to the right, z = n into the rail. They are those of the track rotated
/// about x by the angle of the plane (rad).
struct ContactReference {
    double x = 0, y = 0, z = 0;
    double angle = 0;

    bool operator==(const ContactReference&) const = default;
};

/// Describes the axes of a profile in track coordinates: its origin (mm), and the rotations of the track's axes, about
/// z from x to y first, and then about x from y to z (rad).
struct ProfileFrame {
    double x = 0, y = 0, z = 0;
    double roll = 0, yaw = 0;

    bool operator==(const ProfileFrame&) const = default;
};

/// Describes a point of the rail: its position along the track, and its arc length across from y = 0 of the profile
/// (mm) or, if the profile doubles back, from the profile's point nearest to the origin.
struct RailPlace {
    double along = 0, across = 0;

    bool operator==(const RailPlace&) const = default;
};

/// Describes a region where the undeformed profiles overlap, seen from above. Patches consist of such regions.
struct OverlapRegion {
    ContactReference reference;
    Extent x, y, z;          ///< in track coordinates; z on the rail at the ends of y
    double penetration = 0;  ///< largest vertical overlap (mm)
    double size = 0;         ///< integral of the squared vertical penetration over the region (mm^4)

    bool operator==(const OverlapRegion&) const = default;
};

/// Holds the velocities of the rail at the reference relative to the wheel, over the rolling velocity (mm/s), in
/// contact coordinates. chi is the rolling direction: 0 forwards, pi backwards. In a shift they are over 1 mm/s, so
/// that their product with the time step is the rigid shift (mm, rad).
struct Creepages {
    double xi = 0, eta = 0;
    double phi = 0;  ///< (rad/mm)
    double chi = 0, velocity = 0;

    bool operator==(const Creepages&) const = default;
};

/// Holds the radii of curvature at the reference (mm) of wheel and rail, along and across the track. They are positive
/// where convex, infinite where straight.
struct ContactRadii {
    static constexpr double straight = std::numeric_limits<double>::infinity();
    double wheel_along = straight, wheel_across = straight;
    double rail_along = straight, rail_across = straight;

    bool operator==(const ContactRadii&) const = default;
};

/// Describes a row of elements of a contact that is curved across the track: its middle, half-way between rail and
/// wheel (mm, in track coordinates), and its inclination (rad). The axes of its elements are rotated about x by it.
struct ContactRow {
    double y = 0, z = 0;
    double angle = 0;

    bool operator==(const ContactRow&) const = default;
};

/// Describes a place where wheel and rail are in contact, and its contact problem.
struct ContactPlace {
    ContactReference reference;
    RailPlace on_rail;                   ///< the reference as a point of the rail
    std::vector<OverlapRegion> regions;  ///< from right to left; several have a weighted interaction
    /// Holds the weight of region j on region k, symmetric, row by row: the fraction of the displacements of one that
    /// acts on the other. It is 1 on the diagonal.
    std::vector<double> shares;
    Grid grid;  ///< in contact coordinates; in a curved contact y is the arc length from the reference
    std::vector<ContactRow> rows;  ///< rows of the grid of a curved contact; empty if it is plane
    double approach = 0;           ///< largest penetration along n at the elements (mm)
    double penetration = 0;        ///< largest vertical penetration (mm)
    Creepages creepages;
    ContactRadii radii;
};

/// Holds a force (N) and its moment (N mm) about the origin of its axes.
struct Wrench {
    double Fx = 0, Fy = 0, Fz = 0;
    double Mx = 0, My = 0, Mz = 0;

    bool operator==(const Wrench&) const = default;
};

/// Holds forces on the rail, which follow its slope along the track according to WheelRailSetup::slope_forces.
struct WheelRailForces {
    Wrench track;     ///< in track coordinates
    Wrench rail;      ///< about the origin of the rail's profile, along its axes
    Wrench wheelset;  ///< about the wheelset's centre, along its axes, which do not rotate with its pitch
};

struct WheelRailPatch {
    ContactPlace place;
    std::vector<double>
        gap;  ///< undeformed distance h minus its smallest value (mm), shape [ny, nx]; empty for simplified models
    ContactSolution solution;  ///< in contact coordinates
    WheelRailForces forces;
};

/// Holds the results of the profiles and a position without a solve.
struct WheelRailGeometry {
    double z = 0;                          ///< of the wheelset (mm)
    ProfileFrame wheel_frame, rail_frame;  ///< at this z
    std::vector<ContactPlace> places;      ///< from right to left; empty if wheel and rail do not overlap
    /// This is the smallest vertical distance of wheel and rail (mm), negative where they overlap. It is absent if they
    /// are not above each other.
    std::optional<double> clearance;
    std::vector<std::string> warnings;
};

/// Holds the derivatives of the forces on the rail in track coordinates with respect to the state. Units are those of a
/// wrench over those of the input. All other inputs are fixed, including height and pitch rate found from forces; a
/// flexible rail deflects.
struct WheelRailDerivatives {
    struct ByPosition {
        Wrench y, z, roll, yaw;

        bool operator==(const ByPosition&) const = default;
    } position;
    struct ByVelocity {
        Wrench x, y, z, roll, yaw, pitch;

        bool operator==(const ByVelocity&) const = default;
    } velocity;

    bool operator==(const WheelRailDerivatives&) const = default;
};

/// Describes the deflection of a massless flexible rail, in addition to its deviation (mm, in track coordinates).
struct RailDeflection {
    double y = 0, z = 0;

    bool operator==(const RailDeflection&) const = default;
};

/// Summarises the patches that an answer omits because its step requested this (WheelRailStepInput::patches).
struct PatchesLeftOut {
    std::size_t count = 0;
    bool converged = true;                     ///< whether they converged, including the searches
    std::optional<double> frictional_power{};  ///< of all (N mm/s)
};

struct WheelRailSolution {
    double z = 0;                                ///< height of the wheelset, prescribed or computed (mm)
    double pitch_rate = 0;                       ///< pitch rate of the wheelset, prescribed or computed (rad/s)
    ProfileFrame wheel_frame;                    ///< at this z, with the wheel's deviation
    ProfileFrame rail_frame;                     ///< with the rail's deviation and deflection; for a roller, at its top
    std::optional<double> clearance;             ///< at this z, as in WheelRailGeometry
    std::vector<WheelRailPatch> patches;         ///< from right to left; empty without contact
    std::optional<PatchesLeftOut> left_out;      ///< for an answer without patches
    WheelRailForces forces;                      ///< of all patches
    std::optional<SolverEvidence> force;         ///< evidence of the search for z: solves, |F - Fz|/Fz
    std::optional<SolverEvidence> pitch_search;  ///< for Fx: searches for z, or solves; |F - Fx|/Fz
    std::optional<RailDeflection> rail_deflection;  ///< of a flexible rail
    /// Describes the search for the deflection of a flexible rail: the number of solves, and the remaining imbalance of
    /// its forces, |Fy + rail.Fy - track.springs.y y|/Fz or that of z, whichever is larger.
    std::optional<SolverEvidence> rail_search;
    /// Estimates the deviation of forces (relative to Fn) and largest pressures and tractions (relative to these) from
    /// those of a fresh solve with tight tolerances at this height. It is only available for boundary elements with
    /// contact.
    std::optional<double> accuracy;
    std::optional<WheelRailDerivatives> derivatives;  ///< if requested and converged, with contact
    std::vector<std::string> warnings;                ///< including those of the patches

    std::size_t contacts() const { return left_out ? left_out->count : patches.size(); }
    bool in_contact() const { return contacts() > 0; }
    /// Returns the power dissipated by friction in all patches (N mm/s); absent if no patch rolls with friction.
    std::optional<double> frictional_power() const {
        if (left_out) return left_out->frictional_power;
        std::optional<double> sum;
        for (const WheelRailPatch& patch : patches)
            if (patch.solution.frictional_power) sum = sum.value_or(0) + *patch.solution.frictional_power;
        return sum;
    }
    bool converged() const {
        if (left_out) return left_out->converged;
        for (const WheelRailPatch& patch : patches)
            if (!patch.solution.converged()) return false;
        return !(force && !force->converged) && !(pitch_search && !pitch_search->converged) &&
               !(rail_search && !rail_search->converged);
    }
};

struct WheelsetSolution {
    double z = 0, roll = 0;  ///< computed, of the wheelset (mm, rad); z is relative to the mean of both nominal radii
    WheelRailSolution left, right;
    SolverEvidence roll_search;         ///< solves of both wheels, and the remaining difference of their heights (mm)
    std::vector<std::string> warnings;  ///< about both wheels together; each wheel has its own, too

    bool converged() const { return left.converged() && right.converged() && roll_search.converged; }
};

}  // namespace contactd
