#include "inputs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <variant>

#include "contactd/error.hpp"
#include "field_types.hpp"

namespace contactd::c {
namespace {

/// Returns whether the path is that field, or below it.
bool is_below(const FieldPath& path, std::string_view name) {
    const std::string_view text = path.text();
    return text.starts_with(name) && (text.size() == name.size() || text[name.size()] == '.');
}

std::optional<MotionKind> motion_of(const FieldPath& path) {
    if (is_below(path, "friction.rolling")) return MotionKind::rolling;
    for (const char* of_shift : {"friction.rigid_shift", "friction.rotation", "friction.duration", "friction.force"})
        if (is_below(path, of_shift)) return MotionKind::shift;
    return {};
}

/// Returns the coefficients as in a message with these fields, without those that do not apply to their source.
Ics stated(const Ics& given, const std::string& name) {
    Ics ics = given;
    ics.fem = {};
    if (ics.source == IcSource::analytic) {
        ics.accuracy = 0;
        ics.any_nu = false;
    } else if (ics.accuracy == 0) {
        ics.fem = given.fem;
    } else {
        ics.fem.L_over_h = given.fem.L_over_h;
        if (ics.fem != given.fem)
            throw InvalidArgument(name + ".accuracy",
                                  "chooses the mesh and the solver, but their fields are set as well; remove one of "
                                  "both with contactd_clear");
    }
    return ics;
}

Coefficients stated(const Coefficients& given, const std::string& name) {
    const auto* ics = std::get_if<Ics>(&given);
    return ics == nullptr ? given : stated(*ics, name);
}

Body stated(const BodyInput& given, const std::optional<Coefficients>& of_both, const std::string& name) {
    Body body{given.material};
    body.viscoelastic = given.viscoelastic;
    if (body.material.is_rigid()) return body;
    if (given.ics)
        body.ics = stated(*given.ics, name + ".ics");
    else if (of_both)
        body.ics = stated(*of_both, "ics");
    const bool has_G = !std::isnan(body.material.G), has_nu = !std::isnan(body.material.nu);
    if (const auto* ics = std::get_if<Ics>(&body.ics); ics != nullptr && ics->layered) {
        if (has_G || has_nu)
            throw InvalidArgument(name + (has_G ? ".G" : ".nu"),
                                  "is set, but layers have their own materials: remove it");
        if (!ics->layered->layers.empty()) body.material = ics->layered->surface();
    } else if (!has_G || !has_nu) {
        throw InvalidArgument(name + (has_G ? ".nu" : ".G"),
                              "is missing; an elastic body requires G and nu, and any other body must be rigid");
    }
    return body;
}

/// Throws InvalidArgument for invalid coefficients, naming the body's material as in a problem.
void validate_coefficients(const ContactSetup& setup, const Body& body, const std::string& name) {
    const Ics* ics = body.computed();
    if (ics == nullptr) return;
    const Grid& grid = setup.grid;
    validate(IcSpec{*ics, body.material, grid.dx, grid.dy, grid.nx, grid.ny}, name);
}

}  // namespace

bool is_load(const FieldPath& path) {
    constexpr std::array load{"gap", "approach", "Fn", "friction", "derivatives", "displacements"};
    return std::ranges::any_of(load, [&](const char* name) { return is_below(path, name); });
}

ContactProblem ContactInputs::centred_problem() {
    ContactProblem problem;
    problem.grid.x0 = problem.grid.y0 = centred;
    return problem;
}

Roots ContactInputs::roots() {
    static const std::array roots{&type_of_problem(), &type_of_bodies_and_session()};
    return roots;
}

void* ContactInputs::at(const RootedPath& path) {
    if (path.root == &type_of_problem()) return &problem;
    return this;
}

void ContactInputs::require_motion_of(const FieldPath& path) const {
    const std::optional<MotionKind> named = motion_of(path);
    if (!named || !motion || named == motion) return;
    const bool is_shift = motion == MotionKind::shift;
    throw InvalidArgument(path.text(), std::string("is a field of ") + (is_shift ? "rolling" : "a shift") +
                                           ", but the motion is " + (is_shift ? "a shift" : "rolling") +
                                           "; to change its kind, call contactd_clear with \"friction." +
                                           (is_shift ? "rigid_shift" : "rolling") + "\" first");
}

void ContactInputs::require_clearable_between_steps(const FieldPath& path) {
    for (const char* kept : {"friction", "friction.mu", "friction.rigid_slip"})
        if (path.text() == kept)
            throw InvalidArgument(path.text(),
                                  "cannot be cleared after the start, because steps would use the value of the start; "
                                  "set it to 0 instead, friction.mu for no friction");
}

void ContactInputs::was_set(const FieldPath& path) {
    if (is_below(path, "approach")) problem.Fn.reset();
    if (is_below(path, "Fn")) problem.approach.reset();
    if (const auto named = motion_of(path)) {
        motion = named;
        changed.motion = true;
    }
    if (is_below(path, "gap")) changed.gap = true;
    for (const char* of_law : {"friction.mu", "friction.kinetic", "friction.temperature"})
        if (is_below(path, of_law)) changed.friction = true;
    if (is_below(path, "friction.rigid_slip")) changed.rigid_slip = true;
}

void ContactInputs::was_cleared(const FieldPath& path) {
    const auto is = [&](std::string_view name) { return path.text() == name; };
    was_set(path);
    if (is("friction") || is("friction.rolling") || is("friction.rigid_shift")) motion.reset();
    if (is("friction")) changed.friction = changed.motion = changed.rigid_slip = true;
}

Bodies ContactInputs::bodies() const {
    if (ics && std::holds_alternative<GivenIcs>(*ics)) {
        if (upper.ics || (lower && lower->ics))
            throw InvalidArgument("ics.table", "applies to both bodies, but a body has its own ics; clear one of them");
        return {{}, {}, std::get<GivenIcs>(*ics)};
    }
    const Body above = stated(upper, ics, "bodies.upper");
    return {above, lower ? stated(*lower, ics, "bodies.lower") : above, {}};
}

const Section* ContactInputs::section_of(bool upper_one) const {
    const BodyInput& body = upper_one || !lower ? upper : *lower;
    const std::optional<Coefficients>& coefficients = body.ics ? body.ics : ics;
    const auto* made = coefficients ? std::get_if<Ics>(&*coefficients) : nullptr;
    return made != nullptr && made->section ? &*made->section : nullptr;
}

Grid ContactInputs::grid() const {
    Grid grid = problem.grid;
    const Grid centre = Grid::of_elements(grid.nx, grid.ny, grid.dx, grid.dy);
    if (grid.x0 == centred) grid.x0 = centre.x0;
    if (grid.y0 == centred) grid.y0 = centre.y0;
    return grid;
}

/// Throws InvalidArgument for a field that requires friction; without a coefficient there is no friction.
void ContactInputs::require_friction() {
    if (problem.friction && !problem.friction->mu.empty()) return;
    if (motion || (problem.friction && (problem.friction->kinetic || problem.friction->temperature)) ||
        !problem.rigid_slip.empty())
        throw InvalidArgument("friction.mu",
                              "is missing; motion has no effect without friction: set it, or remove the motion");
    problem.friction.reset();
}

SessionSpec ContactInputs::opening() {
    require_friction();
    problem.bodies = bodies();
    ContactProblem opened = problem;
    opened.grid = grid();
    validate_opening(opened);
    if (opened.model == Model::full && !opened.bodies.pair) {
        validate_coefficients(opened, opened.bodies.upper, "bodies.upper");
        validate_coefficients(opened, opened.bodies.lower, "bodies.lower");
    }
    return {opened, opened, lease_seconds, accept_unconverged};
}

StepInput ContactInputs::step() {
    require_friction();
    validate(problem);
    StepInput input;
    input.approach = problem.approach;
    input.Fn = problem.Fn;
    if (changed.gap) input.gap = problem.gap;
    if (changed.friction) input.friction = problem.friction;
    if (changed.motion) input.motion = problem.motion;
    if (changed.rigid_slip) input.rigid_slip = problem.rigid_slip;
    input.fields = fields;
    input.derivatives = problem.derivatives;
    input.displacements = problem.displacements;
    return input;
}

void ContactInputs::take_estimates(const std::optional<Motion>& found) {
    if (found && changed.motion) restore_estimates(*found);
}

void ContactInputs::restore_estimates(const Motion& from) {
    const auto* estimates = std::get_if<Rolling>(&from);
    auto* own = std::get_if<Rolling>(&problem.motion);
    if (estimates == nullptr || own == nullptr) return;
    if (own->force.Fx) own->xi = estimates->xi;
    if (own->force.Fy) own->eta = estimates->eta;
}

}  // namespace contactd::c
