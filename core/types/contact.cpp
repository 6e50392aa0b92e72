#include "contactd/contact.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "area/contact_columns_check.hpp"
#include "contactd/error.hpp"
#include "contactd/fields/contact_setup.hpp"
#include "contactd/fields/grid_arrays.hpp"
#include "fatigue/contact_fatigue_check.hpp"
#include "heat/contact_temperature_check.hpp"
#include "magnitude.hpp"
#include "models/force_accuracy_check.hpp"
#include "number_text.hpp"
#include "wear/contact_wear_check.hpp"

namespace contactd {
namespace {

void check_array(const std::vector<double>& values, std::size_t size, const std::string& field) {
    if (values.size() != size)
        throw InvalidArgument(field, "has " + std::to_string(values.size()) + " values; the grid has " +
                                         std::to_string(size) + " elements");
    // Each value is read only once, because small steps notice the cost. Comparisons with NaN are false.
    const auto is_in_range = [](double value) { return std::abs(value) <= largest_magnitude; };
    if (std::all_of(values.begin(), values.end(), is_in_range)) return;
    if (!std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }))
        throw InvalidArgument(field, "contains a value that is not finite");
    for (const double value : values)
        if (std::abs(value) > largest_magnitude)
            throw InvalidArgument(field, "contains " + number_text(value) + "; its values must lie in [-1e100, 1e100]");
}

void check_state(const SurfaceState& state, std::size_t size, const std::string& field) {
    for (const HistoryArray& array : history_arrays) {
        const std::vector<double>& values = state.*array.before;
        if (values.empty()) continue;
        const std::string name = field + "." + std::string(array.name);
        check_array(values, size, name);
        if (array.is_traction()) continue;
        for (const double value : values)
            if (!array.bounds.contain(value))
                throw InvalidArgument(name, "has " + number_text(value) + "; it must be " +
                                                (array.bounds.least_excluded ? "positive" : "zero or positive"));
    }
}

void check_finite(double value, const std::string& field, const char* meaning) {
    if (!std::isfinite(value)) throw InvalidArgument(field, std::string("is not finite; it must be ") + meaning);
}

void check_positive(double value, const std::string& field) {
    if (!(std::isfinite(value) && value > 0))
        throw InvalidArgument(field, "is " + number_text(value) + "; it must be positive and finite");
    check_magnitude(value, field);
}

void check_settings(const SolverSettings& settings, const std::string& field) {
    if (!(settings.tolerance > 0 && settings.tolerance < 1))
        throw InvalidArgument(field + ".tolerance",
                              "is " + number_text(settings.tolerance) + "; it must lie in (0, 1)");
    if (settings.max_iterations < 1)
        throw InvalidArgument(field + ".max_iterations",
                              "is " + std::to_string(settings.max_iterations) + "; it must be at least 1");
}

void check_radius(double radius, const char* field) {
    if (std::isnan(radius) || radius == 0)
        throw InvalidArgument(field, "is " + number_text(radius) + "; it must be a length other than zero");
    check_magnitude(radius, field);
}

bool prescribes_pressures(NormalModel model) {
    return model == NormalModel::elliptic || model == NormalModel::parabolic;
}

void check_half_ellipses(const ContactProblem& problem, const HalfEllipses& halves) {
    check_positive(halves.a, "gap.half_ellipses.a");
    check_positive(halves.b_negative, "gap.half_ellipses.b_negative");
    check_positive(halves.b_positive, "gap.half_ellipses.b_positive");
    if (!prescribes_pressures(problem.normal_model))
        throw InvalidArgument(
            "gap.half_ellipses",
            "require prescribed pressures: set normal_model to elliptic or parabolic, or give another gap");
    if (problem.approach) throw InvalidArgument("approach", "cannot be prescribed with gap.half_ellipses: give Fn");
    if (problem.Fn && !(*problem.Fn > 0))
        throw InvalidArgument("Fn", "is " + number_text(*problem.Fn) + "; with gap.half_ellipses it must be positive");
}

void check_gap(const ContactProblem& problem) {
    if (!problem.gap) return;
    if (const auto* array = std::get_if<std::vector<double>>(&*problem.gap))
        check_array(*array, problem.grid.size(), "gap.array");
    if (const auto* paraboloid = std::get_if<Paraboloid>(&*problem.gap)) {
        check_radius(paraboloid->Rx, "gap.paraboloid.Rx");
        check_radius(paraboloid->Ry, "gap.paraboloid.Ry");
    }
    if (const auto* halves = std::get_if<HalfEllipses>(&*problem.gap)) check_half_ellipses(problem, *halves);
    if (const auto* axes = std::get_if<SemiAxes>(&*problem.gap)) {
        check_positive(axes->a, "gap.semi_axes.a");
        check_positive(axes->b, "gap.semi_axes.b");
        if (problem.bodies.any_layered() || problem.bodies.any_uniform())
            throw InvalidArgument(
                "gap.semi_axes",
                "are those of half-spaces, but a body has layers or a section; give a paraboloid or an array");
        if (problem.bodies.pair)
            throw InvalidArgument("gap.semi_axes",
                                  "requires the materials of the bodies, which a table in the request does not "
                                  "contain; give a paraboloid or an array");
        const std::optional<double> load = problem.Fn ? problem.Fn : problem.approach;
        if (load && !(*load > 0))
            throw InvalidArgument(
                problem.Fn ? "Fn" : "approach",
                "is " + number_text(*load) +
                    "; with gap.semi_axes it must be positive, because the curvatures follow from it");
    }
}

// Areas and approaches of smaller forces are below the range of a double.
constexpr double least_force = 1e-100;

void check_load(const ContactProblem& problem) {
    check_finite(problem.approach.value_or(0), "approach", "a length");
    if (problem.Fn && *problem.Fn > 0 && *problem.Fn < least_force)
        throw InvalidArgument("Fn", "is " + number_text(*problem.Fn) + "; it must be zero or at least 1e-100 N");
    if (problem.Fn && !(std::isfinite(*problem.Fn) && *problem.Fn >= 0))
        throw InvalidArgument("Fn", "is " + number_text(*problem.Fn) + "; it must be a force, zero or positive");
}

void check_force(const Force& force, const char* field) {
    check_finite(force.Fx.value_or(0), field, "a force");
    check_finite(force.Fy.value_or(0), field, "a force");
}

void check_motion(const Shift& shift, const Grid&) {
    check_finite(shift.rigid_shift.x, "friction.rigid_shift", "a length");
    check_finite(shift.rigid_shift.y, "friction.rigid_shift", "a length");
    check_finite(shift.rotation, "friction.rotation", "an angle");
    check_positive(shift.duration, "friction.duration");
    check_force(shift.force, "friction.force");
}

// Displacements less than a millionth of an element apart do not differ by a useful number of digits.
void check_step(const Rolling& rolling, const Grid& grid) {
    const double least = 1e-6 * size_along(rolling.chi, grid.dx, grid.dy), most = 1e5 * std::min(grid.dx, grid.dy);
    if (rolling.dq == 0 || (rolling.dq >= least && rolling.dq <= most)) return;
    throw InvalidArgument("friction.rolling.dq", "is " + number_text(rolling.dq) + "; it must lie in [" +
                                                     number_text(least) + ", " + number_text(most) +
                                                     "], which is 1e-6 to 1e5 elements");
}

void check_motion(const Rolling& rolling, const Grid& grid) {
    check_finite(rolling.xi, "friction.rolling.xi", "a creepage");
    check_finite(rolling.eta, "friction.rolling.eta", "a creepage");
    check_finite(rolling.phi, "friction.rolling.phi", "a spin creepage");
    check_finite(rolling.chi, "friction.rolling.chi", "an angle");
    if (!(rolling.spin_offset >= 0 && rolling.spin_offset <= 1))
        throw InvalidArgument("friction.rolling.spin_offset", "is " + number_text(rolling.spin_offset) +
                                                                  "; it must lie in [0, 1], in units of the step dq");
    check_force(rolling.force, "friction.rolling.force");
    check_positive(rolling.velocity, "friction.rolling.velocity");
    check_step(rolling, grid);
    if (rolling.steps < 1)
        throw InvalidArgument("friction.rolling.steps",
                              "is " + std::to_string(rolling.steps) + "; it must be at least 1");
}

void check_coefficients(const FrictionLaw& friction, std::size_t size) {
    if (friction.mu.size() != 1) check_array(friction.mu, size, "friction.mu");
    for (const double mu : friction.mu)
        if (!std::isfinite(mu) || mu < 0)
            throw InvalidArgument("friction.mu", "is " + number_text(mu) + "; it must be zero or positive");
    if (friction.kinetic) validate(*friction.kinetic, friction.mu);
    if (friction.layer) validate(*friction.layer);
}

void check_rigid_slip(const RigidSlip& slip, std::size_t size) {
    if (slip.empty()) return;
    check_array(slip.x, size, "friction.rigid_slip.x");
    check_array(slip.y, size, "friction.rigid_slip.y");
}

void check_friction(const ContactProblem& problem) {
    if (!problem.friction) return;
    const Grid& grid = problem.grid;
    check_coefficients(*problem.friction, grid.size());
    std::visit([&](const auto& motion) { check_motion(motion, grid); }, problem.motion);
    check_rigid_slip(problem.rigid_slip, grid.size());
}

// Refuses several steps, since tractions before each depend on the motion, too, and a slip law, since bounds depend on
// slip.
void check_derivatives(const ContactProblem& problem) {
    if (!problem.derivatives || !problem.friction) return;
    const auto* rolling = std::get_if<Rolling>(&problem.motion);
    if (rolling != nullptr && !rolling->steady() && rolling->steps > 1)
        throw InvalidArgument("derivatives", "are available for a single step, but friction.rolling.steps is " +
                                                 std::to_string(rolling->steps) +
                                                 "; solve step by step, each with the preceding one as previous");
    if (problem.friction->layer && problem.friction->layer->yields())
        throw InvalidArgument("derivatives",
                              "are not available if a layer yields; remove friction.layer.yield_stress, or use finite "
                              "differences of solves");
    if (problem.friction->kinetic)
        throw InvalidArgument(
            "derivatives",
            "are not available with a slip law; remove friction.kinetic, or use finite differences of solves");
}

/// Pressures of virtual penetration do not depend on the tractions, and change by whole rows of elements.
void check_penetration(const ContactProblem& problem) {
    if (problem.normal_model == NormalModel::of_model) return;
    const std::string model = "normal_model computes pressures of half-spaces in a plane";
    if (problem.bodies.pair || problem.bodies.any_given())
        throw InvalidArgument("ics", "contains a table of coefficients, but " + model + ": remove normal_model");
    if (problem.bodies.any_layered() || problem.bodies.any_uniform())
        throw InvalidArgument("normal_model", "is given, but a body has layers or a section; " + model + ": remove it");
    if (is_line_contact(problem))
        throw InvalidArgument("normal_model",
                              "cannot be combined with ics.line_contact; " + model + ": remove one of them");
    if (problem.columns) throw InvalidArgument("columns", "are given, but " + model + ": remove one of them");
    if (prescribes_pressures(problem.normal_model) && problem.gap &&
        std::holds_alternative<std::vector<double>>(*problem.gap))
        throw InvalidArgument("gap.array",
                              "has no contact ellipse, over which normal_model prescribes pressures; give a "
                              "paraboloid, semi_axes or half_ellipses");
    if (problem.sheet_flexibility > 0)
        throw InvalidArgument("sheet_flexibility",
                              "is " + number_text(problem.sheet_flexibility) +
                                  " mm^3/N, but normal_model does not support a sheet: remove one of them");
    if (problem.derivatives)
        throw InvalidArgument("derivatives",
                              "are not available with normal_model, whose pressures change by whole rows of elements; "
                              "use finite differences of solves, or remove normal_model");
}

void check_regions(const ContactProblem& problem) {
    if (!problem.regions) return;
    validate(*problem.regions);
    const auto refuse = [](const std::string& why) {
        throw InvalidArgument("regions", "cannot be combined with " + why +
                                             ", which finds pressures over the whole contact: remove one of them");
    };
    if (problem.model != Model::full) refuse("model " + std::string(name_of(problem.model)));
    if (problem.normal_model != NormalModel::of_model) refuse("normal_model");
}

void check_displacements(const ContactProblem& problem) {
    if (problem.displacements && problem.model != Model::full)
        throw InvalidArgument("displacements", "require model full; simplified models do not compute them");
}

// The state of a layer that hardens travels along rows. TangCG does not support a third state of elements.
void check_layer(const ContactProblem& problem) {
    if (!problem.friction || !problem.friction->layer) return;
    const InterfacialLayer& layer = *problem.friction->layer;
    if (problem.model != Model::full)
        throw InvalidArgument("friction.layer", "requires model full; simplified models do not support a layer");
    if (!layer.hardens()) return;
    if (problem.settings.tangential_solver == TangentialSolver::tangcg)
        throw InvalidArgument("settings.tangential.solver",
                              "is tangcg, which does not support hardening or softening layers; use newton, or remove "
                              "friction.layer.hardening");
    const auto* rolling = std::get_if<Rolling>(&problem.motion);
    constexpr double rounding = 1e-9;
    if (rolling != nullptr && rolling->steady() && std::abs(std::sin(2 * rolling->chi)) > rounding)
        throw InvalidArgument("friction.layer.hardening",
                              "is " + number_text(layer.hardening) +
                                  " in steady rolling off the axes of the grid, friction.rolling.chi " +
                                  number_text(rolling->chi) +
                                  "; rotate the grid, or take transient steps until they become steady");
}

void check_tangential_solver(const ContactProblem& problem) {
    if (problem.settings.tangential_solver != TangentialSolver::tangcg || !problem.friction) return;
    const auto* rolling = std::get_if<Rolling>(&problem.motion);
    if (problem.model == Model::full && rolling != nullptr && rolling->steady())
        throw InvalidArgument("settings.tangential.solver",
                              "is tangcg, which requires symmetric operators and therefore supports shifts and "
                              "transient rolling only; use newton for steady rolling");
}

[[noreturn]] void refuse_in_line_contact(const char* field, const std::string& value, const char* instead) {
    throw InvalidArgument(field, "is " + value + "; a line contact does not change along y, so " + instead);
}

void check_line_contact(const ContactProblem& problem) {
    if (problem.grid.ny != 1)
        refuse_in_line_contact("grid.ny", std::to_string(problem.grid.ny),
                               "the grid must have one row; dy is the length that forces refer to");
    if (const auto* axes = problem.gap ? std::get_if<SemiAxes>(&*problem.gap) : nullptr)
        refuse_in_line_contact("gap.semi_axes.b", number_text(axes->b), "it has no ellipse: give a paraboloid with Rx");
    const auto* paraboloid = problem.gap ? std::get_if<Paraboloid>(&*problem.gap) : nullptr;
    if (paraboloid != nullptr && std::isfinite(paraboloid->Ry))
        refuse_in_line_contact("gap.paraboloid.Ry", number_text(paraboloid->Ry), "remove it");
    if (!problem.friction) return;
    if (const auto* shift = std::get_if<Shift>(&problem.motion)) {
        if (shift->rotation != 0)
            refuse_in_line_contact("friction.rotation", number_text(shift->rotation), "the rotation about z must be 0");
        return;
    }
    const auto& rolling = std::get<Rolling>(problem.motion);
    if (rolling.phi != 0)
        refuse_in_line_contact("friction.rolling.phi", number_text(rolling.phi), "the spin must be 0");
    if (constexpr double rounding = 1e-9; std::abs(std::sin(rolling.chi)) > rounding)
        refuse_in_line_contact("friction.rolling.chi", number_text(rolling.chi), "it must roll along x: use 0 or pi");
}

void check_closed_form(const ContactSetup& setup) {
    if (setup.model != Model::full && setup.model != Model::hertz && is_line_contact(setup))
        throw InvalidArgument("model", "is " + std::string(name_of(setup.model)) +
                                           ", which supports contact ellipses only, but ics.line_contact is set: use "
                                           "model hertz, which rolls by Carter's theory, or full");
    if (setup.model != Model::full && setup.sheet_flexibility > 0)
        throw InvalidArgument(
            "sheet_flexibility",
            "is " + number_text(setup.sheet_flexibility) +
                " mm^3/N; closed forms do not support a sheet between the bodies: remove it, or use model full");
    if (setup.model == Model::full || !(setup.bodies.any_layered() || setup.bodies.any_uniform())) return;
    throw InvalidArgument(
        "model", "is " + std::string(name_of(setup.model)) +
                     "; closed forms support half-spaces only, but a body has layers or a section: use model full");
}

constexpr const char* creeps = ", but a viscoelastic body requires steady rolling along x";

void check_creep_motion(const ContactProblem& problem) {
    const auto* rolling = std::get_if<Rolling>(&problem.motion);
    if (rolling == nullptr)
        throw InvalidArgument("friction.rolling",
                              std::string("is missing") + creeps + ": give it with its velocity; mu may be 0");
    if (!rolling->steady())
        throw InvalidArgument("friction.rolling.kind", std::string("is transient") + creeps + ": use steady");
    if (constexpr double rounding = 1e-9; std::abs(std::sin(rolling->chi)) > rounding)
        throw InvalidArgument("friction.rolling.chi", "is " + number_text(rolling->chi) + creeps +
                                                          ": use 0 or pi, and rotate the grid if necessary");
}

/// Refuses settings that viscoelastic bodies do not support.
void check_viscoelastic(const ContactProblem& problem, bool complete) {
    if (!problem.bodies.any_viscoelastic()) return;
    const auto refuse = [](const char* field, const std::string& why) {
        throw InvalidArgument(field, why + ", but a body is viscoelastic: remove one of them");
    };
    if (problem.model != Model::full)
        throw InvalidArgument("model", "is " + std::string(name_of(problem.model)) +
                                           ", a closed form for elastic bodies, but a body is viscoelastic: use full");
    if (problem.normal_model != NormalModel::of_model) refuse("normal_model", "supports elastic bodies only");
    if (problem.columns) refuse("columns", "support elastic bodies only");
    if (problem.derivatives) refuse("derivatives", "are available for elastic bodies only");
    if (problem.gap && std::holds_alternative<SemiAxes>(*problem.gap))
        throw InvalidArgument(
            "gap.semi_axes",
            "are those of elastic half-spaces, but a body is viscoelastic; give a paraboloid or an array");
    if (problem.friction)
        check_creep_motion(problem);
    else if (complete)
        throw InvalidArgument(
            "friction", std::string("is missing") + creeps + ": give friction.rolling with its velocity; mu may be 0");
}

void check(const ContactProblem& problem, bool complete) {
    validate(problem.grid, "grid");
    validate(problem.bodies, problem.grid);
    check_closed_form(problem);
    validate_models(problem);
    if (complete || (problem.approach && problem.Fn)) require_load(problem);
    const std::size_t size = problem.grid.size();
    check_load(problem);
    if (complete && !problem.gap)
        throw InvalidArgument("gap", "is missing; give the distance between the undeformed surfaces");
    check_gap(problem);
    check_friction(problem);
    if (is_line_contact(problem)) check_line_contact(problem);
    check_derivatives(problem);
    check_penetration(problem);
    check_regions(problem);
    check_displacements(problem);
    check_tangential_solver(problem);
    check_layer(problem);
    check_viscoelastic(problem, complete);
    check_columns(problem);
    check_temperature(problem, complete);
    check_wear(problem, complete);
    check_fatigue(problem, complete);
    check_force_accuracy(problem, complete);
    check_state(problem.previous, size, "previous");
    check_settings(problem.settings.normal, "settings.normal");
    check_settings(problem.settings.tangential, "settings.tangential");
    check_settings(problem.settings.outer, "settings.outer");
    check_state(problem.initial, size, "initial");
}

}  // namespace

const SolutionFields all_solution_fields = [] {
    SolutionFields all;
    for (std::size_t field = 0; field < solution_arrays.size(); ++field) all.push_back(SolutionField(field));
    return all;
}();

double step_length(const Rolling& rolling, const Grid& grid) {
    return rolling.dq != 0 ? rolling.dq : size_along(rolling.chi, grid.dx, grid.dy);
}

std::array<double, 2> step_of(const ContactProblem& problem) {
    const auto* rolling = problem.friction ? std::get_if<Rolling>(&problem.motion) : nullptr;
    if (rolling == nullptr) return {0, 0};
    const double dq = step_length(*rolling, problem.grid);
    return {dq * std::cos(rolling->chi), dq * std::sin(rolling->chi)};
}

std::array<double, 3> rolling_of_operators(const ContactProblem& problem) {
    const auto [x, y] = step_of(problem);
    const auto* rolling = problem.friction ? std::get_if<Rolling>(&problem.motion) : nullptr;
    return {x, y, rolling != nullptr && problem.bodies.any_viscoelastic() ? rolling->velocity : 0};
}

bool is_line_contact(const ContactSetup& setup) {
    return line_contact_of(setup.bodies).has_value();
}

void require_load(const ContactLoad& load) {
    if (!load.approach && !load.Fn)
        throw InvalidArgument("approach", "is missing, and so is Fn; one of the two must be prescribed");
    if (load.approach && load.Fn)
        throw InvalidArgument("Fn", "is " + number_text(*load.Fn) + " beside an approach of " +
                                        number_text(*load.approach) + "; only one of the two can be prescribed");
}

void validate(const ContactProblem& problem) {
    check(problem, true);
}

void validate_opening(const ContactProblem& problem) {
    check(problem, false);
}

}  // namespace contactd
