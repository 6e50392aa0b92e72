// Compares gradients of random problems with central differences of their solutions.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "contact/random_contact.hpp"
#include "gradient_cases.hpp"

namespace contactd::test {

/// Describes one input: its change in a problem, the size at which it matters, and the derivative with respect to it.
struct InputChange {
    std::string name;
    double size = 0;
    std::function<void(ContactProblem&, double)> change;
    std::function<double(const Gradient&)> derivative;
};

/// Describes one output of a solution, and its cotangents.
struct OutputOf {
    std::string name;
    Cotangents cotangents;
    std::function<double(const ContactSolution&)> value;
};

inline double weighted(const Values& weights, const Values& values) {
    double sum = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] * values[i];
    return sum;
}

inline std::vector<OutputOf> random_outputs(const ContactProblem& problem, std::uint64_t seed) {
    const std::size_t n = problem.grid.size();
    const double area = problem.grid.element_area();
    const auto weights = [&](unsigned k) { return random_values(n, static_cast<unsigned>(seed) + k); };
    std::vector<OutputOf> outputs{
        {"Fn", output_of(&Cotangents::Fn), [](const ContactSolution& s) { return s.forces.Fn; }},
        {"approach", output_of(&Cotangents::approach), [](const ContactSolution& s) { return s.approach; }},
        {"norm", output_of(&Cotangents::pressure_norm), [area](const ContactSolution& s) {
             double sum = 0;
             for (const double p : s.pressure) sum += std::pow(p, 8) * area;
             return std::pow(sum, 1.0 / 8);
         }}};
    OutputOf pressure{"pressure", {}, {}};
    pressure.cotangents.pressure = weights(1);
    pressure.value = [w = weights(1)](const ContactSolution& s) { return weighted(w, s.pressure); };
    outputs.push_back(pressure);
    if (!problem.friction || problem.friction->mu_of(0) == 0) return outputs;
    outputs.push_back({"Fx", output_of(&Cotangents::Fx), [](const ContactSolution& s) { return s.forces.Fx; }});
    outputs.push_back({"Mz", output_of(&Cotangents::Mz), [](const ContactSolution& s) { return s.forces.Mz; }});
    const bool rolls = std::holds_alternative<Rolling>(problem.motion);
    outputs.push_back({"loss", output_of(rolls ? &Cotangents::frictional_power : &Cotangents::frictional_work),
                       [](const ContactSolution& s) {
                           return s.frictional_power ? *s.frictional_power : s.frictional_work.value_or(0);
                       }});
    OutputOf fields{"fields", {}, {}};
    fields.cotangents.traction_x = weights(2);
    fields.cotangents.slip_y = weights(3);
    fields.value = [x = weights(2), y = weights(3)](const ContactSolution& s) {
        return weighted(x, s.traction_x) + weighted(y, s.slip_y);
    };
    outputs.push_back(fields);
    return outputs;
}

inline Force& force_of(ContactProblem& problem) {
    return std::visit([](auto& motion) -> Force& { return motion.force; }, problem.motion);
}

inline void add_motion(const ContactProblem& problem, const ContactSolution& solution,
                       std::vector<InputChange>& inputs) {
    const double mu = *std::max_element(problem.friction->mu.begin(), problem.friction->mu.end());
    const double length = std::sqrt(std::max(solution.area.contact, problem.grid.element_area()));
    const double slip = slip_unit(problem, solution, mu);
    const double force = mu * solution.forces.Fn;
    const Force prescribed = std::visit([](const auto& motion) { return motion.force; }, problem.motion);
    if (prescribed.Fx)
        inputs.push_back({"Fx", force, [](ContactProblem& p, double by) { *force_of(p).Fx += by; },
                          [](const Gradient& g) { return *g.Fx; }});
    if (prescribed.Fy)
        inputs.push_back({"Fy", force, [](ContactProblem& p, double by) { *force_of(p).Fy += by; },
                          [](const Gradient& g) { return *g.Fy; }});
    if (std::holds_alternative<Rolling>(problem.motion)) {
        const auto rolling = [](ContactProblem& p) -> Rolling& { return std::get<Rolling>(p.motion); };
        if (!prescribed.Fx)
            inputs.push_back({"xi", slip / length, [=](ContactProblem& p, double by) { rolling(p).xi += by; },
                              [](const Gradient& g) { return *g.xi; }});
        if (!prescribed.Fy)
            inputs.push_back({"eta", slip / length, [=](ContactProblem& p, double by) { rolling(p).eta += by; },
                              [](const Gradient& g) { return *g.eta; }});
        inputs.push_back({"phi", slip / length / length, [=](ContactProblem& p, double by) { rolling(p).phi += by; },
                          [](const Gradient& g) { return *g.phi; }});
        return;
    }
    const auto shift = [](ContactProblem& p) -> Shift& { return std::get<Shift>(p.motion); };
    if (!prescribed.Fx)
        inputs.push_back({"x", slip, [=](ContactProblem& p, double by) { shift(p).rigid_shift.x += by; },
                          [](const Gradient& g) { return g.rigid_shift->x; }});
    if (!prescribed.Fy)
        inputs.push_back({"y", slip, [=](ContactProblem& p, double by) { shift(p).rigid_shift.y += by; },
                          [](const Gradient& g) { return g.rigid_shift->y; }});
    inputs.push_back({"rotation", slip / length, [=](ContactProblem& p, double by) { shift(p).rotation += by; },
                      [](const Gradient& g) { return *g.rotation; }});
}

inline void add_elements(const ContactProblem& problem, const ContactSolution& solution, double depth, Dice& dice,
                         std::vector<InputChange>& inputs) {
    std::vector<std::size_t> pressed;
    for (std::size_t i = 0; i < solution.pressure.size(); ++i)
        if (solution.pressure[i] > 0) pressed.push_back(i);
    const double mu = problem.friction ? problem.friction->mu_of(0) : 0;
    for (int k = 0; k < 3; ++k) {
        const std::size_t i =
            pressed[static_cast<std::size_t>(dice.uniform(0, 0.999) * static_cast<double>(pressed.size()))];
        inputs.push_back({"gap", depth, [i](ContactProblem& p, double by) { std::get<Values>(*p.gap)[i] += by; },
                          [i](const Gradient& g) { return g.gap[i]; }});
        if (!(mu > 0 && problem.friction->mu_of(i) > 0)) continue;
        inputs.push_back({"mu", mu,
                          [i](ContactProblem& p, double by) {
                              if (p.friction->mu.size() == 1) p.friction->mu.assign(p.grid.size(), p.friction->mu[0]);
                              p.friction->mu[i] += by;
                          },
                          [i](const Gradient& g) { return g.mu[i]; }});
        if (problem.previous.traction_x.empty() || !(problem.previous.pressure[i] > 0)) continue;
        inputs.push_back({"previous", mu * solution.pmax,
                          [i](ContactProblem& p, double by) { p.previous.traction_x[i] += by; },
                          [i](const Gradient& g) { return g.previous->traction_x[i]; }});
    }
}

/// Bodies alike stay alike, since solvers neglect a coupling as small as that due to small differences.
inline void add_materials(const ContactProblem& problem, std::vector<InputChange>& inputs) {
    const auto& [upper, lower, pair] = problem.bodies;
    if (lower.material.is_rigid()) return;
    const bool alike = upper.material == lower.material;
    const auto change = [alike](double Material::* member) {
        return [=](ContactProblem& p, double by) {
            p.bodies.lower.material.*member += by;
            if (alike) p.bodies.upper.material = p.bodies.lower.material;
        };
    };
    const auto derivative = [alike](double GradientByMaterial::* member) {
        return [=](const Gradient& g) { return (*g.lower).*member + (alike ? (*g.upper).*member : 0); };
    };
    inputs.push_back({"G", lower.material.G, change(&Material::G), derivative(&GradientByMaterial::G)});
    if (lower.material.nu > 0.01 && lower.material.nu < 0.49)
        inputs.push_back({"nu", 0.1, change(&Material::nu), derivative(&GradientByMaterial::nu)});
}

inline std::vector<InputChange> random_inputs(const ContactProblem& problem, const ContactSolution& solution,
                                              std::uint64_t seed) {
    Dice dice(seed + 55'000'000);
    const Values& h = std::get<Values>(*problem.gap);
    const double depth = solution.approach - *std::min_element(h.begin(), h.end());
    std::vector<InputChange> inputs;
    if (problem.Fn)
        inputs.push_back({"load", *problem.Fn, [](ContactProblem& p, double by) { *p.Fn += by; },
                          [](const Gradient& g) { return *g.Fn; }});
    else
        inputs.push_back({"load", depth, [](ContactProblem& p, double by) { *p.approach += by; },
                          [](const Gradient& g) { return *g.approach; }});
    if (problem.friction && problem.friction->mu_of(0) > 0) add_motion(problem, solution, inputs);
    add_elements(problem, solution, depth, dice, inputs);
    add_materials(problem, inputs);
    return inputs;
}

struct GradientCheck {
    int compared = 0, skipped = 0;  // counts inputs; skipped if the element division changes
    std::vector<double> errors;     // of each pair of output and input, over the largest derivative of the output
    double error = 0;
    std::string worst;
};

/// Returns whether the solutions have the division of elements of `middle`, so that their difference is smooth.
inline bool comparable(const ContactSolution& up, const ContactSolution& down, const ContactSolution& middle) {
    return up.converged() && down.converged() && up.element_division == middle.element_division &&
           down.element_division == middle.element_division;
}

/// Errors are relative to the largest derivative of the output, times the size of its input; inputs of single elements
/// have a scale of their own.
inline GradientCheck check_gradients(const ContactProblem& problem, const ContactSolution& solution,
                                     const std::vector<Gradient>& gradients, const std::vector<OutputOf>& outputs,
                                     const std::vector<InputChange>& inputs) {
    GradientCheck check;
    const auto of_element = [](const InputChange& input) {
        return input.name == "gap" || input.name == "mu" || input.name == "previous";
    };
    std::vector<double> scale(outputs.size()), element_scale(outputs.size());
    for (std::size_t k = 0; k < outputs.size(); ++k)
        for (const InputChange& input : inputs) {
            const double size = std::abs(input.derivative(gradients[k])) * input.size;
            scale[k] = std::max(scale[k], size);
            if (of_element(input)) element_scale[k] = std::max(element_scale[k], size);
        }
    for (const InputChange& input : inputs) {
        // The larger step may be curved, and the smaller one consist of rounding errors.
        std::vector<double> error(outputs.size(), std::numeric_limits<double>::infinity());
        for (const double part : {1e-4, 1e-5}) {
            const double step = part * (of_element(input) ? 0.1 : 1) * input.size;
            ContactProblem above = problem, below = problem;
            input.change(above, step);
            input.change(below, -step);
            const ContactSolution up = solve_half_spaces(above), down = solve_half_spaces(below);
            if (!comparable(up, down, solution)) continue;
            for (std::size_t k = 0; k < outputs.size(); ++k) {
                const double expected = (outputs[k].value(up) - outputs[k].value(down)) / (2 * step);
                const double unit = of_element(input) ? std::max(element_scale[k], 1e-2 * scale[k]) : scale[k];
                const double difference = std::abs(expected - input.derivative(gradients[k])) * input.size;
                error[k] = std::min(error[k], unit > 0 ? difference / unit : 0);
            }
        }
        const bool compared = error[0] < std::numeric_limits<double>::infinity();
        ++(compared ? check.compared : check.skipped);
        for (std::size_t k = 0; compared && k < outputs.size(); ++k) {
            check.errors.push_back(error[k]);
            if (error[k] <= check.error) continue;
            check.error = error[k];
            check.worst = outputs[k].name + " by " + input.name;
        }
    }
    return check;
}

/// Creates a problem that has gradients, solved nearly to rounding; half of the forces stay prescribed.
inline ContactProblem random_with_gradients(std::uint64_t seed, int largest_size) {
    ContactProblem problem = tight(random_contact(seed, largest_size));
    if (!problem.friction) return problem;
    problem.friction->kinetic.reset();
    if (auto* rolling = std::get_if<Rolling>(&problem.motion)) rolling->steps = 1;
    if (seed % 2 == 0) force_of(problem) = {};
    return problem;
}

inline std::vector<GradientInput> inputs_of(const ContactProblem& problem) {
    std::vector<GradientInput> by{GradientInput::gap, GradientInput::materials};
    if (!problem.friction) return by;
    by.push_back(GradientInput::mu);
    const auto* rolling = std::get_if<Rolling>(&problem.motion);
    if (rolling == nullptr || !rolling->steady()) by.push_back(GradientInput::previous);
    return by;
}

}  // namespace contactd::test
