#include "wheel_rail/rail_on_springs.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <string>

#include "types/number_text.hpp"
#include "wheel_rail/condense.hpp"
#include "wheel_rail/differentiate.hpp"
#include "wheel_rail/right_wheel.hpp"
#include "wheel_rail/rising_search.hpp"

namespace contactd {
namespace {

constexpr double farthest = 20;            // mm: to the side, from where the other forces have the rail
constexpr double deepest_penetration = 5;  // mm: as of a rail that is held
constexpr double most_usual_shift = 20;    // mm: rails on their sleepers give way by one or two

/// The state with the rail shifted and held there, the wheel at its height or under its force.
WheelRailState shifted(WheelRailState state, const RailShift& shift) {
    state.rail.y += shift.y;
    state.rail.z += shift.z;
    state.rail.Fy = state.rail.Fz = 0;
    state.Fx.reset();
    state.derivatives = false;
    return state;
}

/// Of a spring, or zero of a rail that is rigid.
double shift_by(double force, const std::optional<double>& stiffness) {
    return stiffness ? force / *stiffness : 0;
}

/// The search for the height over the rail of a wheel at its height in the track: where the rail bears what its spring
/// then does. `unloaded` is the wheel with a rail that has not given way down. None where it hangs above that.
std::optional<HeightTask> height_over_rail(RightWheel& unloaded, const WheelRailState& given, double stiffness) {
    if (!unloaded.touch()) return std::nullopt;
    HeightTask task = unloaded.height_task(0);
    task.target = stiffness * (given.position.z - task.touch) - given.rail.Fz;
    if (!(task.target > 0)) return std::nullopt;
    task.spring = stiffness;
    task.deepest = task.touch + std::min(deepest_penetration, task.target / stiffness);
    return task;
}

class Balance {
   public:
    Balance(const RightWheel& wheel, WheelRailEstimates& estimates, Observer& observer)
        : wheel_(wheel),
          state_(wheel.state()),
          setup_(held(wheel.setup())),
          springs_(*wheel.setup().track.springs),
          estimates_(estimates),
          observer_(observer) {
        tolerance_ = setup_.force.tolerance;
        if (springs_.y) setup_.force.tolerance *= 0.1;  // what is left of one search is noise in the other
    }

    WheelRailSolution find() {
        const auto begin = std::chrono::steady_clock::now();
        if (springs_.y)
            give_way_aside();
        else
            give_way_down(0);
        const double left = std::max(std::abs(excess_aside()), std::abs(excess_down()));
        const std::chrono::duration<double> duration = std::chrono::steady_clock::now() - begin;
        solution_.rail_search = {solves_, left, left <= tolerance_, duration.count()};
        solution_.rail_shift = shift_;
        if (solution_.force) solution_.force->converged = solution_.force->residual <= tolerance_;
        if (left > tolerance_)
            solution_.warnings.push_back("No shift of the rail balances its springs: at y = " + short_text(shift_.y) +
                                         " mm and z = " + short_text(shift_.z) + " mm " + short_text(left) +
                                         " of the force is left after " + std::to_string(solves_) + " solves.");
        if (const double most = std::max(std::abs(shift_.y), std::abs(shift_.z)); most > most_usual_shift)
            solution_.warnings.push_back("The rail gives way by " + short_text(most) +
                                         " mm, where rails give way by one or two: stiffnesses of track.springs are in "
                                         "N/mm.");
        return std::move(solution_);
    }

   private:
    /// What a unit of residual is (N).
    double scale() const {
        const double Fz = std::abs(solution_.forces.track.Fz);
        return Fz > 0 ? Fz : std::max({std::abs(state_.rail.Fy), std::abs(state_.rail.Fz), 1.0});
    }
    double excess_aside() const {
        return springs_.y ? (*springs_.y * shift_.y - solution_.forces.track.Fy - state_.rail.Fy) / scale() : 0;
    }
    double excess_down() const {
        return springs_.z ? (*springs_.z * shift_.z - solution_.forces.track.Fz - state_.rail.Fz) / scale() : 0;
    }

    void give_way_aside() {
        const double without_wheel = shift_by(state_.rail.Fy, springs_.y);
        const double start =
            std::clamp(estimates_.rail_y.value_or(without_wheel), without_wheel - farthest, without_wheel + farthest);
        give_way_down(start);
        RisingTask task;
        // Were the force of the contact to stay, this would be the step to its balance.
        task.step = std::max(std::abs(excess_aside()) * scale() / *springs_.y, 1e-9);
        bool first = true;
        task.function = [&](double y) {
            if (!first) give_way_down(y);
            first = false;
            return excess_aside();
        };
        task.start = start;
        task.low = without_wheel - farthest;
        task.high = without_wheel + farthest;
        task.tolerance = tolerance_;
        task.max_evaluations = setup_.force.max_iterations;
        find_rising(task);
        estimates_.rail_y = shift_.y;
    }

    void give_way_down(double y) {
        shift_ = {y, 0};
        if (springs_.z && !state_.Fz) return search_down();
        shift_.z = state_.Fz ? shift_by(*state_.Fz + state_.rail.Fz, springs_.z) : 0;
        solve();
    }

    /// The height of the wheel over the rail at which the rail bears what the spring then does.
    void search_down() {
        const WheelRailState unloaded = shifted(state_, shift_);
        RightWheel wheel = wheel_.again(setup_, unloaded);
        std::optional<HeightTask> over_rail = height_over_rail(wheel, state_, *springs_.z);
        if (!over_rail) {
            shift_.z = shift_by(state_.rail.Fz, springs_.z);
            return solve();
        }
        HeightTask& task = *over_rail;
        task.force = [&](double z) {
            shift_.z = state_.position.z - z;
            solve();
            return solution_.forces.track.Fz;
        };
        task.correction = estimates_.height;
        estimates_.height = find_height(task).correction;
    }

    void solve() {
        ++solves_;
        const WheelRailState state = shifted(state_, shift_);
        RightWheel wheel = wheel_.again(setup_, state);
        wheel.start_from(estimates_);
        solution_ = wheel.solve(observer_);
        if (solution_.force) solves_ += solution_.force->iterations - 1;
    }

    const RightWheel& wheel_;
    const WheelRailState& state_;
    WheelRailSetup setup_;
    const RailSprings springs_;
    WheelRailEstimates& estimates_;
    Observer& observer_;
    double tolerance_;
    RailShift shift_{};
    WheelRailSolution solution_{};
    int solves_ = 0;
};

}  // namespace

WheelRailSolution solve_on_springs(const RightWheel& wheel, WheelRailEstimates& estimates, Observer& observer) {
    return Balance(wheel, estimates, observer).find();
}

void differentiate_on_springs(const RightWheel& wheel, WheelRailSolution& solution, Observer& observer) {
    const WheelRailSetup setup = held(wheel.setup());
    const WheelRailState state = shifted(wheel.state(), *solution.rail_shift);
    RightWheel on_held = wheel.again(setup, state);
    differentiate(on_held, solution, observer);
    if (solution.derivatives) let_give_way(*solution.derivatives, solution.forces.track, *wheel.setup().track.springs);
}

WheelRailSetup held(WheelRailSetup setup) {
    setup.track.springs.reset();
    return setup;
}

WheelRailState expected_on_springs(const RightWheel& wheel) {
    const WheelRailState& given = wheel.state();
    const RailSprings& springs = *wheel.setup().track.springs;
    RailShift shift{shift_by(given.rail.Fy, springs.y), shift_by(given.rail.Fz + given.Fz.value_or(0), springs.z)};
    if (given.Fz || !springs.z) return shifted(given, shift);
    const WheelRailSetup setup = held(wheel.setup());
    const WheelRailState unloaded = shifted(given, {shift.y, 0});
    RightWheel on_held = wheel.again(setup, unloaded);
    if (const auto task = height_over_rail(on_held, given, *springs.z))
        shift.z = given.position.z - find_height(*task).z;
    return shifted(given, shift);
}

}  // namespace contactd
