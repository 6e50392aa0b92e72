#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "contactd/below.hpp"
#include "contactd/error.hpp"
#include "contactd/solve_wheel_rail.hpp"
#include "types/number_text.hpp"
#include "wheel_rail/position/equilibrium_search.hpp"
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
                                  ", but the right wheel runs on a " +
                                  (right.setup().track.roller_radius ? "roller" : "rail") +
                                  "; both wheels of a wheelset must run on rails, or both on rollers");
}

/// Returns the result of `solve` for one wheel. Errors use the names of fields for both wheels: "state.Fz" is
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

/// A roll that lifts the left wheel lowers the right one: the height of the left axle's end minus that of the right one
/// increases.
class Rolls {
   public:
    Rolls(const WheelRailContact& left, const WheelRailContact& right, const WheelsetState& state,
          WheelsetEstimates& estimates)
        : left_(left),
          right_(right),
          state_(state),
          estimates_(estimates),
          larger_(left.setup().wheelset.nominal_radius - right.setup().wheelset.nominal_radius) {}

    double expected_difference(double roll, const Observer& observer) const {
        const auto height = [&](const WheelRailContact& wheel, Side side) {
            return of_wheel(side, [&] { return wheel.locate(state_of(state_, side, roll), observer).z; });
        };
        return height(left_, Side::left) - height(right_, Side::right) - larger_;
    }
    double difference(double roll, Observer& observer) {
        const auto solve = [&](const WheelRailContact& wheel, Side side, WheelRailEstimates& estimates) {
            return of_wheel(side,
                            [&] { return wheel.solve_within_step(state_of(state_, side, roll), estimates, observer); });
        };
        solution_.left = solve(left_, Side::left, estimates_.left);
        solution_.right = solve(right_, Side::right, estimates_.right);
        solution_.roll = roll;
        solution_.z = 0.5 * (solution_.left.z + solution_.right.z);
        return solution_.left.z - solution_.right.z - larger_;
    }
    /// Finds the roll at which a difference vanishes, by the distance of the contacts. If that fails, uses shrinking
    /// bounds, from a first step on (rad).
    RisingFound find(const std::function<double(double roll)>& difference, double start, double tolerance,
                     double step) const {
        EquilibriumTask near;
        near.residuals = [&](const EquilibriumTask::Values& at) {
            return EquilibriumTask::Values{difference(at.front())};
        };
        near.start = {start};
        near.low = {-largest_roll};
        near.high = {largest_roll};
        near.first_step = {1e-3};
        near.slopes = {arm()};
        near.tolerance = tolerance;
        near.max_evaluations = 8;
        const EquilibriumFound close = find_equilibrium(near);
        if (close.converged || !std::isfinite(close.residual))
            return {close.at.front(), close.residual, close.evaluations, close.converged};
        RisingFound found =
            find_rising({difference, close.at.front(), step, -largest_roll, largest_roll, tolerance, most_evaluations});
        found.evaluations += close.evaluations;
        return found;
    }
    WheelsetSolution& solution() { return solution_; }
    /// Returns the increase of the difference with the roll (mm), which is the distance of the contacts.
    double arm() const {
        const auto y = [](const WheelRailSolution& wheel) {
            return wheel.patches.empty() ? 0 : wheel.patches.front().place.reference.y;
        };
        const double distance = y(solution_.right) - y(solution_.left);
        return distance > 0 ? distance : usual_arm;
    }

   private:
    static constexpr double usual_arm = 1500;
    static constexpr int most_evaluations = 60;
    const WheelRailContact &left_, &right_;
    const WheelsetState& state_;
    WheelsetEstimates& estimates_;
    // This is the left wheel's radius minus the right one's (mm): z of each wheel is relative to its own radius, and
    // both share one axle.
    double larger_;
    WheelsetSolution solution_;
};

/// Heights of wheels that are not above their rails agree, too, but are meaningless.
bool carries_load(const WheelRailSolution& wheel) {
    return wheel.in_contact() && wheel.force && wheel.force->converged;
}

std::string no_load(const std::string& side, const RisingFound& found) {
    return "The " + side + " wheel does not carry its load at a roll of " + short_text(found.at) +
           " rad, and no roll was found at which both do. See the warnings of this wheel.";
}

std::string not_found(const RisingFound& found) {
    return "No roll within " + short_text(largest_roll) + " rad produces the forces of both wheels at one height: at " +
           short_text(found.at) + " rad their heights differ by " + short_text(std::abs(found.value)) + " mm.";
}

}  // namespace

WheelsetSolution solve_wheelset(const WheelRailContact& left, const WheelRailContact& right, const WheelsetState& state,
                                Observer& observer, double height_tolerance) {
    WheelsetEstimates estimates;
    return solve_wheelset(left, right, state, estimates, observer, height_tolerance);
}

// The heights that Hertz's theory expects have errors of micrometres, which are nearly the same at all rolls.
WheelsetSolution solve_wheelset(const WheelRailContact& left, const WheelRailContact& right, const WheelsetState& state,
                                WheelsetEstimates& estimates, Observer& observer, double height_tolerance) {
    constexpr double expected_tolerance = 1e-3;  // mm
    check(left, right, state);
    const auto begin = std::chrono::steady_clock::now();
    Rolls rolls(left, right, state, estimates);
    const auto expected = [&](double roll) { return rolls.expected_difference(roll, observer); };
    const auto solved = [&](double roll) { return rolls.difference(roll, observer); };
    if (!estimates.roll.expected())
        estimates.roll.learn(rolls.find(expected, state.position.roll, expected_tolerance, 1e-4).at);
    const RisingFound found = rolls.find(solved, *estimates.roll.expected(), height_tolerance, 1e-6);
    const int solves = found.evaluations;
    estimates.roll.learn(found.at);
    estimates.roll.end_step();
    estimates.left.end_step();
    estimates.right.end_step();
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
