#include "wheel_rail/flexible_rail.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <string>

#include "contactd/error.hpp"
#include "types/number_text.hpp"
#include "wheel_rail/condense.hpp"
#include "wheel_rail/differentiate.hpp"
#include "wheel_rail/position/rising_search.hpp"
#include "wheel_rail/right_wheel.hpp"

namespace contactd {
namespace {

constexpr double farthest = 20;               // mm: laterally, from where the other forces have the rail
constexpr double most_usual_deflection = 20;  // mm: rails on their sleepers deflect by one or two

/// Returns the state with the rail deflected and fixed there, the wheel at its height or under its force.
WheelRailState deflected(WheelRailState state, const RailDeflection& deflection) {
    state.rail.y += deflection.y;
    state.rail.z += deflection.z;
    state.rail.Fy = state.rail.Fz = 0;
    state.Fx.reset();
    state.derivatives = false;
    return state;
}

/// Returns the deflection of a spring; that of a rigid rail is zero.
double deflection_by(double force, const std::optional<double>& stiffness) {
    return stiffness ? force / *stiffness : 0;
}

/// Returns the search for the height over the rail of a wheel at its height in the track: where the rail carries what
/// its spring then does. `unloaded` is the wheel with a rail not deflected vertically. None where it hangs above that.
std::optional<HeightTask> height_over_rail(RightWheel& unloaded, const WheelRailState& given, double stiffness) {
    if (!unloaded.first_contact_height()) return std::nullopt;
    HeightTask task = unloaded.height_task(0);
    task.target = stiffness * (given.position.z - task.first_contact_height) - given.rail.Fz;
    if (!(task.target > 0)) return std::nullopt;
    task.spring = stiffness;
    task.deepest = task.first_contact_height + std::min(deepest_penetration, task.target / stiffness);
    return task;
}

class Balance {
   public:
    Balance(const RightWheel& wheel, WheelRailEstimates& estimates, Observer& observer)
        : wheel_(wheel),
          state_(wheel.state()),
          setup_(with_fixed_rail(wheel.setup())),
          springs_(*wheel.setup().track.springs),
          estimates_(estimates),
          observer_(observer) {
        tolerance_ = setup_.force.tolerance;
        if (springs_.y) setup_.force.tolerance *= 0.1;  // what is left of one search is noise in the other
    }

    WheelRailSolution find() {
        const auto begin = std::chrono::steady_clock::now();
        if (springs_.y)
            deflect_laterally();
        else
            deflect_vertically(0);
        const double left = std::max(std::abs(excess_aside()), std::abs(excess_down()));
        const std::chrono::duration<double> duration = std::chrono::steady_clock::now() - begin;
        solution_.rail_search = {solves_, left, left <= tolerance_, duration.count()};
        solution_.rail_deflection = deflection_;
        if (solution_.force) solution_.force->converged = solution_.force->residual <= tolerance_;
        if (left > tolerance_)
            solution_.warnings.push_back(
                "No deflection of the rail balances its springs: at y = " + short_text(deflection_.y) +
                " mm and z = " + short_text(deflection_.z) + " mm " + short_text(left) +
                " of the force is left after " + std::to_string(solves_) + " solves.");
        if (const double most = std::max(std::abs(deflection_.y), std::abs(deflection_.z));
            most > most_usual_deflection)
            solution_.warnings.push_back("The rail deflects by " + short_text(most) +
                                         " mm, where rails deflect by one or two: stiffnesses of track.springs are in "
                                         "N/mm.");
        return std::move(solution_);
    }

   private:
    /// Returns the unit of the residual (N).
    double scale() const {
        const double Fz = std::abs(solution_.forces.track.Fz);
        return Fz > 0 ? Fz : std::max({std::abs(state_.rail.Fy), std::abs(state_.rail.Fz), 1.0});
    }
    double excess_aside() const {
        return springs_.y ? (*springs_.y * deflection_.y - solution_.forces.track.Fy - state_.rail.Fy) / scale() : 0;
    }
    double excess_down() const {
        return springs_.z ? (*springs_.z * deflection_.z - solution_.forces.track.Fz - state_.rail.Fz) / scale() : 0;
    }

    void deflect_laterally() {
        const double without_wheel = deflection_by(state_.rail.Fy, springs_.y);
        const double start =
            std::clamp(estimates_.rail_y.value_or(without_wheel), without_wheel - farthest, without_wheel + farthest);
        deflect_vertically(start);
        RisingTask task;
        // Were the force of the contact to stay, this would be the step to its balance.
        task.step = std::max(std::abs(excess_aside()) * scale() / *springs_.y, 1e-9);
        bool first = true;
        task.function = [&](double y) {
            if (!first) deflect_vertically(y);
            first = false;
            return excess_aside();
        };
        task.start = start;
        task.low = without_wheel - farthest;
        task.high = without_wheel + farthest;
        task.tolerance = tolerance_;
        task.max_evaluations = setup_.force.max_iterations;
        find_rising(task);
        estimates_.rail_y = deflection_.y;
    }

    void deflect_vertically(double y) {
        deflection_ = {y, 0};
        if (springs_.z && !state_.Fz) return search_down();
        deflection_.z = state_.Fz ? deflection_by(*state_.Fz + state_.rail.Fz, springs_.z) : 0;
        solve();
    }

    /// Finds the height of the wheel over the rail at which the rail carries what the spring then does.
    void search_down() {
        const WheelRailState unloaded = deflected(state_, deflection_);
        RightWheel wheel = wheel_.with(setup_, unloaded);
        std::optional<HeightTask> over_rail = height_over_rail(wheel, state_, *springs_.z);
        if (!over_rail) {
            deflection_.z = deflection_by(state_.rail.Fz, springs_.z);
            return solve();
        }
        HeightTask& task = *over_rail;
        task.force = [&](double z) {
            deflection_.z = state_.position.z - z;
            solve();
            return solution_.forces.track.Fz;
        };
        task.correction = estimates_.height;
        estimates_.height = find_height(task).correction;
    }

    void solve() {
        ++solves_;
        const WheelRailState state = deflected(state_, deflection_);
        RightWheel wheel = wheel_.with(setup_, state);
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
    RailDeflection deflection_{};
    WheelRailSolution solution_{};
    int solves_ = 0;
};

}  // namespace

WheelRailSolution solve_on_flexible_rail(const RightWheel& wheel, WheelRailEstimates& estimates, Observer& observer) {
    return Balance(wheel, estimates, observer).find();
}

void differentiate_on_flexible_rail(const RightWheel& wheel, WheelRailSolution& solution, Observer& observer) {
    const WheelRailSetup setup = with_fixed_rail(wheel.setup());
    const WheelRailState state = deflected(wheel.state(), *solution.rail_deflection);
    RightWheel on_fixed_rail = wheel.with(setup, state);
    differentiate(on_fixed_rail, solution, observer);
    if (solution.derivatives)
        condense_rail_deflection(*solution.derivatives, solution.forces.track, *wheel.setup().track.springs);
}

WheelRailSetup with_fixed_rail(WheelRailSetup setup) {
    setup.track.springs.reset();
    return setup;
}

WheelRailState expected_on_flexible_rail(const RightWheel& wheel) {
    const WheelRailState& given = wheel.state();
    const RailSprings& springs = *wheel.setup().track.springs;
    RailDeflection deflection{deflection_by(given.rail.Fy, springs.y),
                              deflection_by(given.rail.Fz + given.Fz.value_or(0), springs.z)};
    if (given.Fz || !springs.z) return deflected(given, deflection);
    const WheelRailSetup setup = with_fixed_rail(wheel.setup());
    const WheelRailState unloaded = deflected(given, {deflection.y, 0});
    RightWheel on_fixed_rail = wheel.with(setup, unloaded);
    if (const auto task = height_over_rail(on_fixed_rail, given, *springs.z))
        deflection.z = given.position.z - find_height(*task).z;
    return deflected(given, deflection);
}

void check_rail_loads(const WheelRailSetup& setup, const RailDeviation& rail, const std::string& name) {
    const RailSprings springs = setup.track.springs.value_or(RailSprings{});
    const auto check = [&](double force, const std::optional<double>& spring, const char* direction) {
        if (force != 0 && !spring)
            throw InvalidArgument(name + ".F" + direction, "is " + number_text(force) +
                                                               ", and the rail is rigid there; a force on it needs "
                                                               "track.springs." +
                                                               direction);
    };
    check(rail.Fy, springs.y, "y");
    check(rail.Fz, springs.z, "z");
}

}  // namespace contactd
