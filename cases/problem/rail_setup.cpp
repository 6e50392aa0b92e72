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

/// By how much distances that are the same to other programs are apart here (mm).
constexpr double near = 1e-6;

double outwards(const Given& settings) {
    return on_left_side(settings) ? -1 : 1;
}

/// Returns whether a roller's surface leans with its profile, by its deviation or its cant; of rails the profile alone
/// does.
bool leans(const GivenRail& rail) {
    return rail.deviation.roll != 0 || rail.track.cant != 0;
}

/// A roller goes along with its axle where its profile is placed itself.
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
            throw NotCovered(Subject::input, "The radius of the roller is not positive; call cntc_settrackdimensions.");
        if (rail.deviation.z != 0 && given.gauge_height > 0)
            throw NotCovered(Subject::input,
                             "The roller deviates with its axle, which contactd has only where its profile is placed "
                             "itself (gaught <= 0).");
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

/// Only where the profile lies along the axle matters, so that distances that no flanges have become others.
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

/// Half-spaces that turn, by their variant: both loads and displacements turn by 4, displacements alone by 3.
Conformal rotated_of(int variant) {
    constexpr int of_displacements = 3;
    if (variant < of_displacements)
        throw NotCovered(
            Subject::other,
            "contactd does not have: half-spaces that turn with their loads (C = 4, VARIANT = 1, 2). Set flag "
            "1990 to 3 or 4.");
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
                         "Half-spaces that turn (flag 1978 is 4) are those of a curved contact; set flag 1977 to 4.");
    return Conformal::off;
}

/// Angles are those against the wheel's profile where the contact is a plane, and else against the track; contactd's
/// are against the track, and of left wheels those of the mirror image.
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
            throw NotCovered(Subject::friction, "Friction falls otherwise from angle to angle; give one fall for all.");
        friction.mu.push_back({angle + offset, law.mu[0]});
        if (const auto& heated = law.temperature) {
            friction.temperature_by_angle.push_back({angle + offset, heated->change, heated->reference, heated->range});
            friction.memory = heated->memory;
        }
    }
    return friction;
}

WheelRailFriction friction_of(const Given& settings, const GivenRail& rail) {
    if (!settings.friction) throw NotCovered(Subject::friction, "No friction was set; call cntc_setfrictionmethod.");
    const GivenFriction& given = *settings.friction;
    if (settings.digits.friction_law != given.method % 10)
        throw NotCovered(Subject::friction, "Flag 1976 and cntc_setfrictionmethod name different laws.");
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
                                                   " was set; call cntc_setprofileinputfname or "
                                                   "cntc_setprofileinputvalues.");
    if (!settings.materials) throw NotCovered(Subject::input, "No material was set; call cntc_setmaterialparameters.");
    if (!rail.elements)
        throw NotCovered(Subject::discretisation, "No sizes of elements were set; call cntc_setpotcontact.");
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
        throw NotCovered(
            Subject::input,
            "The simplified theory on pressures of the full theory (flag 1971 is 0) is not there for a wheel on "
            "a rail; set flag 1971 to 5 or 6, or flag 1979 to 0.");
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

/// Returns the pitch rate without creepage, near which the one that brings Fx is found.
double free_pitch_rate(const GivenRail& rail, const WheelRailState& state) {
    return -(state.velocity.x + state.roller_pitch * rail.track.roller_radius) / rail.wheelset.nominal_radius;
}

/// In a plane a wheel that is displaced along the track turns about the axle of the rigid wheelset; contactd's turns
/// about an axle that goes along with it.
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
        if (!rail.Fz) throw NotCovered(Subject::input, "No vertical force was set; call cntc_setverticalforce.");
        state.Fz = rail.Fz;
    } else if (!state.position.z) {
        throw NotCovered(Subject::input,
                         "No height of the wheelset was set; call cntc_setwheelsetposition, or cntc_setverticalforce.");
    }
    if (force == longitudinal) {
        if (!rail.Fx) throw NotCovered(Subject::input, "No longitudinal force was set; call cntc_settangentialforces.");
        state.Fx = rail.Fx;
        if (state.velocity.pitch == 0) state.velocity.pitch = free_pitch_rate(rail, state);  // where the search starts
    }
    // Velocities of a shift are increments: those of a second.
    if (tangential == shift) {
        state.motion = WheelRailMotion::shift;
        state.time_step = 1;
    } else if (tangential == transient) {
        state.motion = WheelRailMotion::transient_rolling;
    }
    // Those of a plane patch are found when they are asked for.
    state.displacements = models_of(settings).model == Model::full && conformal_of(settings) != Conformal::off;
    return state;
}

}  // namespace contactd::cases
