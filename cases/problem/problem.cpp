#include "problem.hpp"

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "closed_forms/undeformed_distance.hpp"
#include "contactd/history.hpp"
#include "given/coefficients_file.hpp"
#include "given/given_friction.hpp"
#include "history/moved.hpp"
#include "problem/area.hpp"
#include "problem/case_models.hpp"

namespace contactd::cases {
namespace {

enum Tangential { none = 0, shift = 1, transient = 2, steady = 3 };
enum Previous { from_pressures = 1, anew = 2, again = 3 };
constexpr int of_sheet = 1;  // value of B
constexpr int of_file = 9;   // value of C

/// Throws NotCovered unless pressures and shape are both those of two half ellipses, or neither is.
void require_half_ellipses(const ContactProblem& problem, const Given& settings) {
    constexpr int half_ellipses = 4;
    const bool has_bound = settings.digits.bound == half_ellipses;
    if (has_bound != std::holds_alternative<HalfEllipses>(*problem.gap))
        throw NotCovered(Subject::input,
                         "Control digit B = 4 (flag 1971) and IPOTCN = -6 (cntc_sethertzcontact) require each other: "
                         "they describe pressures over two half ellipses. Use both or neither.");
}

Ics coefficients(const Given& settings) {
    Ics ics;
    if (settings.digits.influence == 3) ics.load_shape = LoadShape::bilinear;
    return ics;
}

const GivenFriction& friction_of(const Given& settings) {
    if (!settings.friction) throw NotCovered(Subject::friction, "No friction was given (cntc_setfrictionmethod).");
    return *settings.friction;
}

bool varies_by_row(const Given& settings) {
    return friction_of(settings).method / 10 == varies::by_row;
}

/// Returns the law on a grid. Friction by rows varies the coefficient at rest. Its dependence on slip or temperature is
/// the same in all rows.
FrictionLaw law_on(const Grid& grid, const GivenFriction& friction) {
    FrictionLaw law = friction.law;
    if (friction.by_row.empty()) return law;
    if (friction.by_row.size() != static_cast<std::size_t>(grid.ny))
        throw NotCovered(Subject::friction, "Friction by rows (V = 3) has " + std::to_string(friction.by_row.size()) +
                                                " rows, but there are MY = " + std::to_string(grid.ny) +
                                                " rows of elements.");
    law.mu.clear();
    for (const FrictionLaw& row : friction.by_row) {
        if (row.kinetic != law.kinetic)
            throw NotCovered(Subject::friction,
                             "Falling friction (L = 2, 3 or 4) that differs between rows (V = 3) is not supported. Use "
                             "the same law in all rows.");
        if (row.temperature != law.temperature)
            throw NotCovered(Subject::friction,
                             "Temperature-dependent friction (L = 6) that differs between rows (V = 3) is not "
                             "supported. Use the same TREF, DFHEAT and DTHEAT in all rows.");
        law.mu.insert(law.mu.end(), static_cast<std::size_t>(grid.nx), row.mu[0]);
    }
    return law;
}

/// Throws NotCovered if a law needs the slip velocity of a shift, but the time step is missing.
void require_velocity(const Given& settings, bool rolls) {
    if (!friction_of(settings).law.kinetic) return;
    if (!rolls && !settings.time_step)
        throw NotCovered(Subject::friction,
                         "Friction falls with the slip velocity, but no time step was given for the shift "
                         "(cntc_settimestep).");
}

Force force_of(const Given& settings, const ContactProblem& problem,
               const std::function<double(const ContactProblem&)>& normal_force) {
    const int prescribed = settings.digits.force;
    if (prescribed == 0) return {};
    if (!settings.force)
        throw NotCovered(Subject::input, "No tangential force FX was given (cntc_settangentialforces).");
    if (!problem.Fn && (problem.bodies.any_viscoelastic() || !problem.bodies.materials().quasi_identical()))
        throw NotCovered(Subject::input,
                         "Control digit F = " + std::to_string(prescribed) +
                             " (flag 1974) with N = 0 is not supported for dissimilar or viscoelastic bodies: FX and "
                             "FY are relative to the normal force, which is not known before the solve. Prescribe FN "
                             "with N = 1 (cntc_setnormalforce).");
    const double coefficient = varies_by_row(settings) ? 1 : friction_of(settings).law.mu[0];
    const double unit = coefficient * (problem.Fn ? *problem.Fn : normal_force(problem));
    // A force beyond friction becomes that of nearly full slip in its direction. Full slip would require unlimited
    // creepages, and the solver refuses forces from a millionth below it on.
    constexpr double full_slip = 1 - 2e-6;
    const double x = settings.force->x, y = prescribed == 2 ? settings.force->y : 0;
    const double size = std::hypot(x, y), scale = unit * (size > full_slip ? full_slip / size : 1);
    Force force;
    force.Fx = x * scale;
    if (prescribed == 2) force.Fy = y * scale;
    return force;
}

/// Returns whether spin acts along x or y alone, so that it becomes a slip of the elements.
bool has_split_spin(const Given& settings) {
    return settings.digits.extra_slip == 2 || settings.digits.extra_slip == 3;
}

/// Holds the motion of the origin, in mm and rad: creepages and spin, or shift and rotation.
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
        throw NotCovered(Subject::discretisation, "No rolling step DQ was given (cntc_setrollingstepsize).");
    motion.kind = RollingKind::transient;
    motion.dq = *settings.dq;
    return motion;
}

/// Returns the slip by spin along x or y alone. Like all spin, it is evaluated ahead of the element centres.
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
        throw NotCovered(Subject::input,
                         "Control digit E = " + std::to_string(settings.digits.extra_slip) +
                             " (flag 1980) requires an extra rigid slip of each element, but none was given "
                             "(cntc_setextrarigidslip).");
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
        throw NotCovered(Subject::friction, "Control digit L = " + std::to_string(settings.digits.friction_law) +
                                                " (flag 1976) differs from the given friction law " +
                                                std::to_string(friction.method % 10) +
                                                ". Use the same law in both (cntc_setfrictionmethod).");
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

/// Starts the search for a motion under a prescribed force from the motion found in the last case.
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

/// Returns whether a case continues from the end of an earlier one.
bool goes_on(const Given& settings) {
    const int kind = settings.digits.tangential;
    return settings.digits.previous != anew && (kind == shift || kind == transient);
}

void continue_from(ContactProblem& problem, const Given& settings, const LastCase& last) {
    const Grid &now = problem.grid, &before = last.problem.grid;
    if (settings.digits.estimate != 0 && now.nx == before.nx && now.ny == before.ny) {
        problem.initial = end_of(last.solution);
        if (last.solution.motion) estimate_motion(problem, *last.solution.motion);
    }
    if (!goes_on(settings)) return;
    const SurfaceState end = settings.digits.previous == again ? last.problem.previous : end_of(last.solution);
    problem.previous = on_grid(end, before, now, *problem.friction);
}

}  // namespace

void refuse_history_of_pressures() {
    throw NotCovered(Subject::input,
                     "Control digit P = 1 (flag 1970) is not supported: a step that starts from the pressures of the "
                     "last case without its tractions. Use 0, 2 or 3.");
}

std::optional<ThermalBodies> heat_of(const Given& settings) {
    if (settings.digits.heat == 0) return std::nullopt;
    if (settings.digits.tangential != steady)
        throw NotCovered(Subject::input, "Control digit H = " + std::to_string(settings.digits.heat) +
                                             " (flag 1982) is not supported without steady rolling. Use T = 3 (flag "
                                             "1972), or H = 0 for no temperatures.");
    if (!settings.heat)
        throw NotCovered(Subject::input, "Control digit H = " + std::to_string(settings.digits.heat) +
                                             " (flag 1982) requires thermal data of the bodies, but none were given "
                                             "(cntc_settemperaturedata with method 3).");
    return settings.heat;
}

ContactProblem problem_of(const Given& settings, const LastCase* last,
                          const std::function<double(const ContactProblem&)>& normal_force) {
    if (!settings.materials)
        throw NotCovered(Subject::input, "No material constants were given (cntc_setmaterialparameters).");
    const bool continues = last != nullptr && goes_on(settings);
    if (continues && settings.digits.previous == from_pressures) refuse_history_of_pressures();
    Area area = area_of(settings, continues ? &last->problem.grid : nullptr);
    ContactProblem problem;
    problem.grid = area.grid;
    problem.gap = std::move(area.gap);
    problem.regions = std::move(area.regions);
    if (settings.digits.bound == of_sheet) problem.sheet_flexibility = settings.sheet;
    problem.bodies = Bodies::of(solved_materials(*settings.materials), coefficients(settings));
    const auto creep = creep_of(settings);
    if (settings.digits.influence == of_file) {
        if (!settings.coefficients)
            throw NotCovered(Subject::input,
                             "Control digit C = 9 (flag 1978) requires coefficients that only an input file can give "
                             "(cntc_readinpfile).");
        if (creep)
            throw NotCovered(Subject::input,
                             "Control digits C = 9 (flag 1978) and M = 1 (flag 1979) together are not supported: "
                             "coefficients from a file do not creep. Use C = 2 or M = 0.");
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
        if (!settings.fn) throw NotCovered(Subject::input, "No normal force FN was given (cntc_setnormalforce).");
        problem.Fn = settings.fn;
    } else {
        if (!settings.pen) throw NotCovered(Subject::input, "No penetration PEN was given (cntc_setpenetration).");
        problem.approach = settings.pen;
    }
    // The curvatures of a given ellipse are those of half-spaces, and of creeping bodies without their creep.
    if (creep || (problem.bodies.pair && std::holds_alternative<SemiAxes>(*problem.gap)))
        if (const auto paraboloid = paraboloid_of(problem)) problem.gap = *paraboloid;
    if (creep) {
        problem.bodies.upper.viscoelastic = creep->front();
        problem.bodies.lower.viscoelastic = creep->back();
    }
    validate_opening(problem);  // Friction is added below.
    add_friction(problem, settings, normal_force);
    if (last != nullptr) continue_from(problem, settings, *last);
    validate(problem);
    return problem;
}

}  // namespace contactd::cases
