#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "contactd/below.hpp"
#include "contactd/error.hpp"
#include "contactd/solve_wheel_rail.hpp"
#include "types/number_text.hpp"
#include "wheel_rail/flexible_rail.hpp"
#include "wheel_rail/position/rising_search.hpp"

namespace contactd {
namespace {

constexpr double largest_roll = 0.2;  // rad

WheelRailState state_of(const WheelsetState& state, Side side, double roll) {
    WheelRailState wheel = side == Side::left ? state_of_left_wheel(state) : state_of_right_wheel(state);
    wheel.position.roll = roll;
    return wheel;
}

void check(const WheelRailContact& left, const WheelRailContact& right, const WheelsetState& state) {
    if (left.setup().side != Side::left) throw InvalidArgument("left", "is the contact of a right wheel");
    if (right.setup().side != Side::right) throw InvalidArgument("right", "is the contact of a left wheel");
    validate_below("state", state);
    if (left.setup().track.roller_radius.has_value() != right.setup().track.roller_radius.has_value())
        throw InvalidArgument("left.track.roller_radius",
                              std::string(left.setup().track.roller_radius ? "is given" : "is missing") +
                                  ", and the right wheel runs on a " +
                                  (right.setup().track.roller_radius ? "roller" : "rail") +
                                  "; both wheels of a wheelset run on rails, or both on rollers");
    check_rail_loads(left.setup(), state.left_rail, "state.left_rail");
    check_rail_loads(right.setup(), state.right_rail, "state.right_rail");
}

/// The result of `solve` for one wheel, which refuses fields by the names that they have for both: "state.Fz" is
/// "state.Fz_left", "state.rail.Fy" is "state.left_rail.Fy", and "dx" of the set-up is "left.dx".
template <class Solve>
auto of_wheel(Side side, const Solve& solve) {
    const std::string name = side == Side::left ? "left" : "right";
    const auto rename = [&](const std::string& field) {
        if (field == "state.Fx" || field == "state.Fz") return field + "_" + name;
        if (field.starts_with("state.rail.") || field.starts_with("state.wheel."))
            return in_place_of("state.", "state." + name + "_")(field);
        return field.starts_with("state.") ? field : name + "." + field;
    };
    return renaming(rename, solve);
}

/// A roll that lifts the left wheel lets the right one down: the height of the left axle's end less that of the right
/// one rises.
class Rolls {
   public:
    Rolls(const WheelRailContact& left, const WheelRailContact& right, const WheelsetState& state)
        : left_(left),
          right_(right),
          state_(state),
          larger_(left.setup().wheelset.nominal_radius - right.setup().wheelset.nominal_radius) {}

    double expected_difference(double roll, const Observer& observer) const {
        const auto height = [&](const WheelRailContact& wheel, Side side) {
            return of_wheel(side, [&] { return wheel.locate(state_of(state_, side, roll), observer).z; });
        };
        return height(left_, Side::left) - height(right_, Side::right) - larger_;
    }
    double difference(double roll, Observer& observer) {
        solution_.left =
            of_wheel(Side::left, [&] { return left_.solve(state_of(state_, Side::left, roll), observer); });
        solution_.right =
            of_wheel(Side::right, [&] { return right_.solve(state_of(state_, Side::right, roll), observer); });
        solution_.roll = roll;
        solution_.z = 0.5 * (solution_.left.z + solution_.right.z);
        return solution_.left.z - solution_.right.z - larger_;
    }
    RisingTask task(double start, double tolerance) const {
        constexpr double first_step = 1e-4;  // rad
        return {nullptr, start, first_step, -largest_roll, largest_roll, tolerance, 60};
    }
    WheelsetSolution& solution() { return solution_; }

   private:
    const WheelRailContact &left_, &right_;
    const WheelsetState& state_;
    double larger_;  // the left wheel's radius (mm): z of each wheel is against its own, and both have one axle
    WheelsetSolution solution_;
};

/// Heights of wheels that are not above their rails agree, too, and mean nothing.
bool carries_load(const WheelRailSolution& wheel) {
    return wheel.in_contact() && wheel.force && wheel.force->converged;
}

std::string no_load(const std::string& side, const RisingFound& found) {
    return "The " + side + " wheel does not carry its load at a roll of " + short_text(found.at) +
           " rad, and no roll was found at which both do; its own warnings say why.";
}

std::string not_found(const RisingFound& found) {
    return "No roll within " + short_text(largest_roll) + " rad brings both wheels their forces at one height: at " +
           short_text(found.at) + " rad their heights differ by " + short_text(std::abs(found.value)) + " mm.";
}

}  // namespace

// The heights that Hertz's theory expects are off by micrometres, and by nearly the same ones at all rolls.
WheelsetSolution solve_wheelset(const WheelRailContact& left, const WheelRailContact& right, const WheelsetState& state,
                                Observer& observer, double height_tolerance) {
    check(left, right, state);
    const auto begin = std::chrono::steady_clock::now();
    Rolls rolls(left, right, state);
    double roll = state.position.roll, offset = 0;
    int solves = 0;
    RisingFound found;
    for (int round = 0; round < 4; ++round) {
        RisingTask expected = rolls.task(roll, 0.1 * height_tolerance);
        expected.function = [&](double at) { return rolls.expected_difference(at, observer) + offset; };
        roll = find_rising(expected).at;
        found = {roll, rolls.difference(roll, observer), ++solves, false};
        found.converged = std::abs(found.value) <= height_tolerance;
        if (found.converged || !std::isfinite(found.value)) break;
        offset = found.value - rolls.expected_difference(roll, observer);
    }
    if (!found.converged && std::isfinite(found.value)) {
        RisingTask task = rolls.task(roll, height_tolerance);
        task.step = 1e-6;
        task.function = [&](double at) { return rolls.difference(at, observer); };
        found = find_rising(task);
        solves += found.evaluations;
    }
    WheelsetSolution solution = std::move(rolls.solution());
    const std::chrono::duration<double> duration = std::chrono::steady_clock::now() - begin;
    const char* unloaded = !carries_load(solution.left) ? "left" : !carries_load(solution.right) ? "right" : nullptr;
    solution.roll_search = {solves, std::abs(found.value), found.converged && !unloaded, duration.count()};
    if (unloaded)
        solution.warnings.push_back(no_load(unloaded, found));
    else if (!found.converged)
        solution.warnings.push_back(not_found(found));
    return solution;
}

}  // namespace contactd
