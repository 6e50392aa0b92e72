// A wheel on a rail: what all steps of a simulation have in common. docs/wheel-rail.md draws the coordinates.
//
// Track coordinates: x forwards, y to the right, z down; the origin lies between the rails on the plane of their tops.
// Profiles are those of the right side, also of a left wheel: y to the field side, z down, the flange and the gauge
// face at y < 0.
#pragma once

#include <numbers>
#include <optional>
#include <vector>

#include "contactd/body.hpp"
#include "contactd/contact_setup.hpp"
#include "contactd/profile_spec.hpp"

namespace contactd {

/// Which wheel of the wheelset, seen in the direction of travel.
enum class Side { left, right };

/// Springs between a massless flexible rail and the ground (N/mm); the rail is rigid in a direction that has none.
struct RailSprings {
    std::optional<double> y{}, z{};

    bool operator==(const RailSprings&) const = default;
};

/// Where the rails lie. Lengths are in mm, angles in rad.
struct Track {
    double gauge = 1435;       ///< between the rails' gauge faces
    double gauge_height = 14;  ///< below the tops of the rails, where the gauge is measured
    double cant = 0;           ///< of the profile as given, leaning inwards where positive
    /// Position of the rail profile's origin, with y to the field side from the centre of the track; overrides
    /// gauge and gauge_height.
    std::optional<ProfilePoint> rail_origin{};
    /// A roller turns under the wheel in place of the rail: its radius where the profile has z = 0. The profile is not
    /// lifted to the plane of the track then.
    std::optional<double> roller_radius{};
    /// The roller's surface is one about an axle that leans and moves with the profile, by the deviations roll and z
    /// and the cant, while it turns about a level axle that does not, which reference programs have and comparisons
    /// with them want. Else the axle is level and moves with z, and the profile leans on it.
    bool roller_leans = false;
    std::optional<RailSprings> springs{};  ///< absent: the rail is rigid

    bool operator==(const Track&) const = default;
};

/// Where the wheels sit on their axle (mm).
struct Wheelset {
    double flange_back_distance = 1360;  ///< between the backs of the flanges
    double flange_back_position = -70;   ///< y of the flange's back in the profile of the wheel
    double nominal_radius = 460;         ///< where the profile has z = 0

    bool operator==(const Wheelset&) const = default;
};

/// How surfaces go from slice to slice: through them, without swinging beyond them (quintic splines that keep equal
/// slices equal all between); through them by cubic splines, which swing; or by cubic B-splines whose control points
/// they are, which pass them by and smooth what is noise.
enum class SliceSpline { shape_preserving, cubic, approximating };

/// The rail's profile at a place along the track (mm), in the same coordinates for all.
struct RailSlice {
    double x = 0;
    ProfileSpec profile{ProfileKind::rail, Rail60E1{1.0 / 40}};
    /// Where lines along the track (features) pass through this slice: lengths along the profile from its first point
    /// (mm), ascending, as many in all slices; negative where a feature does not exist here, which may be so at both
    /// ends of the list. Parts of slices between the same features are joined. Empty: from kink to kink.
    std::vector<double> features{};

    bool operator==(const RailSlice&) const = default;
};

/// The profile of an out-of-round wheel at an angle about its axle (rad), from z to x as pitch: at pitch p the
/// slice of angle -p is lowest. z is over the nominal radius, in the same coordinates for all.
struct WheelSlice {
    double angle = 0;
    ProfileSpec profile{ProfileKind::wheel, S1002{}};

    bool operator==(const WheelSlice&) const = default;
};

/// How regions of overlap are found: along the locus, where for each y the distance along the track is least and the
/// wheel alone is curved; or on a mesh seen from above, for rails that curve along the track, too.
enum class ContactSearch { locus, mesh };

/// Says what the parts of a patch go on from that splits in a step which is not steady: the tractions on their own
/// elements; or those of all the patch before, whose displacements each part feels before the step and not behind it,
/// so that the split alone brings slip, which is what reference programs do and comparisons with them want.
enum class PatchHistory { own, whole };

/// Rules by which regions of overlap that lie close to each other are patches of their own, whose planes turn towards
/// each other (below distance_turn); parts of one patch with a weighted interaction (blending, below
/// distance_separate); or one patch (below distance_combine). Distances in mm; 0 < distance_combine < distance_separate
/// < distance_turn.
struct PatchRules {
    double angle_separate =
        std::numbers::pi / 2;  ///< patches of their own where the planes' angles differ by more (rad)
    double distance_separate = 8;
    double distance_combine = 4;
    double distance_turn = 12;
    double locus_step = 0.3;  ///< of the locus across the track, in elements dy
    ContactSearch search = ContactSearch::locus;
    PatchHistory history = PatchHistory::own;
    /// Elements are doubled along and across in patches of steady rolling that would have as many; 0: never.
    int max_elements = 0;

    bool operator==(const PatchRules&) const = default;
};

/// How the wheel is evaluated: by its splines, or between the corners of a mesh as large as the elements, which is what
/// reference programs do and what comparisons with them want.
enum class WheelSurfaceKind { exact, bilinear };

/// Rigid slip, before the bodies deform: by the creepages of the reference, as in a plane, which is what reference
/// programs do; by the motion of both surfaces at each row of elements, seen along the surface there, and spin taken
/// ahead of the middles of the elements as creepages have it; or by that motion at the middle of each element, seen
/// along the plane (along the row, of a conformal contact) and as the surfaces lean along x, with creepages that fit it
/// best, which is what reference programs have for conformal contact. With `surfaces` forces do not jump where regions
/// with different rolling radii become one patch.
enum class RigidSlipKind { plane, surfaces, elements };

/// Which forces of a patch follow the slope of the rail along the track, in the track's, the rail's and the wheelset's
/// coordinates: those of the pressures, which then act along the normal of the rail's surface; all, so that friction
/// acts along the surface, too; or none, as if the rail were level along the track, which reference programs have and
/// comparisons with them want. On a straight rail all three are the same.
enum class SlopeForces { pressure, all, none };

/// Whether a contact is curved across the track as wheel and rail are, half-way between both: each row of elements has
/// its own normal, by which gaps are measured, tractions turned and slip is that of the surfaces. With the influence
/// coefficients of half-spaces, as if the rows lay flat; of half-spaces that turn from row to row; or of wheel and rail
/// by their cross-sections, from finite elements. `automatic`: rotated where a contact in a plane would bend away from
/// it by more than most_bend, else off. `rotated_displacements`: of half-spaces along the loaded row, of which only the
/// displacements turn, which reference programs have and comparisons with them want: what two rows do to each other is
/// not the same then.
enum class Conformal { off, half_space, rotated, fem, automatic, rotated_displacements };

/// Angle (rad) of the rail to the plane of a contact from where on distances along the one normal are wrong by 3 %.
inline constexpr double most_bend = 0.2419;

/// The coefficient of friction where the rail's surface is inclined by `angle` (rad, from the horizontal, negative on
/// the gauge side); straight lines between, constant beyond.
struct FrictionAtAngle {
    double angle = 0;
    double mu = 0;

    bool operator==(const FrictionAtAngle&) const = default;
};

/// How friction follows the temperature where the rail's surface is inclined by `angle`, as TemperatureFriction:
/// straight lines between, constant beyond.
struct TemperatureFrictionAtAngle {
    double angle = 0;
    double change = 0, reference = 0, range = 0;

    TemperatureFriction law() const { return {change, reference, range}; }
    bool operator==(const TemperatureFrictionAtAngle&) const = default;
};

struct WheelRailFriction {
    std::vector<FrictionAtAngle> mu{{0, 0.3}};  ///< by ascending angles; one entry holds everywhere
    bool along_profile = false;  ///< the angle is that of the rail at each row of elements, else that of the patch
    std::optional<KineticFriction> kinetic{};
    std::optional<InterfacialLayer> layer{};  ///< of model full
    std::optional<TemperatureFriction> temperature{};
    /// In place of `temperature` where it is another one from place to place, by ascending angles.
    std::vector<TemperatureFrictionAtAngle> temperature_by_angle{};

    bool follows_temperature() const { return temperature || !temperature_by_angle.empty(); }
    bool operator==(const WheelRailFriction&) const = default;
};

/// Between angles on straight lines, and constant beyond them.
double coefficient_at(const std::vector<FrictionAtAngle>& mu, double angle);
TemperatureFriction law_at(const std::vector<TemperatureFrictionAtAngle>& laws, double angle);

struct WheelRailSetup {
    Side side = Side::right;
    ProfileSpec wheel{ProfileKind::wheel, S1002{}};
    ProfileSpec rail{ProfileKind::rail, Rail60E1{1.0 / 40}};
    /// In place of `rail` where it varies along the track: two or more slices by ascending x. From slice to slice
    /// points are joined that lie at equal shares of the length from kink to kink, of which all slices need as many, or
    /// from feature to feature. A part of the rail exists between two slices that both have it.
    /// Slices that are equal are equal all between. Needs track.rail_origin.
    std::vector<RailSlice> rail_slices{};
    /// In place of `wheel` where it is out of round: two or more slices by ascending angles, all within a turn, after
    /// which the first one comes again. Radii go from slice to slice with continuous curvature and without
    /// overshoot. Contacts are searched on a mesh.
    std::vector<WheelSlice> wheel_slices{};
    SliceSpline rail_spline = SliceSpline::shape_preserving, wheel_spline = SliceSpline::shape_preserving;
    Track track;
    Wheelset wheelset;
    /// Upper is the rail, lower the wheel: forces and tractions act on the rail.
    Bodies bodies = Bodies::of({{82000, 0.28}, {82000, 0.28}});
    Model model = Model::full;
    NormalModel normal_model = NormalModel::of_model;  ///< as of ContactSetup
    SimplifiedSettings simplified{};
    double sheet_flexibility = 0;  ///< of a thin sheet between them, as of ContactSetup (mm^3/N)
    /// What they have to do with heat, where temperatures of their surfaces are wanted: of steady rolling.
    std::optional<ThermalBodies> temperature{};
    std::optional<FatigueRequest> fatigue{};  ///< where fatigue of rail (upper) or wheel (lower) is wanted, likewise
    std::optional<WearRequest> wear{};  ///< where wear of rail (upper) and wheel (lower) is wanted: of steady rolling
    std::optional<WheelRailFriction> friction = WheelRailFriction{};  ///< absent: frictionless
    double dx = 0.2, dy = 0.2;  ///< sizes of the elements along and across the track, in the contact plane (mm)
    double dq = 0;              ///< step of rolling (mm); 0: dx
    PatchRules patches{};
    WheelSurfaceKind wheel_surface = WheelSurfaceKind::exact;
    RigidSlipKind rigid_slip = RigidSlipKind::plane;  ///< else of model full only
    SlopeForces slope_forces = SlopeForces::pressure;
    ContactSettings settings{};
    Conformal conformal = Conformal::off;  ///< else of model full only; fem: of a rail that is uniform along x
    SolverSettings force{1e-6, 40};        ///< of the search for a height that brings Fz: |F - Fz|/Fz, and solves
    /// How far forces, over Fn, and fields, over their largest values, may be from those of a fresh solve with tight
    /// tolerances at the same height; in place of the tolerances of `settings` and `force`, which are chosen by it.
    std::optional<double> accuracy{};

    bool operator==(const WheelRailSetup&) const = default;
};

/// Tolerances of the solvers over the accuracy of forces and of largest values that they bring.
inline constexpr double normal_per_accuracy = 0.03, tangential_per_accuracy = 1;

/// Returns the set-up with the tolerances that its accuracy chooses.
WheelRailSetup with_tolerances(const WheelRailSetup& setup);

/// Returns the step of rolling on elements dx long (mm): `dq` in proportion to the set-up's dx, or their length.
double step_of_rolling(const WheelRailSetup& setup, double dx);

/// Tells whether patches have distances of their own on a grid, as pressures that are no ellipses need.
bool has_distances(const WheelRailSetup& setup);

/// Both wheels of a wheelset. `side` means nothing in the parts.
struct WheelsetSetup {
    WheelRailSetup setup{};                ///< of both wheels, or of the right one where the left one has its own
    std::optional<WheelRailSetup> left{};  ///< of the left wheel, where it differs

    bool operator==(const WheelsetSetup&) const = default;
};

/// Set-up of one of its wheels, on its side.
WheelRailSetup setup_of(const WheelsetSetup& wheelset, Side side);

/// Throws InvalidArgument naming the field, in the words of these structs.
void validate(const WheelRailSetup& setup);

}  // namespace contactd
