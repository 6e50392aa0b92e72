#include "rail_setup.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "given/given_friction.hpp"
#include "problem/case_models.hpp"

namespace contactd::cases {
namespace {

enum Tangential { none = 0, shift = 1, transient = 2 };
enum Force { longitudinal = 1, springs = 3 };
enum Surfaces { plane = 2, slip_of_surfaces = 3, curved = 4, mesh = 5 };
constexpr int rotated_half_spaces = 4, of_sheet = 1;

/// Distances (mm) that differ by less than this may be equal in CONTACT, but not here.
constexpr double near = 1e-6;

double outwards(const Given& settings) {
    return on_left_side(settings) ? -1 : 1;
}

/// Returns whether the surface of a roller leans, by its deviation or its cant. On rails only the profile leans.
bool leans(const GivenRail& rail) {
    return rail.deviation.roll != 0 || rail.track.cant != 0;
}

/// Returns the vertical deviation of a roller whose profile is placed directly, and which moves with its axle.
double sunk(const Given& settings, const GivenRail& rail) {
    return on_roller(settings) && rail.track.gauge_height <= 0 && !leans(rail) ? rail.deviation.z : 0;
}

Track track_of(const Given& settings, const GivenRail& rail) {
    const GivenTrack& given = rail.track;
    Track track;
    if (given.gauge_height > 0) {
        track.gauge = given.gauge;
        track.gauge_height = given.gauge_height;
    } else {
        track.rail_origin = ProfilePoint{outwards(settings) * given.rail_y, given.rail_z + sunk(settings, rail)};
    }
    track.cant = given.cant;
    if (on_roller(settings)) {
        if (!(given.roller_radius > 0))
            throw NotCovered(Subject::input, "The roller radius NOMRADR must be positive (cntc_settrackdimensions).");
        if (rail.deviation.z != 0 && given.gauge_height > 0)
            throw NotCovered(Subject::input,
                             "DZRAIL moves a roller with its axle, which is only supported if RAILY0 and RAILZ0 place "
                             "its profile (GAUGHT <= 0). Use DZRAIL = 0 or GAUGHT <= 0 (cntc_settrackdimensions).");
        track.roller_radius = given.roller_radius;
        track.roller_leans = leans(rail);
        return track;
    }
    if (settings.digits.force == springs && (given.spring_y > 0 || given.spring_z > 0)) {
        track.springs.emplace();
        if (given.spring_y > 0) track.springs->y = given.spring_y;
        if (given.spring_z > 0) track.springs->z = given.spring_z;
    }
    return track;
}

/// Returns the wheelset. Only the position of the profile along the axle has an effect, so a distance of flange backs
/// that is not positive is replaced together with the flange position.
Wheelset wheelset_of(Wheelset given) {
    double& distance = given.flange_back_distance;
    double& position = given.flange_back_position;
    if (distance <= 0) {
        position = 0.5 - std::max(distance / 2 - position, near);
        distance = 1;
    }
    return given;
}

PatchRules patches_of(const GivenElements& given, const Given& settings) {
    PatchRules rules;
    rules.angle_separate = std::clamp(given.angle_separate, near, std::numbers::pi);
    rules.distance_combine = std::max(given.combine, near);
    rules.distance_separate = std::max(given.separate, rules.distance_combine + near);
    rules.distance_turn = std::max(given.turn, rules.distance_separate + near);
    if (settings.digits.discretisation == mesh) rules.search = ContactSearch::mesh;
    rules.history = PatchHistory::whole;
    rules.max_elements = settings.most_elements;
    return rules;
}

/// Returns the kind of rotated half-spaces: variant 4 rotates loads and displacements, variant 3 only displacements.
Conformal rotated_of(int variant) {
    constexpr int of_displacements = 3;
    if (variant < of_displacements)
        throw NotCovered(
            Subject::other,
            "VARIANT = " + std::to_string(variant) +
                " (flag 1990) is not supported with C = 4: half-spaces that rotate only the loads. Use 3 or 4.");
    return variant == of_displacements ? Conformal::rotated_displacements : Conformal::rotated;
}

bool slips_by_surfaces(const Given& settings) {
    const int surfaces = settings.digits.discretisation;
    return surfaces == slip_of_surfaces || surfaces == curved;
}

Conformal conformal_of(const Given& settings) {
    const bool is_rotated = settings.digits.influence == rotated_half_spaces;
    if (settings.digits.discretisation == curved)
        return is_rotated ? rotated_of(settings.digits.variant) : Conformal::half_space;
    if (is_rotated)
        throw NotCovered(Subject::input,
                         "Control digit C = 4 (flag 1978), rotated half-spaces, requires a curved contact. Use D = 4 "
                         "(flag 1977).");
    return Conformal::off;
}

/// Returns friction by angle. CONTACT's angles are relative to the wheel profile in planar contacts, and to the track
/// in curved ones. contactd's angles are relative to the track, and for left wheels to that of the mirror image.
WheelRailFriction by_angle(const Given& settings, const std::vector<GivenFriction::AtAngle>& laws, double roll) {
    const bool is_curved = settings.digits.discretisation == curved;
    const double offset = is_curved ? 0 : outwards(settings) * roll;
    WheelRailFriction friction;
    friction.mu.clear();
    friction.along_profile = is_curved;
    friction.kinetic = laws.front().law.kinetic;
    friction.layer = layer_of(settings);
    for (const auto& [angle, law] : laws) {
        if (law.kinetic != friction.kinetic)
            throw NotCovered(
                Subject::friction,
                "Falling friction (L = 2, 3 or 4) that differs between angles (V = 1) is not supported. Use "
                "the same law at all angles.");
        friction.mu.push_back({angle + offset, law.mu[0]});
        if (const auto& heated = law.temperature) {
            friction.temperature_by_angle.push_back({angle + offset, heated->change, heated->reference, heated->range});
            friction.memory = heated->memory;
        }
    }
    return friction;
}

WheelRailFriction friction_of(const Given& settings, const GivenRail& rail) {
    if (!settings.friction) throw NotCovered(Subject::friction, "No friction was given (cntc_setfrictionmethod).");
    const GivenFriction& given = *settings.friction;
    if (settings.digits.friction_law != given.method % 10)
        throw NotCovered(Subject::friction, "Control digit L = " + std::to_string(settings.digits.friction_law) +
                                                " (flag 1976) differs from the given friction law " +
                                                std::to_string(given.method % 10) +
                                                ". Use the same law in both (cntc_setfrictionmethod).");
    if (!given.by_angle.empty()) return by_angle(settings, given.by_angle, rail.position.roll);
    const FrictionLaw law = friction_at(given, rail.position.x);
    return {{{0, law.mu[0]}}, false, law.kinetic, layer_of(settings), law.temperature};
}

}  // namespace

bool on_roller(const Given& settings) {
    return settings.digits.configuration >= 4;
}

bool on_left_side(const Given& settings) {
    return settings.digits.configuration % 4 == 0;
}

WheelRailSetup outline_of(const Given& settings, const GivenRail& rail) {
    WheelRailSetup setup;
    setup.side = on_left_side(settings) ? Side::left : Side::right;
    if (rail.rail.profile) setup.rail = *rail.rail.profile;
    if (rail.wheel.profile) setup.wheel = *rail.wheel.profile;
    setup.rail_slices = rail.rail.rail_slices;
    setup.wheel_slices = rail.wheel.wheel_slices;
    setup.rail_spline = rail.rail.spline;
    setup.wheel_spline = rail.wheel.spline;
    setup.track = track_of(settings, rail);
    setup.wheelset = wheelset_of(rail.wheelset);
    return setup;
}

WheelRailSetup setup_of(const Given& settings, const GivenRail& rail) {
    for (const auto& [surface, name] : {std::pair{&rail.rail, "rail"}, std::pair{&rail.wheel, "wheel"}})
        if (surface->empty())
            throw NotCovered(Subject::profile, "No profile of the " + std::string(name) +
                                                   " was given (cntc_setprofileinputfname or "
                                                   "cntc_setprofileinputvalues).");
    if (!settings.materials)
        throw NotCovered(Subject::input, "No material constants were given (cntc_setmaterialparameters).");
    if (!rail.elements)
        throw NotCovered(Subject::discretisation, "No element sizes DX and DS were given (cntc_setpotcontact).");
    WheelRailSetup setup = outline_of(settings, rail);
    setup.bodies = Bodies::of(solved_materials(*settings.materials));
    if (settings.digits.bound == of_sheet) setup.sheet_flexibility = settings.sheet;
    setup.dx = rail.elements->dx;
    setup.dy = rail.elements->ds;
    const int tangential = settings.digits.tangential;
    setup.friction.reset();
    if (tangential != none) setup.friction = friction_of(settings, rail);
    if (setup.friction && setup.friction->kinetic && settings.starts_in_slip)
        setup.friction->kinetic->start = SlipStart::full_slip;
    if (tangential != none) setup.temperature = heat_of(settings);
    if (tangential == transient && rail.dq != 1) setup.dq = rail.dq * setup.dx;
    setup.patches = patches_of(*rail.elements, settings);
    if (slips_by_surfaces(settings)) setup.rigid_slip = RigidSlipKind::elements;
    setup.slope_forces = SlopeForces::none;
    setup.conformal = conformal_of(settings);
    const CaseModels models = models_of(settings);
    if (models.model != Model::full && models.normal_model == NormalModel::of_model)
        throw NotCovered(Subject::input,
                         "Control digit M = " + std::to_string(settings.digits.material) +
                             " (flag 1979) with B = " + std::to_string(settings.digits.bound) +
                             " (flag 1971) is not supported for a wheel on a rail: FASTSIM and FaStrip require the "
                             "pressures of KPEC or ANALYN. Use B = 5 or 6, or M = 0.");
    setup.model = models.model;
    if (setup.friction) forget_memory(setup.friction->kinetic, setup.model);
    setup.normal_model = models.normal_model;
    setup.simplified = models.simplified;
    setup.settings = settings.solvers;
    setup.force.tolerance = std::min(setup.force.tolerance, settings.solvers.tangential.tolerance);
    return setup;
}

WheelRailState placed_state(const Given& settings, const GivenRail& rail) {
    const bool is_roller = on_roller(settings);
    WheelRailState state;
    state.position = rail.position;
    if (is_roller) state.position.x = 0;
    state.velocity = rail.velocity;
    const double first = rail.velocity.x, forwards = is_roller ? 0 : first * rail.velocity_length;
    state.velocity.x = forwards;
    state.velocity.yaw += forwards * rail.track.curvature;
    state.roller_pitch = is_roller ? first : 0;
    state.wheel = rail.flexibility;
    state.rail = rail.deviation;
    state.rail.z -= sunk(settings, rail);
    return state;
}

/// Returns the pitch rate without creepage, from which the search for a prescribed Fx starts.
double free_pitch_rate(const GivenRail& rail, const WheelRailState& state) {
    return -(state.velocity.x + state.roller_pitch * rail.track.roller_radius) / rail.wheelset.nominal_radius;
}

/// In planar contacts, CONTACT rotates a wheel that is displaced along the track about the axle of the rigid wheelset,
/// while contactd displaces the axle, too. Adds the difference of the velocities.
void rotate_about_rigid_axle(WheelRailState& state, double pitch_rate) {
    state.wheel.y_velocity += state.wheel.x * state.velocity.yaw;
    state.wheel.z_velocity -= state.wheel.x * pitch_rate;
}

WheelRailState state_of(const Given& settings, const GivenRail& rail) {
    WheelRailState state = placed_state(settings, rail);
    const int force = settings.digits.force, tangential = settings.digits.tangential;
    if (!slips_by_surfaces(settings))
        rotate_about_rigid_axle(state, force == longitudinal ? free_pitch_rate(rail, state) : state.velocity.pitch);
    if (force == springs) {
        state.rail.Fy = rail.track.spring_force_y;
        state.rail.Fz = rail.track.spring_force_z;
    }
    if (settings.digits.normal == 1) {
        if (!rail.Fz) throw NotCovered(Subject::input, "No vertical force FZ was given (cntc_setverticalforce).");
        state.Fz = rail.Fz;
    } else if (!state.position.z) {
        throw NotCovered(
            Subject::input,
            "No height Z_WS of the wheelset was given (cntc_setwheelsetposition), and no vertical force FZ "
            "(cntc_setverticalforce). Give one of them.");
    }
    if (force == longitudinal) {
        if (!rail.Fx)
            throw NotCovered(Subject::input, "No longitudinal force FX was given (cntc_settangentialforces).");
        state.Fx = rail.Fx;
        if (state.velocity.pitch == 0) state.velocity.pitch = free_pitch_rate(rail, state);  // start of the search
    }
    // The velocities of a shift are increments of position, so they apply for one second.
    if (tangential == shift) {
        state.motion = WheelRailMotion::shift;
        state.time_step = 1;
    } else if (tangential == transient) {
        state.motion = WheelRailMotion::transient_rolling;
    }
    // Displacements of planar patches are computed on request.
    state.displacements = models_of(settings).model == Model::full && conformal_of(settings) != Conformal::off;
    return state;
}

}  // namespace contactd::cases
