#include "problem.hpp"

#include <cmath>

#include "closed_forms/undeformed_distance.hpp"
#include "edge/codes.hpp"
#include "problem/area.hpp"
#include "problem/case_models.hpp"

namespace contactd::cntc {
namespace {

enum Tangential { none = 0, shift = 1, transient = 2, steady = 3 };
enum Previous { from_pressures = 1, anew = 2, again = 3 };

void require_nothing_refused(const Settings& settings) {
    if (!settings.refused.empty()) throw settings.refused.begin()->second;
}

/// Pressures over two half ellipses and their shape go together.
void require_half_ellipses(const ContactProblem& problem, const Settings& settings) {
    constexpr int half_ellipses = 4;
    const bool has_bound = settings.digits(flag::bound) == half_ellipses;
    if (has_bound != std::holds_alternative<HalfEllipses>(*problem.gap))
        throw Refused(error_code::input,
                      "Flag 1971 = 4 and ipotcn = -6 of cntc_sethertzcontact, pressures over two half ellipses, go "
                      "together. Set both or neither.");
}

Ics coefficients(const Settings& settings) {
    Ics ics;
    if (settings.digits(flag::influence) == 3) ics.load_shape = LoadShape::bilinear;
    return ics;
}

const GivenFriction& friction_of(const Settings& settings) {
    if (!settings.friction) throw Refused(error_code::friction, "No friction was set; call cntc_setfrictionmethod.");
    return *settings.friction;
}

/// Laws that fall with the slip velocity need to know it.
void require_velocity(const Settings& settings, bool rolls) {
    if (!friction_of(settings).law.kinetic) return;
    if (!rolls && !settings.time_step)
        throw Refused(error_code::friction,
                      "Friction falls with the slip velocity, and no time step was set; call cntc_settimestep.");
}

Force force_of(const Settings& settings, const ContactProblem& problem,
               const std::function<double(const ContactProblem&)>& normal_force) {
    const int prescribed = settings.digits(flag::force);
    if (prescribed == 0) return {};
    if (!settings.force)
        throw Refused(error_code::input, "No tangential force was set; call cntc_settangentialforces.");
    if (!problem.Fn && (problem.bodies.any_viscoelastic() || !problem.bodies.materials().quasi_identical()))
        throw Refused(error_code::input,
                      "Tangential forces are relative to the normal force, which is not known before the solve where "
                      "the penetration is prescribed and the bodies differ or creep; prescribe the normal force.");
    const double unit = friction_of(settings).law.mu[0] * (problem.Fn ? *problem.Fn : normal_force(problem));
    // A force beyond friction becomes that of full slip along it, which only ever larger creepages come near;
    // from a millionth below on the solver refuses it.
    constexpr double full_slip = 1 - 2e-6;
    const double x = settings.force->x, y = prescribed == 2 ? settings.force->y : 0;
    const double size = std::hypot(x, y), scale = unit * (size > full_slip ? full_slip / size : 1);
    Force force;
    force.Fx = x * scale;
    if (prescribed == 2) force.Fy = y * scale;
    return force;
}

Motion shift_of(const Settings& settings, const GivenMotion& given, const Force& force) {
    Shift motion;
    motion.rigid_shift = {given.vx * given.length, given.vy * given.length};
    motion.rotation = given.phi;
    motion.duration = settings.time_step.value_or(motion.duration);
    motion.force = force;
    return motion;
}

Motion rolling_of(const Settings& settings, const GivenMotion& given, const Force& force, const Grid& grid) {
    Rolling motion;
    motion.xi = given.vx;
    motion.eta = given.vy;
    motion.phi = given.phi / given.length;
    motion.chi = settings.chi;
    motion.spin_offset = spin_offset;
    motion.velocity = settings.velocity.value_or(usual_velocity);
    motion.force = force;
    motion.dq = grid.dx;
    if (settings.digits(flag::tangential) == steady) return motion;
    if (!settings.dq)
        throw Refused(error_code::discretisation, "No rolling step was set; call cntc_setrollingstepsize.");
    motion.kind = RollingKind::transient;
    motion.dq = *settings.dq;
    return motion;
}

RigidSlip extra_slip(const Settings& settings, bool rolls) {
    if (settings.digits(flag::extra_slip) == 0) return {};
    if (!settings.extra_slip)
        throw Refused(error_code::input, "No rigid slip of the elements was set; call cntc_setextrarigidslip.");
    RigidSlip slip{settings.extra_slip->x, settings.extra_slip->y};
    if (!rolls)
        for (auto* component : {&slip.x, &slip.y})
            for (double& s : *component) s *= settings.extra_slip->length;
    return slip;
}

void add_friction(ContactProblem& problem, const Settings& settings,
                  const std::function<double(const ContactProblem&)>& normal_force) {
    const int kind = settings.digits(flag::tangential);
    if (kind == none) return;
    const bool rolls = kind != shift;
    const GivenFriction& friction = friction_of(settings);
    if (settings.digits(flag::friction_law) != friction.method)
        throw Refused(error_code::friction, "Flag 1976 and cntc_setfrictionmethod name different laws.");
    require_velocity(settings, rolls);
    const Force force = force_of(settings, problem, normal_force);
    const GivenMotion given = settings.motion.value_or(GivenMotion{});
    problem.friction = friction.law;
    if (problem.friction->kinetic && settings.starts_in_slip) problem.friction->kinetic->start = SlipStart::full_slip;
    forget_memory(problem.friction->kinetic, problem.model);
    problem.friction->layer = layer_of(settings);
    problem.temperature = heat_of(settings);
    problem.motion = rolls ? rolling_of(settings, given, force, problem.grid) : shift_of(settings, given, force);
    problem.rigid_slip = extra_slip(settings, rolls);
}

SurfaceState state_of(const ContactSolution& solution) {
    return {solution.pressure, solution.traction_x, solution.traction_y, solution.yield_stress,
            solution.friction_coefficient};
}

/// The motion that a force made of the last case is where the search for the next one starts.
void estimate_motion(ContactProblem& problem, const Motion& found) {
    if (auto* next = std::get_if<Rolling>(&problem.motion)) {
        const auto* last = std::get_if<Rolling>(&found);
        if (last == nullptr) return;
        if (next->force.Fx) next->xi = last->xi;
        if (next->force.Fy) next->eta = last->eta;
        return;
    }
    auto& next = std::get<Shift>(problem.motion);
    const auto* last = std::get_if<Shift>(&found);
    if (last == nullptr) return;
    if (next.force.Fx) next.rigid_shift.x = last->rigid_shift.x;
    if (next.force.Fy) next.rigid_shift.y = last->rigid_shift.y;
}

void continue_from(ContactProblem& problem, const Settings& settings, const LastCase& last) {
    const Grid &now = problem.grid, &before = last.problem.grid;
    if (settings.digits(flag::estimate) != 0 && now.nx == before.nx && now.ny == before.ny) {
        problem.initial = state_of(last.solution);
        if (last.solution.motion) estimate_motion(problem, *last.solution.motion);
    }
    const int kind = settings.digits(flag::tangential), previous = settings.digits(flag::previous);
    if (previous == anew || (kind != shift && kind != transient)) return;
    if (previous == from_pressures) refuse_history_of_pressures();
    if (now != before)
        throw Refused(error_code::discretisation,
                      "The case continues from one on other elements (flag 1970 is 0); keep the elements, or start "
                      "anew.");
    problem.previous = previous == again ? last.problem.previous : state_of(last.solution);
}

}  // namespace

void refuse_history_of_pressures() {
    throw Refused(
        error_code::input,
        "Flag 1970 = 1: a step that starts from the pressures of the last case, without its tractions, is not "
        "supported. Set it to 0, 2 or 3.");
}

std::optional<ThermalBodies> heat_of(const Settings& settings) {
    if (settings.digits(flag::heat) == 0) return std::nullopt;
    if (settings.digits(flag::tangential) != steady)
        throw Refused(error_code::input,
                      "Temperatures (flag 1982) are those of steady rolling; set flag 1972 to 3, or flag 1982 to 0.");
    if (!settings.heat)
        throw Refused(error_code::input, "Nothing was set of heat; call cntc_settemperaturedata with method 3.");
    return settings.heat;
}

ContactProblem problem_of(const Settings& settings, const LastCase* last,
                          const std::function<double(const ContactProblem&)>& normal_force) {
    require_nothing_refused(settings);
    if (!settings.materials) throw Refused(error_code::input, "No material was set; call cntc_setmaterialparameters.");
    Area area = area_of(settings);
    ContactProblem problem;
    problem.grid = area.grid;
    problem.gap = std::move(area.gap);
    problem.bodies = Bodies::of(solved_materials(*settings.materials), coefficients(settings));
    problem.settings = settings.solvers;
    if (settings.one_outer_iteration && !problem.bodies.materials().quasi_identical())
        problem.settings.outer.max_iterations = 1;
    require_half_ellipses(problem, settings);
    const CaseModels models = models_of(settings);
    problem.model = models.model;
    problem.normal_model = models.normal_model;
    problem.simplified = models.simplified;
    if (settings.digits(flag::normal) == 1) {
        if (!settings.fn) throw Refused(error_code::input, "No normal force was set; call cntc_setnormalforce.");
        problem.Fn = settings.fn;
    } else {
        if (!settings.pen) throw Refused(error_code::input, "No penetration was set; call cntc_setpenetration.");
        problem.approach = settings.pen;
    }
    if (settings.creep) {
        // The curvatures of an ellipse are those of the bodies at once.
        if (const auto paraboloid = paraboloid_of(problem)) problem.gap = *paraboloid;
        problem.bodies.upper.viscoelastic = settings.creep->front();
        problem.bodies.lower.viscoelastic = settings.creep->back();
    }
    validate_opening(problem);  // friction comes
    add_friction(problem, settings, normal_force);
    if (last != nullptr) continue_from(problem, settings, *last);
    validate(problem);
    return problem;
}

}  // namespace contactd::cntc
