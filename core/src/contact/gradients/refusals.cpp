// Refuses problems and outputs that have no gradients.
#include <cmath>
#include <string>

#include "contactd/contact_gradients.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

[[noreturn]] void refuse(const std::string& why) {
    throw InvalidArgument("vjp", "is not available " + why + ", or use finite differences of solves");
}

void check_models(const ContactProblem& problem) {
    if (problem.model != Model::full) refuse("for simplified models; use model full");
    if (problem.normal_model != NormalModel::of_model)
        refuse("with normal_model, whose pressures change by whole rows of elements; remove normal_model");
    if (problem.columns) refuse("on curved columns; remove columns");
    if (problem.bodies.any_viscoelastic()) refuse("for viscoelastic bodies; use elastic ones");
}

void check_friction(const ContactProblem& problem) {
    if (!problem.friction) return;
    const FrictionLaw& friction = *problem.friction;
    if (friction.layer && friction.layer->yields()) refuse("if a layer yields; remove friction.layer.yield_stress");
    if (friction.kinetic) refuse("with a slip law; remove friction.kinetic");
    if (friction.follows_temperature()) refuse("if friction depends on the temperature; remove friction.temperature");
    const auto* rolling = std::get_if<Rolling>(&problem.motion);
    if (rolling != nullptr && !rolling->steady() && rolling->steps > 1)
        refuse("for " + std::to_string(rolling->steps) +
               " steps at once (friction.rolling.steps); solve step by step, each with the preceding one as previous");
}

bool is_closed_half_space(const Body& body) {
    const Ics* ics = body.computed();
    return body.material.is_rigid() ||
           (ics != nullptr && ics->source == IcSource::analytic && ics->body == BodyShape::half_space);
}

void check_inputs(const ContactProblem& problem, const std::vector<GradientInput>& by) {
    for (const GradientInput input : by) {
        if (input == GradientInput::materials) {
            const auto& [upper, lower, pair] = problem.bodies;
            if (pair || !is_closed_half_space(upper) || !is_closed_half_space(lower))
                throw InvalidArgument("by",
                                      "contains materials, which are available for half-spaces in closed form only; "
                                      "remove it, or use ics.source analytic and ics.body half_space");
            if (problem.regions)
                throw InvalidArgument("by", "contains materials, which are not available with regions; remove one");
        }
        if (input == GradientInput::previous) {
            const auto* rolling = problem.friction ? std::get_if<Rolling>(&problem.motion) : nullptr;
            if (!problem.friction || (rolling != nullptr && rolling->steady()))
                throw InvalidArgument("by",
                                      "contains previous, but only shifts and transient rolling have previous "
                                      "tractions; remove it");
        }
        if ((input == GradientInput::mu || input == GradientInput::rigid_slip) && !problem.friction)
            throw InvalidArgument("by", std::string("contains ") + (input == GradientInput::mu ? "mu" : "rigid_slip") +
                                            ", but the problem has no friction; give friction, or remove it");
    }
}

struct Scalar {
    const char* name;
    double value;
    bool applies;
    const char* cure;
};

void check_scalars(const ContactProblem& problem, const Cotangents& output, const std::string& path) {
    const bool rubs = problem.friction.has_value();
    const bool rolls = rubs && std::holds_alternative<Rolling>(problem.motion);
    const char *friction = "requires friction", *rolling = "requires friction.rolling",
               *shift = "requires friction.shift";
    const Scalar scalars[] = {{"Fn", output.Fn, true, ""},
                              {"Fx", output.Fx, rubs, friction},
                              {"Fy", output.Fy, rubs, friction},
                              {"Mz", output.Mz, rubs, friction},
                              {"approach", output.approach, true, ""},
                              {"xi", output.xi, rolls, rolling},
                              {"eta", output.eta, rolls, rolling},
                              {"rigid_shift.x", output.rigid_shift.x, rubs && !rolls, shift},
                              {"rigid_shift.y", output.rigid_shift.y, rubs && !rolls, shift},
                              {"frictional_work", output.frictional_work, rubs && !rolls, shift},
                              {"frictional_power", output.frictional_power, rolls, rolling},
                              {"pmax", output.pmax, true, ""},
                              {"pressure_norm", output.pressure_norm, true, ""}};
    for (const Scalar& scalar : scalars) {
        const std::string field = path + "." + scalar.name;
        if (!std::isfinite(scalar.value))
            throw InvalidArgument(field, "is " + number_text(scalar.value) + "; it must be finite");
        if (scalar.value != 0 && !scalar.applies)
            throw InvalidArgument(field, "is " + number_text(scalar.value) + ", but it " + scalar.cure + "; remove it");
    }
    if (!(output.norm_order >= 1) || !(output.norm_order <= largest_norm_order))
        throw InvalidArgument(
            path + ".norm_order",
            "is " + number_text(output.norm_order) + "; it must lie between 1 and " + number_text(largest_norm_order));
}

struct Array {
    const char* name;
    const std::vector<double>& values;
    bool needs_friction;
    std::size_t size;
    const char* of;
};

void check_array(const ContactProblem& problem, const Array& array, const std::string& path) {
    if (array.values.empty()) return;
    const std::string field = path + "." + array.name;
    if (array.needs_friction && !problem.friction)
        throw InvalidArgument(field, "is given, but the problem has no friction; remove it");
    if (array.values.size() != array.size)
        throw InvalidArgument(field, "has " + std::to_string(array.values.size()) + " values; the grid has " +
                                         std::to_string(array.size) + " " + array.of);
    for (const double value : array.values)
        if (!std::isfinite(value))
            throw InvalidArgument(field, "contains " + number_text(value) + "; all values must be finite");
}

void check_arrays(const ContactProblem& problem, const Cotangents& output, const std::string& path) {
    const std::size_t size = problem.grid.size(), rows = static_cast<std::size_t>(problem.grid.ny);
    const char* elements = "elements";
    const Array arrays[] = {{"pressure", output.pressure, false, size, elements},
                            {"traction_x", output.traction_x, true, size, elements},
                            {"traction_y", output.traction_y, true, size, elements},
                            {"slip_x", output.slip_x, true, size, elements},
                            {"slip_y", output.slip_y, true, size, elements},
                            {"loss_of_rows", output.loss_of_rows, true, rows, "rows"}};
    for (const Array& array : arrays) check_array(problem, array, path);
}

}  // namespace

void validate_gradients(const ContactProblem& problem, const std::vector<Cotangents>& outputs,
                        const std::vector<GradientInput>& by) {
    check_models(problem);
    check_friction(problem);
    check_inputs(problem, by);
    if (outputs.empty() || outputs.size() > most_outputs)
        throw InvalidArgument(
            "vjp", "has " + std::to_string(outputs.size()) + " outputs; give 1 to " + std::to_string(most_outputs));
    for (std::size_t k = 0; k < outputs.size(); ++k) {
        const std::string path = "vjp[" + std::to_string(k) + "]";
        check_scalars(problem, outputs[k], path);
        check_arrays(problem, outputs[k], path);
    }
}

}  // namespace contactd
