// The contact of a wheel with its rail: places, patches and forces.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "contactd/contact.hpp"

namespace contactd {

/// The reference of a contact, on the rail in track coordinates (mm). Contact coordinates have their origin there: x
/// forwards, y along the rail's surface to the right, z = n into the rail. They are those of the track rotated about x
/// by the angle of the plane (rad).
struct ContactReference {
    double x = 0, y = 0, z = 0;
    double angle = 0;

    bool operator==(const ContactReference&) const = default;
};

/// The axes of a profile in track coordinates: its origin (mm), and the rotations of the track's axes, about z from x
/// to y first, and then about x from y to z (rad).
struct ProfileFrame {
    double x = 0, y = 0, z = 0;
    double roll = 0, yaw = 0;

    bool operator==(const ProfileFrame&) const = default;
};

/// A point of the rail: along the track, and arc length across from y = 0 of its profile (mm) or, if the profile
/// doubles back, from its point nearest to the origin.
struct RailPlace {
    double along = 0, across = 0;

    bool operator==(const RailPlace&) const = default;
};

/// A region where the undeformed profiles overlap, seen from above. Patches consist of such regions.
struct OverlapRegion {
    ContactReference reference;
    Extent x, y, z;          ///< in track coordinates; z on the rail at the ends of y
    double penetration = 0;  ///< largest vertical overlap (mm)
    double size = 0;         ///< the integral over the region of the vertical penetration squared (mm^4)

    bool operator==(const OverlapRegion&) const = default;
};

/// Velocities of the rail at the reference relative to the wheel, over the rolling velocity (mm/s), in contact
/// coordinates. chi is the rolling direction: 0 forwards, pi backwards. In a shift they are over 1 mm/s, so that their
/// product with the time step is the rigid shift (mm, rad).
struct Creepages {
    double xi = 0, eta = 0;
    double phi = 0;  ///< (rad/mm)
    double chi = 0, velocity = 0;

    bool operator==(const Creepages&) const = default;
};

/// Radii of curvature at the reference (mm): of the wheel and the rail across the track, of both along it. Positive
/// where convex; infinite where straight.
struct ContactRadii {
    static constexpr double straight = std::numeric_limits<double>::infinity();
    double wheel_along = straight, wheel_across = straight;
    double rail_along = straight, rail_across = straight;

    bool operator==(const ContactRadii&) const = default;
};

/// A row of elements of a contact that is curved across the track: its middle, half-way between rail and wheel (mm, in
/// track coordinates), and its inclination (rad). The axes of its elements are rotated about x by it.
struct ContactRow {
    double y = 0, z = 0;
    double angle = 0;

    bool operator==(const ContactRow&) const = default;
};

/// A place where wheel and rail are in contact, and its contact problem.
struct ContactPlace {
    ContactReference reference;
    RailPlace on_rail;                   ///< the reference
    std::vector<OverlapRegion> regions;  ///< from right to left; several have a weighted interaction
    /// Weight of region j on region k, symmetric, row by row: the fraction of the displacements of one that acts on the
    /// other; 1 on the diagonal.
    std::vector<double> shares;
    Grid grid;  ///< in contact coordinates; in a curved contact y is the arc length from the reference
    std::vector<ContactRow> rows;  ///< of the grid of a curved contact; empty if it is plane
    double approach = 0;           ///< penetration along n, the largest at the elements (mm)
    double penetration = 0;        ///< vertical, the largest (mm)
    Creepages creepages;
    ContactRadii radii;
};

/// A force (N) and its moment (N mm) about the origin of its axes.
struct Wrench {
    double Fx = 0, Fy = 0, Fz = 0;
    double Mx = 0, My = 0, Mz = 0;

    bool operator==(const Wrench&) const = default;
};

/// Forces act on the rail, and follow its slope along the track according to WheelRailSetup::slope_forces.
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

/// Results of the profiles and a position without a solve.
struct WheelRailGeometry {
    double z = 0;                          ///< of the wheelset (mm)
    ProfileFrame wheel_frame, rail_frame;  ///< at this z
    std::vector<ContactPlace> places;      ///< from right to left; empty if wheel and rail do not overlap
    /// Smallest vertical distance of wheel and rail (mm), negative where they overlap; absent if they are not above
    /// each other.
    std::optional<double> clearance;
    std::vector<std::string> warnings;
};

/// Derivatives of the forces on the rail in track coordinates by the state. Units are those of a wrench over those of
/// the input. All other inputs are fixed, also height and pitch rate found from forces; a flexible rail deflects.
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

/// Deflection of a massless flexible rail, in addition to its deviation (mm, in track coordinates).
struct RailDeflection {
    double y = 0, z = 0;

    bool operator==(const RailDeflection&) const = default;
};

/// Summary of the patches that an answer omits because its step requested this (WheelRailStepInput::patches).
struct PatchesLeftOut {
    std::size_t count = 0;
    bool converged = true;                     ///< including the searches
    std::optional<double> frictional_power{};  ///< of all (N mm/s)
};

struct WheelRailSolution {
    double z = 0;                                ///< of the wheelset, prescribed or computed (mm)
    double pitch_rate = 0;                       ///< of the wheelset, prescribed or computed (rad/s)
    ProfileFrame wheel_frame;                    ///< at this z, with the wheel's deviation
    ProfileFrame rail_frame;                     ///< with the rail's deviation and deflection; for a roller at its top
    std::optional<double> clearance;             ///< at this z, as in WheelRailGeometry
    std::vector<WheelRailPatch> patches;         ///< from right to left; empty without contact
    std::optional<PatchesLeftOut> left_out;      ///< for an answer without patches
    WheelRailForces forces;                      ///< of all patches
    std::optional<SolverEvidence> force;         ///< of the search for z: solves, |F - Fz|/Fz
    std::optional<SolverEvidence> pitch_search;  ///< for Fx: searches for z, or solves; |F - Fx|/Fz
    std::optional<RailDeflection> rail_deflection;  ///< of a flexible rail
    /// Search for the deflection of a flexible rail: number of solves, and the remaining imbalance of its forces,
    /// |Fy + rail.Fy - track.springs.y y|/Fz or that of z, whichever is larger.
    std::optional<SolverEvidence> rail_search;
    /// Estimate of the deviation of forces (relative to Fn) and largest pressures and tractions (relative to these)
    /// from those of a fresh solve with tight tolerances at this height. Only for boundary elements with contact.
    std::optional<double> accuracy;
    std::optional<WheelRailDerivatives> derivatives;  ///< if requested and converged, with contact
    std::vector<std::string> warnings;                ///< including those of the patches

    std::size_t contacts() const { return left_out ? left_out->count : patches.size(); }
    bool in_contact() const { return contacts() > 0; }
    /// Power dissipated by friction in all patches (N mm/s); absent if no patch rolls with friction.
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
