// The values that a contact problem is made of, in mm, N, s, rad: those of a case of CONTACT, whoever set them.
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

/// By curvatures or semi-axes; the elements divide `scale` times the box of Hertz's contact area.
struct HertzArea {
    int option = 0;      ///< -1 to -6
    int mx = 0, my = 0;  ///< numbers of elements
    double first = 0;    ///< curvature a1 (1/mm) or semi-axis a (mm), by the option
    double second = 0;   ///< curvature b1 (1/mm), a/b, semi-axis b or half width (mm), of two halves their mean
    double scale = 0;
    double negative = 0, positive = 0;  ///< semi-axes of two half ellipses towards -y and +y (mm)
};

/// b1 x^2 + b2 x y + b3 y^2 + b4 x + b5 y + b6 (mm).
struct Quadratic {
    std::array<double, 6> b{};
};

/// p(y) + (x - xm)^2/(2 rm), p on straight lines through heights that lie dy from each other, from y1 on (mm).
struct RoundProfile {
    double xm = 0, rm = 0, y1 = 0, dy = 0;
    std::vector<double> heights;
};

/// b1 sin(b2 (x - b3)) - b4 sin(b5 (x - b6)) + x^2/b7 + y^2/b8 (mm).
struct Waves {
    std::array<double, 8> b{};
};

/// Elements that may touch: those where a conic is below zero, by P1 to P6, those of rectangles, or those of patches,
/// which share their displacements.
using Planform = std::variant<std::monostate, Quadratic, std::vector<RegionLimits>, ContactRegions>;

/// Undeformed distance of a grid that is set itself.
using Distance = std::variant<Quadratic, RoundProfile, Waves, std::vector<double>>;

/// Creepages and spin, or shift and rotation: which of them, the flags of the solve tell. So numbers are as they came.
struct GivenMotion {
    double vx = 0, vy = 0, phi = 0;
    double length = 1;  ///< (mm), unit of lengths in them
};

/// The same, an element each.
struct GivenSlip {
    std::vector<double> x, y;
    double length = 1;
};

/// Tangential force over fstat Fn, on the upper body in all systems of units.
struct RelativeForce {
    double x = 0, y = 0;
};

/// Friction as it was set, in mm and s, and what core makes of it.
struct GivenFriction {
    int method = 0;  ///< the law, and ten times how it varies: 1 with the rail's angle, 2 along the track,
                     ///< 3 by the rows of elements
    std::vector<double> parameters;
    FrictionLaw law;
    /// Friction that varies with the rail's angle: the law at each angle (rad), in ascending order.
    struct AtAngle {
        double angle = 0;
        FrictionLaw law;
    };
    std::vector<AtAngle> by_angle{};
    /// Friction that varies along the track: the numbers of the law at each place, in ascending order.
    std::vector<ContactFrictionAtPlace> along_track{};
    std::vector<FrictionLaw> by_row{};  ///< of rows of elements: the law of each
};

/// The control digits of a case, with their values in a program that sets none.
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

/// Where none is set (mm/s).
inline constexpr double usual_velocity = 1000;

struct Given {
    Digits digits;
    int most_elements = 20'000;  ///< a patch on rails has fewer, or larger ones
    ContactSettings solvers;
    bool one_outer_iteration = false;  ///< of dissimilar bodies
    bool starts_in_slip = false;       ///< whether falling friction starts from full slip
    std::optional<MaterialPair> materials;
    std::optional<std::array<Viscoelasticity, 2>> creep;  ///< of the upper and the lower body
    SlopeReduction slope;                                 ///< of the simplified theory
    std::optional<GivenFriction> friction;
    std::optional<InterfacialLayer> layer;  ///< between the bodies
    std::optional<ThermalBodies> heat;      ///< where it counts, the flag 1982 says
    std::variant<std::monostate, HertzArea, Grid> area;
    std::optional<Distance> distance;
    Planform planform;                             ///< with it
    std::shared_ptr<const GivenIcs> coefficients;  ///< of C = 9, from a file
    double sheet = 0;                              ///< flexibility of a thin sheet, of B = 1 (mm^3/N)
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

/// Returns the thermal properties of the bodies, where temperatures are asked for. Throws NotCovered where there are
/// none.
std::optional<ThermalBodies> heat_of(const Given& settings);

}  // namespace contactd::cases
