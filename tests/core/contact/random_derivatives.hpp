// Compares derivatives of random problems with central differences of their solutions.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "random_contact.hpp"

namespace contactd::test {

/// Holds one number each for Fx, Fy, Mz over a length, and the computed force or approach; one set for each input.
using DerivativeRows = std::array<double, 4>;
inline constexpr int derivative_inputs = 5;

inline DerivativeRows answers_of(const ContactProblem& problem, const ContactSolution& solution, double length) {
    return {solution.forces.Fx, solution.forces.Fy, solution.forces.Mz / length,
            problem.Fn ? solution.approach : solution.forces.Fn};
}

inline double by_input(const DerivativesOfAnswer& row, int input) {
    const auto of_shift = [&](double DerivativesByShift::* component) {
        return row.rigid_shift ? (*row.rigid_shift).*component : 0;
    };
    switch (input) {
        case 0:
            return row.xi ? *row.xi : of_shift(&DerivativesByShift::x);
        case 1:
            return row.eta ? *row.eta : of_shift(&DerivativesByShift::y);
        case 2:
            return row.phi ? *row.phi : row.rotation.value_or(0);
        case 3:
            return row.Fn ? *row.Fn : *row.approach;
        default:
            return row.mu.value_or(0);
    }
}

inline DerivativeRows rows_of(const Derivatives& derivatives, int input, double length) {
    const auto value = [&](const std::optional<DerivativesOfAnswer>& row) { return row ? by_input(*row, input) : 0; };
    return {value(derivatives.Fx), value(derivatives.Fy), value(derivatives.Mz) / length,
            value(derivatives.Fn ? derivatives.Fn : derivatives.approach)};
}

/// Returns the problem with one input changed.
inline ContactProblem moved(ContactProblem problem, int input, double change) {
    if (input == 3) {
        *(problem.Fn ? problem.Fn : problem.approach) += change;
    } else if (input == 4) {
        for (double& mu : problem.friction->mu) mu += change;
    } else if (auto* rolling = std::get_if<Rolling>(&problem.motion)) {
        (input == 0 ? rolling->xi : input == 1 ? rolling->eta : rolling->phi) += change;
    } else {
        auto& shift = std::get<Shift>(problem.motion);
        (input == 0 ? shift.rigid_shift.x : input == 1 ? shift.rigid_shift.y : shift.rotation) += change;
    }
    return problem;
}

/// Returns the size at which an input matters, and whether the problem has it.
struct InputSizes {
    std::array<double, derivative_inputs> size{};
    double length = 1;  // of the contact (mm)
};

inline InputSizes input_sizes(const ContactProblem& problem, const ContactSolution& solution) {
    InputSizes sizes;
    sizes.length = std::sqrt(std::max(solution.area.contact, problem.grid.element_area()));
    const auto h = undeformed_distance(problem);
    sizes.size[3] = problem.Fn ? *problem.Fn : *problem.approach - *std::min_element(h.begin(), h.end());
    if (!problem.friction || solution.forces.Fn == 0) return sizes;
    const double mu = *std::max_element(problem.friction->mu.begin(), problem.friction->mu.end());
    const double unit = slip_unit(problem, solution, mu);
    const bool rolls = std::holds_alternative<Rolling>(problem.motion);
    sizes.size[0] = sizes.size[1] = rolls ? unit / sizes.length : unit;
    const bool may_rotate = solution.derivatives->Fx->phi || solution.derivatives->Fx->rotation;
    if (may_rotate) sizes.size[2] = sizes.size[0] / sizes.length;
    sizes.size[4] = mu;
    return sizes;
}

/// One in five problems has a rigid slip of each element, of the order of that of the motion.
inline RigidSlip random_rigid_slip(std::uint64_t seed, const ContactProblem& problem) {
    Dice dice(seed + 99'000'000);
    if (!dice.chance(0.2)) return {};
    const auto* rolling = std::get_if<Rolling>(&problem.motion);
    const RigidShift shift =
        rolling ? RigidShift{rolling->xi, rolling->eta} : std::get<Shift>(problem.motion).rigid_shift;
    const double unit = std::hypot(shift.x, shift.y);
    RigidSlip slip{Values(problem.grid.size()), Values(problem.grid.size())};
    for (Values* values : {&slip.x, &slip.y})
        for (double& value : *values) value = unit * dice.uniform(-0.5, 0.5);
    return slip;
}

/// Creates the problem for derivatives, solved nearly to rounding: one step, no slip law, a known motion.
inline ContactProblem differentiable(std::uint64_t seed, int largest_size) {
    ContactProblem problem = random_contact(seed, largest_size);
    problem.derivatives = true;
    problem.settings = {{1e-12, 3000}, {1e-11, 3000}, {1e-11, 300}};
    if (!problem.friction) return problem;
    problem.friction->kinetic.reset();
    problem.rigid_slip = random_rigid_slip(seed, problem);
    if (auto* rolling = std::get_if<Rolling>(&problem.motion)) {
        rolling->steps = 1;
        rolling->force = {};
    } else {
        std::get<Shift>(problem.motion).force = {};
    }
    return problem;
}

struct DerivativeCheck {
    int compared = 0, skipped = 0;  // counts inputs; skipped if the element division changes
    double error = 0;               // largest deviation, over the largest derivative by the same input
    int worst = -1;
};

/// Returns central differences, or nothing if the element division changes.
inline std::optional<DerivativeRows> differences(const ContactProblem& problem, const ContactSolution& solution,
                                                 int input, const InputSizes& sizes) {
    ContactProblem plain = problem;
    plain.derivatives = false;
    // Simplified models are exact to rounding, and fastsim has many closely spaced kinks.
    const auto parts = problem.model == Model::full ? std::array{1e-4, 1e-5} : std::array{1e-6, 1e-7};
    for (const double part : parts) {
        const double step = part * sizes.size[input];
        const ContactSolution up = solve_half_spaces(moved(plain, input, step));
        const ContactSolution down = solve_half_spaces(moved(plain, input, -step));
        if (!up.converged() || !down.converged() || up.element_division != solution.element_division ||
            down.element_division != solution.element_division)
            continue;
        DerivativeRows result = answers_of(problem, up, sizes.length);
        const DerivativeRows below = answers_of(problem, down, sizes.length);
        for (int row = 0; row < 4; ++row) result[row] = (result[row] - below[row]) / (2 * step);
        return result;
    }
    return {};
}

/// The approach is scaled to the force that moves it. For an input with small effects, such as a motion in full slip,
/// the scale is a hundredth of the largest effect.
inline DerivativeCheck check_derivatives(const ContactProblem& problem, const ContactSolution& solution) {
    DerivativeCheck check;
    const InputSizes sizes = input_sizes(problem, solution);
    const double stiffness = problem.Fn ? 1 / *solution.derivatives->approach->Fn : 1;
    const auto found = [&](int input) {
        DerivativeRows rows = rows_of(*solution.derivatives, input, sizes.length);
        rows[3] *= stiffness;
        return rows;
    };
    double largest_of_all = 0, largest_tangential = 0;
    for (int input = 0; input < derivative_inputs; ++input) {
        const DerivativeRows rows = found(input);
        for (std::size_t row = 0; row < 4; ++row) {
            const double size = std::abs(rows[row]) * sizes.size[input];
            largest_of_all = std::max(largest_of_all, size);
            if (row < 3) largest_tangential = std::max(largest_tangential, size);
        }
    }
    for (int input = 0; input < derivative_inputs; ++input) {
        if (!(sizes.size[input] > 0)) continue;
        std::optional<DerivativeRows> expected = differences(problem, solution, input, sizes);
        ++(expected ? check.compared : check.skipped);
        if (!expected) continue;
        (*expected)[3] *= stiffness;
        const DerivativeRows rows = found(input);
        // Tangential forces depend much less on the load than the normal force, so they have a separate scale.
        const double carried = sizes.size[4] * largest_of_all;  // derivatives by friction, whose sums may cancel
        double tangential = 0.01 * std::max(largest_tangential, carried) / sizes.size[input];
        for (std::size_t row = 0; row < 3; ++row) tangential = std::max(tangential, std::abs((*expected)[row]));
        const double all = std::max({0.01 * largest_of_all / sizes.size[input], std::abs((*expected)[3]), tangential});
        double error = std::abs(rows[3] - (*expected)[3]) / all;
        const double measure = input == 3 ? tangential : all;
        for (std::size_t row = 0; row < 3 && measure > 0; ++row)
            error = std::max(error, std::abs(rows[row] - (*expected)[row]) / measure);
        if (error <= check.error) continue;
        check.error = error;
        check.worst = input;
    }
    return check;
}

}  // namespace contactd::test
