// Defines the set-up of a wheel on a rail, which all steps of a simulation share. docs/wheel-rail.md shows the
// coordinates.
//
// In track coordinates, x is forwards, y to the right and z down; the origin lies between the rails on the plane of
// their tops. Profiles are those of the right side, also for a left wheel: y to the field side, z down, the flange and
// the gauge face at y < 0.
#pragma once

#include <numbers>
#include <optional>
#include <vector>

#include "contactd/body.hpp"
#include "contactd/contact_setup.hpp"
#include "contactd/profile_spec.hpp"

namespace contactd {

/// Selects a wheel of the wheelset, seen in the direction of travel.
enum class Side { left, right };

/// Describes springs between a massless flexible rail and the ground (N/mm). The rail is rigid in a direction without a
/// spring.
struct RailSprings {
    std::optional<double> y{}, z{};

    bool operator==(const RailSprings&) const = default;
};

/// Describes the position of the rails. Lengths are in mm, angles in rad.
struct Track {
    double gauge = 1435;       ///< between the rails' gauge faces
    double gauge_height = 14;  ///< below the tops of the rails, where the gauge is measured
    double cant = 0;           ///< inclination of the profile, positive if leaning inwards
    /// The origin of the rail's profile is at this position, with y to the field side from the centre of the track. It
    /// overrides gauge and gauge_height.
    std::optional<ProfilePoint> rail_origin{};
    /// A roller of this radius, at z = 0 of the profile, turns under the wheel instead of a rail. The profile is then
    /// not lifted to the plane of the track.
    std::optional<double> roller_radius{};
    /// If set, the roller's surface is that of revolution about an axle that leans and moves with the profile, by the
    /// deviations roll and z and the cant, while the roller turns about a level axle that does not. Use it to compare
    /// with reference programs. Otherwise the axle is level and moves with z, and the profile leans on it.
    bool roller_leans = false;
    std::optional<RailSprings> springs{};  ///< absent: the rail is rigid

    bool operator==(const Track&) const = default;
};

/// Describes the position of the wheels on their axle (mm).
struct Wheelset {
    double flange_back_distance = 1360;  ///< between the backs of the flanges
    double flange_back_position = -70;   ///< y of the flange's back in the profile of the wheel
    double nominal_radius = 460;         ///< radius where the profile has z = 0

    bool operator==(const Wheelset&) const = default;
};

/// Selects the interpolation of surfaces from slice to slice. shape_preserving uses quintic splines without overshoot,
/// which are constant between equal slices; cubic uses cubic splines, which may oscillate. approximating uses cubic
/// B-splines with the slices as control points, which do not pass through them and smooth noise.
enum class SliceSpline { shape_preserving, cubic, approximating };

/// Describes the rail's profile at a position along the track (mm), in the same coordinates for all slices.
struct RailSlice {
    double x = 0;
    ProfileSpec profile{ProfileKind::rail, Rail60E1{1.0 / 40}};
    /// Lines along the track (features) pass through this slice at these positions: lengths along the profile from its
    /// first point (mm), ascending, the same number in all slices. A negative value means that the feature does not
    /// exist here, which is allowed at both ends of the list. Parts of slices between the same features are connected.
    /// If empty, kinks are the features.
    std::vector<double> features{};

    bool operator==(const RailSlice&) const = default;
};

/// Describes the profile of an out-of-round wheel at an angle about its axle (rad), from z to x like pitch: at pitch p
/// the slice of angle -p is lowest. z is relative to the nominal radius, in the same coordinates for all slices.
struct WheelSlice {
    double angle = 0;
    ProfileSpec profile{ProfileKind::wheel, S1002{}};

    bool operator==(const WheelSlice&) const = default;
};

/// Selects the search for regions of overlap. locus searches along the locus, where for each y the distance along the
/// track is least and the wheel alone is curved. mesh searches on a mesh seen from above, for rails that curve along
/// the track, too.
enum class ContactSearch { locus, mesh };

/// Selects the initial tractions of the parts of a patch that splits in a step that is not steady. own uses the
/// tractions on their own elements. whole uses those of the complete earlier patch, whose displacements act on each
/// part before the step and not after it, so that the split alone produces slip. Use whole to compare with reference
/// programs.
enum class PatchHistory { own, whole };

/// Defines rules for nearby regions of overlap. By their distance, they are separate patches, whose planes rotate
/// towards each other (below distance_turn); parts of one patch with weighted interaction (blending, below
/// distance_separate); or one patch (below distance_combine). Distances are in mm, with 0 < distance_combine <
/// distance_separate < distance_turn.
struct PatchRules {
    double angle_separate = std::numbers::pi / 2;  ///< separate patches if the planes' angles differ by more (rad)
    double distance_separate = 8;
    double distance_combine = 4;
    double distance_turn = 12;
    double locus_step = 0.3;  ///< step of the locus across the track, in elements dy
    ContactSearch search = ContactSearch::locus;
    PatchHistory history = PatchHistory::own;
    /// In steady rolling, elements of a patch are doubled along and across if there are this many or more; 0: never.
    int max_elements = 0;

    bool operator==(const PatchRules&) const = default;
};

/// Selects the wheel surface: its splines, or interpolation between the corners of a mesh with the size of the
/// elements. Use the latter to compare with reference programs.
enum class WheelSurfaceKind { exact, bilinear };

/// Selects the rigid slip before the bodies deform. plane computes it from the creepages of the reference, as reference
/// programs do. surfaces computes it from the motion of both surfaces at each row of elements, projected on the surface
/// there, with spin evaluated ahead of the middles of the elements as for creepages. elements computes it from that
/// motion at the middle of each element, projected on the plane (in conformal contact on the row) as the surfaces lean
/// along x, with the creepages that fit it best, as reference programs do for conformal contact. With `surfaces`,
/// forces do not jump where regions with different rolling radii merge into one patch.
enum class RigidSlipKind { plane, surfaces, elements };

/// Selects the forces of a patch that follow the slope of the rail along the track, in the track's, the rail's and the
/// wheelset's coordinates. With pressure, those of the pressures act along the normal of the rail's surface; with all,
/// friction acts along the surface, too; with none, forces are as if the rail were level along the track. Use none to
/// compare with reference programs. On a straight rail all three are the same.
enum class SlopeForces { pressure, all, none };

/// Selects contact that is curved across the track, half-way between wheel and rail. Each row of elements then has its
/// own normal: gaps are measured along it, tractions are rotated, and slip is that of the surfaces. half_space uses
/// coefficients as if the rows lay flat, and rotated uses half-spaces rotated from row to row. fem uses finite elements
/// for the cross-sections of wheel and rail. automatic is rotated if the contact deviates from a plane by more than
/// most_bend, otherwise off. rotated_displacements uses half-spaces along the loaded row, of which only the
/// displacements are rotated, so that the interaction of two rows is not symmetric. Use it to compare with reference
/// programs.
enum class Conformal { off, half_space, rotated, fem, automatic, rotated_displacements };

/// If the angle (rad) between rail and contact plane is larger, distances along a single normal have an error above 3
/// %.
inline constexpr double most_bend = 0.2419;

/// Describes the coefficient of friction where the rail's surface is inclined by `angle` (rad, from the horizontal,
/// negative on the gauge side). It is linear between entries and constant beyond them.
struct FrictionAtAngle {
    double angle = 0;
    double mu = 0;

    bool operator==(const FrictionAtAngle&) const = default;
};

/// Describes temperature-dependent friction where the rail's surface is inclined by `angle`, like TemperatureFriction.
/// It is linear between entries and constant beyond them.
struct TemperatureFrictionAtAngle {
    double angle = 0;
    double change = 0, reference = 0, range = 0;

    TemperatureFriction law() const { return {change, reference, range}; }
    bool operator==(const TemperatureFrictionAtAngle&) const = default;
};

struct WheelRailFriction {
    std::vector<FrictionAtAngle> mu{{0, 0.3}};  ///< by ascending angles; a single entry is uniform friction
    bool along_profile = false;                 ///< whether the angle is that of the rail at each row of elements, not
                                                ///< of the patch
    std::optional<KineticFriction> kinetic{};
    std::optional<InterfacialLayer> layer{};  ///< for model full
    std::optional<TemperatureFriction> temperature{};
    /// Replaces `temperature` if friction varies over the rail, by ascending angles.
    std::vector<TemperatureFrictionAtAngle> temperature_by_angle{};
    std::optional<FrictionMemory> memory{};  ///< memory of `temperature_by_angle`, the same at all angles

    bool follows_temperature() const { return temperature || !temperature_by_angle.empty(); }
    bool operator==(const WheelRailFriction&) const = default;
};

/// Return the values at an angle, linear between entries and constant beyond them.
double coefficient_at(const std::vector<FrictionAtAngle>& mu, double angle);
TemperatureFriction law_at(const std::vector<TemperatureFrictionAtAngle>& laws, double angle);

/// Returns the law of `temperature_by_angle`, which is not empty, at an angle, with its memory.
TemperatureFriction temperature_friction_at(const WheelRailFriction& friction, double angle);

struct WheelRailSetup {
    Side side = Side::right;
    ProfileSpec wheel{ProfileKind::wheel, S1002{}};
    ProfileSpec rail{ProfileKind::rail, Rail60E1{1.0 / 40}};
    /// Replaces `rail` for a rail that varies along the track: two or more slices by ascending x. Points are connected
    /// at equal fractions of the length between features, or between kinks, whose number must then be the same in all
    /// slices. A part of the rail exists between two slices that both have it. The surface is constant between equal
    /// slices. Requires track.rail_origin.
    std::vector<RailSlice> rail_slices{};
    /// Replaces `wheel` for an out-of-round wheel: two or more slices by ascending angles within one revolution, after
    /// which the first slice follows again. Radii are interpolated with continuous curvature and without overshoot.
    /// Contacts are searched on a mesh.
    std::vector<WheelSlice> wheel_slices{};
    SliceSpline rail_spline = SliceSpline::shape_preserving, wheel_spline = SliceSpline::shape_preserving;
    Track track;
    Wheelset wheelset;
    /// The upper body is the rail, the lower one the wheel: forces and tractions act on the rail.
    Bodies bodies = Bodies::of({{82000, 0.28}, {82000, 0.28}});
    Model model = Model::full;
    NormalModel normal_model = NormalModel::of_model;  ///< as in ContactSetup
    SimplifiedSettings simplified{};
    double sheet_flexibility = 0;  ///< flexibility of a thin sheet between them, as in ContactSetup (mm^3/N)
    /// Thermal properties request surface temperatures. They require steady rolling.
    std::optional<ThermalBodies> temperature{};
    std::optional<FatigueRequest> fatigue{};  ///< requests fatigue of rail (upper) or wheel (lower)
    std::optional<WearRequest> wear{};        ///< requests wear of rail (upper) and wheel (lower); steady rolling
    std::optional<WheelRailFriction> friction = WheelRailFriction{};  ///< absent: frictionless
    double dx = 0.2, dy = 0.2;  ///< sizes of the elements along and across the track, in the contact plane (mm)
    double dq = 0;              ///< step of rolling (mm); 0: dx
    PatchRules patches{};
    WheelSurfaceKind wheel_surface = WheelSurfaceKind::exact;
    RigidSlipKind rigid_slip = RigidSlipKind::plane;  ///< kinds other than plane require model full
    SlopeForces slope_forces = SlopeForces::pressure;
    ContactSettings settings{};
    Conformal conformal = Conformal::off;  ///< kinds other than off require model full; fem: a rail that is uniform
                                           ///< along x
    SolverSettings force{1e-6, 40};        ///< search for a height that produces Fz: |F - Fz|/Fz, and number of solves
    /// If given, this is the largest deviation of forces (relative to Fn) and fields (relative to their largest values)
    /// from those of a fresh solve with tight tolerances at the same height. It replaces the tolerances of `settings`
    /// and `force`.
    std::optional<double> accuracy{};

    bool operator==(const WheelRailSetup&) const = default;
};

/// The tolerances of the solvers are these multiples of the requested accuracy of forces and largest values.
inline constexpr double normal_per_accuracy = 0.03, tangential_per_accuracy = 1;

/// Returns the set-up with the tolerances for its accuracy.
WheelRailSetup with_tolerances(const WheelRailSetup& setup);

/// Returns the step of rolling on elements dx long (mm): `dq` in proportion to the set-up's dx, or their length.
double step_of_rolling(const WheelRailSetup& setup, double dx);

/// Returns whether patches have their own distances on a grid, which non-elliptic pressures require.
bool has_distances(const WheelRailSetup& setup);

/// Describes both wheels of a wheelset. `side` of the parts is ignored.
struct WheelsetSetup {
    WheelRailSetup setup{};                ///< set-up of both wheels, or of the right wheel if the left one has its own
    std::optional<WheelRailSetup> left{};  ///< set-up of the left wheel, if it differs

    bool operator==(const WheelsetSetup&) const = default;
};

/// Returns the set-up of one wheel of the wheelset, on its side.
WheelRailSetup setup_of(const WheelsetSetup& wheelset, Side side);

/// Throws InvalidArgument, which names the field by its path in these structs.
void validate(const WheelRailSetup& setup);

}  // namespace contactd
