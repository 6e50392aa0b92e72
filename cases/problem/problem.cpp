#include "problem.hpp"

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "closed_forms/undeformed_distance.hpp"
#include "given/coefficients_file.hpp"
#include "given/given_friction.hpp"
#include "history/moved.hpp"
#include "problem/area.hpp"
#include "problem/case_models.hpp"

namespace contactd::cases {
namespace {

enum Tangential { none = 0, shift = 1, transient = 2, steady = 3 };
enum Previous { from_pressures = 1, anew = 2, again = 3 };
constexpr int of_sheet = 1;  // B
constexpr int of_file = 9;   // C

/// Pressures over two half ellipses and their shape go together.
void require_half_ellipses(const ContactProblem& problem, const Given& settings) {
    constexpr int half_ellipses = 4;
    const bool has_bound = settings.digits.bound == half_ellipses;
    if (has_bound != std::holds_alternative<HalfEllipses>(*problem.gap))
        throw NotCovered(Subject::input,
                         "Flag 1971 = 4 and ipotcn = -6 of cntc_sethertzcontact, pressures over two half ellipses, go "
                         "together. Set both or neither.");
}

Ics coefficients(const Given& settings) {
    Ics ics;
    if (settings.digits.influence == 3) ics.load_shape = LoadShape::bilinear;
    return ics;
}

const GivenFriction& friction_of(const Given& settings) {
    if (!settings.friction) throw NotCovered(Subject::friction, "No friction was set; call cntc_setfrictionmethod.");
    return *settings.friction;
}

bool varies_by_row(const Given& settings) {
    return friction_of(settings).method / 10 == varies::by_row;
}

/// Friction of rows has their coefficients at rest. What it falls by, with the slip or the temperature, is the same in
/// all.
FrictionLaw law_on(const Grid& grid, const GivenFriction& friction) {
    FrictionLaw law = friction.law;
    if (friction.by_row.empty()) return law;
    if (friction.by_row.size() != static_cast<std::size_t>(grid.ny))
        throw NotCovered(Subject::friction, "Friction by rows (V = 3) has " + std::to_string(friction.by_row.size()) +
                                                " rows; there are " + std::to_string(grid.ny) + " of elements.");
    law.mu.clear();
    for (const FrictionLaw& row : friction.by_row) {
        if (row.kinetic != law.kinetic)
            throw NotCovered(Subject::friction,
                             "contactd does not have: falling friction that is another one from place to place (V).");
        if (row.temperature != law.temperature)
            throw NotCovered(
                Subject::friction,
                "contactd does not have: friction by temperature that is another one from row to row (V, L = 6).");
        law.mu.insert(law.mu.end(), static_cast<std::size_t>(grid.nx), row.mu[0]);
    }
    return law;
}

/// Laws that fall with the slip velocity need to know it.
void require_velocity(const Given& settings, bool rolls) {
    if (!friction_of(settings).law.kinetic) return;
    if (!rolls && !settings.time_step)
        throw NotCovered(Subject::friction,
                         "Friction falls with the slip velocity, and no time step was set; call cntc_settimestep.");
}

Force force_of(const Given& settings, const ContactProblem& problem,
               const std::function<double(const ContactProblem&)>& normal_force) {
    const int prescribed = settings.digits.force;
    if (prescribed == 0) return {};
    if (!settings.force)
        throw NotCovered(Subject::input, "No tangential force was set; call cntc_settangentialforces.");
    if (!problem.Fn && (problem.bodies.any_viscoelastic() || !problem.bodies.materials().quasi_identical()))
        throw NotCovered(
            Subject::input,
            "Tangential forces are relative to the normal force, which is not known before the solve where "
            "the penetration is prescribed and the bodies differ or creep; prescribe the normal force.");
    const double coefficient = varies_by_row(settings) ? 1 : friction_of(settings).law.mu[0];
    const double unit = coefficient * (problem.Fn ? *problem.Fn : normal_force(problem));
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

/// Spin may act along x or along y alone: it is slip of the elements then.
bool has_split_spin(const Given& settings) {
    return settings.digits.extra_slip == 2 || settings.digits.extra_slip == 3;
}

/// The motion of the origin, in mm and rad: creepages and spin, or shift and rotation.
struct PlaneMotion {
    double x, y, phi;
};

PlaneMotion motion_of_plane(const Given& settings, bool rolls) {
    const GivenMotion given = settings.motion.value_or(GivenMotion{});
    const double x = rolls ? given.vx : given.vx * given.length, y = rolls ? given.vy : given.vy * given.length;
    const double phi = rolls ? given.phi / given.length : given.phi;
    if (has_split_spin(settings)) return {x, y, 0};
    if (settings.spin_x == 0 && settings.spin_y == 0) return {x, y, phi};
    return {x + phi * settings.spin_y, y - phi * settings.spin_x, phi};
}

Motion shift_of(const Given& settings, const PlaneMotion& given, const Force& force) {
    Shift motion;
    motion.rigid_shift = {given.x, given.y};
    motion.rotation = given.phi;
    motion.duration = settings.time_step.value_or(motion.duration);
    motion.force = force;
    return motion;
}

Motion rolling_of(const Given& settings, const PlaneMotion& given, const Force& force, const Grid& grid) {
    Rolling motion;
    motion.xi = given.x;
    motion.eta = given.y;
    motion.phi = given.phi;
    motion.chi = settings.chi;
    motion.spin_offset = settings.spin_offset;
    motion.velocity = settings.velocity.value_or(usual_velocity);
    motion.force = force;
    motion.dq = grid.dx;
    if (settings.digits.tangential == steady) return motion;
    if (!settings.dq)
        throw NotCovered(Subject::discretisation, "No rolling step was set; call cntc_setrollingstepsize.");
    motion.kind = RollingKind::transient;
    motion.dq = *settings.dq;
    return motion;
}

/// Slip by the spin that acts in one direction alone, evaluated ahead of the centres of the elements as all spin is.
RigidSlip slip_of_spin(const Given& settings, const Grid& grid, const Motion& motion) {
    const auto* rolling = std::get_if<Rolling>(&motion);
    const GivenMotion given = settings.motion.value_or(GivenMotion{});
    const double phi = rolling ? given.phi / given.length : given.phi;
    const double ahead = rolling ? settings.spin_offset * step_length(*rolling, grid) : 0;
    const double ahead_x = ahead * std::cos(settings.chi), ahead_y = ahead * std::sin(settings.chi);
    RigidSlip slip{std::vector<double>(grid.size()), std::vector<double>(grid.size())};
    std::size_t i = 0;
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix, ++i) {
            if (settings.digits.extra_slip == 2)
                slip.x[i] = 0 - phi * (grid.y(iy) + ahead_y - settings.spin_y);
            else
                slip.y[i] = phi * (grid.x(ix) + ahead_x - settings.spin_x);
        }
    return slip;
}

RigidSlip extra_slip(const Given& settings, const Grid& grid, const Motion& motion) {
    if (settings.digits.extra_slip == 0) return {};
    if (has_split_spin(settings)) return slip_of_spin(settings, grid, motion);
    const bool rolls = std::holds_alternative<Rolling>(motion);
    if (!settings.extra_slip)
        throw NotCovered(Subject::input, "No rigid slip of the elements was set; call cntc_setextrarigidslip.");
    RigidSlip slip{settings.extra_slip->x, settings.extra_slip->y};
    if (!rolls)
        for (auto* component : {&slip.x, &slip.y})
            for (double& s : *component) s *= settings.extra_slip->length;
    return slip;
}

void add_friction(ContactProblem& problem, const Given& settings,
                  const std::function<double(const ContactProblem&)>& normal_force) {
    const int kind = settings.digits.tangential;
    if (kind == none) return;
    const bool rolls = kind != shift;
    const GivenFriction& friction = friction_of(settings);
    if (settings.digits.friction_law != friction.method % 10)
        throw NotCovered(Subject::friction, "Flag 1976 and cntc_setfrictionmethod name different laws.");
    require_velocity(settings, rolls);
    const Force force = force_of(settings, problem, normal_force);
    const PlaneMotion given = motion_of_plane(settings, rolls);
    problem.friction = law_on(problem.grid, friction);
    if (problem.friction->kinetic && settings.starts_in_slip) problem.friction->kinetic->start = SlipStart::full_slip;
    forget_memory(problem.friction->kinetic, problem.model);
    problem.friction->layer = layer_of(settings);
    problem.temperature = heat_of(settings);
    problem.motion = rolls ? rolling_of(settings, given, force, problem.grid) : shift_of(settings, given, force);
    problem.rigid_slip = extra_slip(settings, problem.grid, problem.motion);
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

/// Tells whether a case starts from the end of one before.
bool goes_on(const Given& settings) {
    const int kind = settings.digits.tangential;
    return settings.digits.previous != anew && (kind == shift || kind == transient);
}

void continue_from(ContactProblem& problem, const Given& settings, const LastCase& last) {
    const Grid &now = problem.grid, &before = last.problem.grid;
    if (settings.digits.estimate != 0 && now.nx == before.nx && now.ny == before.ny) {
        problem.initial = state_of(last.solution);
        if (last.solution.motion) estimate_motion(problem, *last.solution.motion);
    }
    if (!goes_on(settings)) return;
    const SurfaceState end = settings.digits.previous == again ? last.problem.previous : state_of(last.solution);
    problem.previous = on_grid(end, before, now, *problem.friction);
}

}  // namespace

void refuse_history_of_pressures() {
    throw NotCovered(
        Subject::input,
        "Flag 1970 = 1: a step that starts from the pressures of the last case, without its tractions, is not "
        "supported. Set it to 0, 2 or 3.");
}

std::optional<ThermalBodies> heat_of(const Given& settings) {
    if (settings.digits.heat == 0) return std::nullopt;
    if (settings.digits.tangential != steady)
        throw NotCovered(
            Subject::input,
            "Temperatures (flag 1982) are those of steady rolling; set flag 1972 to 3, or flag 1982 to 0.");
    if (!settings.heat)
        throw NotCovered(Subject::input, "Nothing was set of heat; call cntc_settemperaturedata with method 3.");
    return settings.heat;
}

ContactProblem problem_of(const Given& settings, const LastCase* last,
                          const std::function<double(const ContactProblem&)>& normal_force) {
    if (!settings.materials) throw NotCovered(Subject::input, "No material was set; call cntc_setmaterialparameters.");
    const bool continues = last != nullptr && goes_on(settings);
    if (continues && settings.digits.previous == from_pressures) refuse_history_of_pressures();
    Area area = area_of(settings, continues ? &last->problem.grid : nullptr);
    ContactProblem problem;
    problem.grid = area.grid;
    problem.gap = std::move(area.gap);
    problem.regions = std::move(area.regions);
    if (settings.digits.bound == of_sheet) problem.sheet_flexibility = settings.sheet;
    problem.bodies = Bodies::of(solved_materials(*settings.materials), coefficients(settings));
    if (settings.digits.influence == of_file) {
        if (!settings.coefficients)
            throw NotCovered(Subject::input, "C = 9 (flag 1978): a file of CONTACT alone can set coefficients.");
        problem.bodies.pair = with_offsets(*settings.coefficients, problem.grid);
    }
    problem.settings = settings.solvers;
    if (settings.one_outer_iteration && !problem.bodies.materials().quasi_identical())
        problem.settings.outer.max_iterations = 1;
    require_half_ellipses(problem, settings);
    const CaseModels models = models_of(settings);
    problem.model = models.model;
    problem.normal_model = models.normal_model;
    problem.simplified = models.simplified;
    if (settings.digits.normal == 1) {
        if (!settings.fn) throw NotCovered(Subject::input, "No normal force was set; call cntc_setnormalforce.");
        problem.Fn = settings.fn;
    } else {
        if (!settings.pen) throw NotCovered(Subject::input, "No penetration was set; call cntc_setpenetration.");
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

}  // namespace contactd::cases
