// Holds the values of a case of CONTACT, from a file or from a program, in mm, N, s and rad.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "contactd/contact_regions.hpp"
#include "contactd/contact_setup.hpp"
#include "contactd/friction.hpp"
#include "contactd/friction_along_track.hpp"
#include "contactd/given_ics.hpp"
#include "contactd/grid.hpp"
#include "contactd/material.hpp"
#include "given/not_covered.hpp"

namespace contactd::cases {

/// Describes a Hertzian contact by curvatures or semi-axes. The elements divide `scale` times the box of its contact
/// area.
struct HertzArea {
    int option = 0;      ///< -1 to -6
    int mx = 0, my = 0;  ///< numbers of elements
    double first = 0;    ///< curvature a1 (1/mm) or semi-axis a (mm), by the option
    double second = 0;   ///< curvature b1 (1/mm), a/b, semi-axis b, half width (mm), or mean of two semi-axes
    double scale = 0;
    double negative = 0, positive = 0;  ///< semi-axes of two half ellipses towards -y and +y (mm)
};

/// b1 x^2 + b2 x y + b3 y^2 + b4 x + b5 y + b6 (mm).
struct Quadratic {
    std::array<double, 6> b{};
};

/// p(y) + (x - xm)^2/(2 rm) (mm), with p interpolated linearly between heights at the distance dy, which begin at y1.
struct RoundProfile {
    double xm = 0, rm = 0, y1 = 0, dy = 0;
    std::vector<double> heights;
};

/// b1 sin(b2 (x - b3)) - b4 sin(b5 (x - b6)) + x^2/b7 + y^2/b8 (mm).
struct Waves {
    std::array<double, 8> b{};
};

/// Selects the elements that may come into contact: those inside a conic by P1 to P6 (below zero), inside rectangles,
/// or inside patches that share their displacements.
using Planform = std::variant<std::monostate, Quadratic, std::vector<RegionLimits>, ContactRegions>;

/// Holds the undeformed distance for a grid that is given directly.
using Distance = std::variant<Quadratic, RoundProfile, Waves, std::vector<double>>;

/// Holds creepages and spin, or shift and rotation, depending on the digit T of the solve. The numbers are in their own
/// units.
struct GivenMotion {
    double vx = 0, vy = 0, phi = 0;
    double length = 1;  ///< the unit of length (mm)
};

/// Holds an extra rigid slip with one value for each element.
struct GivenSlip {
    std::vector<double> x, y;
    double length = 1;
};

/// Holds the tangential force divided by fstat Fn, on the upper body in all systems of units.
struct RelativeForce {
    double x = 0, y = 0;
};

/// Holds friction as it was given, in mm and s, and as a law of core.
struct GivenFriction {
    int method = 0;  ///< the law, plus 10 for friction by the rail's angle, 20 for friction along the track, or
                     ///< 30 means friction by rows of elements
    std::vector<double> parameters;
    FrictionLaw law;
    /// Holds the law at an angle (rad), for friction that varies with the rail's angle; in ascending order.
    struct AtAngle {
        double angle = 0;
        FrictionLaw law;
    };
    std::vector<AtAngle> by_angle{};
    /// Contains the numbers of the law at each place, in ascending order, for friction that varies along the track.
    std::vector<ContactFrictionAtPlace> along_track{};
    std::vector<FrictionLaw> by_row{};  ///< the law of each row of elements
};

/// Holds the control digits of a case, with their defaults.
struct Digits {
    int configuration = 0;   ///< C1
    int previous = 2;        ///< P
    int bound = 0;           ///< B
    int tangential = 3;      ///< T
    int normal = 1;          ///< N
    int force = 0;           ///< F
    int friction_law = 0;    ///< L
    int discretisation = 2;  ///< D
    int influence = 2;       ///< C
    int material = 0;        ///< M
    int extra_slip = 0;      ///< E
    int heat = 0;            ///< H
    int estimate = 0;        ///< I
    int result = 0;          ///< R
    int sensitivities = 0;   ///< S
    int variant = 4;         ///< VARIANT of C = 4
};

/// Limits of NPOT_MAX.
inline constexpr int least_patch_elements = 100, most_patch_elements = 1'000'000;

/// The default velocity (mm/s).
inline constexpr double usual_velocity = 1000;

struct Given {
    Digits digits;
    int most_elements = 20'000;  ///< patches on rails with at least this number get larger elements
    ContactSettings solvers;
    bool one_outer_iteration = false;  ///< for dissimilar bodies
    bool starts_in_slip = false;       ///< whether falling friction starts from full slip
    std::optional<MaterialPair> materials;
    std::optional<std::array<Viscoelasticity, 2>> creep;  ///< values of the upper and the lower body
    SlopeReduction slope;                                 ///< for the simplified theory
    std::optional<GivenFriction> friction;
    std::optional<InterfacialLayer> layer;  ///< between the bodies
    std::optional<ThermalBodies> heat;      ///< only used with H > 0
    std::variant<std::monostate, HertzArea, Grid> area;
    std::optional<Distance> distance;
    Planform planform;                             ///< given together with the distance
    std::shared_ptr<const GivenIcs> coefficients;  ///< from a file, for C = 9
    double sheet = 0;                              ///< flexibility of a thin sheet, for B = 1 (mm^3/N)
    double spin_x = 0, spin_y = 0;                 ///< centre of spin (mm)
    double spin_offset = 1.0 / 6;                  ///< FACPHI: steps ahead of the centre of an element
    std::optional<double> pen, fn;                 ///< (mm), (N)
    std::optional<double> time_step;               ///< (s)
    std::optional<double> velocity;                ///< (mm/s)
    double chi = 0;                                ///< (rad)
    std::optional<double> dq;                      ///< (mm)
    std::optional<GivenMotion> motion;
    std::optional<RelativeForce> force;
    std::optional<GivenSlip> extra_slip;
};

/// Returns the thermal properties of the bodies if temperatures are requested. Throws NotCovered if they are missing.
std::optional<ThermalBodies> heat_of(const Given& settings);

}  // namespace contactd::cases
