#include "wheel_rail/balance.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "types/number_text.hpp"
#include "wheel_rail/flexible_rail.hpp"
#include "wheel_rail/position/equilibrium_search.hpp"
#include "wheel_rail/position/rising_search.hpp"
#include "wheel_rail/right_wheel.hpp"

namespace contactd {
namespace {

using Values = EquilibriumTask::Values;

constexpr double farthest = 100;              // mm: laterally, from the position by the other forces
constexpr double most_usual_deflection = 20;  // mm: rails on their sleepers deflect by one or two

class Balance {
   public:
    Balance(const RightWheel& wheel, WheelRailEstimates& estimates, Observer& observer)
        : wheel_(wheel),
          given_(wheel.state()),
          springs_(wheel.setup().track.springs),
          setup_(with_fixed_rail(wheel.setup())),
          estimates_(estimates),
          observer_(observer),
          rolling_(rolling_pitch_rate(wheel.setup(), wheel.state())),
          pitch_(given_.Fx ? rolling_ * (1 + estimates.slip.value_or(0)) : given_.velocity.pitch),
          tolerance_(setup_.force.tolerance) {
        if (has_lateral_spring()) setup_.force.tolerance *= 0.1;  // The error of one search is noise in the other.
    }

    WheelRailSolution find() {
        const auto begin = std::chrono::steady_clock::now();
        if (!given_.Fx && !has_lateral_spring())
            solve(0);
        else if (!find_together())
            find_one_within_the_other();
        const std::chrono::duration<double> duration = std::chrono::steady_clock::now() - begin;
        if (springs_) report_deflection(duration.count());
        if (given_.Fx) report_pitch(duration.count());
        return std::move(solution_);
    }

   private:
    bool has_lateral_spring() const { return springs_ && springs_->y; }
    bool has_vertical_spring() const { return springs_ && springs_->z; }

    /// Returns the unit of the residuals (N).
    double scale() const {
        const double Fz = std::abs(solution_.forces.track.Fz);
        return Fz > 0 ? Fz : std::max({std::abs(given_.rail.Fy), std::abs(given_.rail.Fz), 1.0});
    }
    double excess_forwards() const {
        return solution_.forces.track.Fz > 0 ? (solution_.forces.wheelset.Fx - *given_.Fx) / scale() : 0;
    }
    double excess_aside() const {
        if (!has_lateral_spring()) return 0;
        return (*springs_->y * deflection_.y - solution_.forces.track.Fy - given_.rail.Fy) / scale();
    }
    double excess_down() const {
        if (!has_vertical_spring()) return 0;
        return (*springs_->z * deflection_.z - solution_.forces.track.Fz - given_.rail.Fz) / scale();
    }

    // A larger pitch rate pulls the rail forwards; a rail that is moved aside pushes back at least by its spring.
    bool find_together() {
        EquilibriumTask task;
        const auto unknown = [&](double start, double around, double reach, double first_step) {
            task.start.push_back(std::clamp(start, around - reach, around + reach));
            task.low.push_back(around - reach);
            task.high.push_back(around + reach);
            task.first_step.push_back(first_step);
        };
        const bool pitches = given_.Fx.has_value(), deflects = has_lateral_spring();
        const double unit = std::abs(rolling_);
        if (pitches && !(unit > 0)) return false;
        if (pitches) unknown(pitch_, rolling_, unit, 1e-3 * unit);
        const double without_wheel = deflects ? given_.rail.Fy / *springs_->y : 0;
        if (deflects) unknown(estimates_.rail_y.value_or(without_wheel), without_wheel, farthest, first_deflection);
        task.slopes = estimates_.balance_slopes;
        if (task.slopes.size() != task.start.size() * task.start.size()) {
            const double force = std::max(given_.Fz.value_or(usual_force), 1.0);
            const double forwards = Kalker_slope / unit, aside = deflects ? *springs_->y / force : 0;
            if (pitches && deflects)
                task.slopes = {forwards, 0, 0, aside};
            else
                task.slopes = {pitches ? forwards : aside};
        }
        task.residuals = [&](const Values& x) {
            if (pitches) pitch_ = x.front();
            solve(deflects ? x.back() : 0);
            Values residuals;
            if (pitches) residuals.push_back(excess_forwards());
            if (deflects) residuals.push_back(excess_aside());
            return residuals;
        };
        task.tolerance = tolerance_;
        task.max_evaluations = std::min(most_evaluations, setup_.force.max_iterations);
        const EquilibriumFound found = find_equilibrium(task);
        if (!found.converged) return false;
        estimates_.balance_slopes = found.slopes;
        if (pitches) estimates_.slip = pitch_ / rolling_ - 1;
        if (deflects) estimates_.rail_y = deflection_.y;
        return true;
    }

    /// Searches by secants between shrinking bounds, which also end where functions are steep or jump.
    void find_one_within_the_other() {
        if (!given_.Fx) return deflect_laterally();
        const double unit = std::abs(rolling_);
        RisingTask task;
        task.function = [&](double pitch) {
            pitch_ = pitch;
            if (has_lateral_spring())
                deflect_laterally();
            else
                solve(0);
            return excess_forwards();
        };
        task.start = rolling_;
        task.step = 1e-3 * unit;
        task.low = rolling_ - unit;
        task.high = rolling_ + unit;
        task.tolerance = tolerance_;
        task.max_evaluations = setup_.force.max_iterations;
        find_rising(task);
        estimates_.slip.reset();
    }

    void deflect_laterally() {
        const double without_wheel = given_.rail.Fy / *springs_->y;
        const double start =
            std::clamp(estimates_.rail_y.value_or(without_wheel), without_wheel - farthest, without_wheel + farthest);
        solve(start);
        RisingTask task;
        // This would be the step to the balance if the force of the contact were constant.
        task.step = std::max(std::abs(excess_aside()) * scale() / *springs_->y, 1e-9);
        bool first = true;
        task.function = [&](double y) {
            if (!first) solve(y);
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

    /// Solves the wheel at a lateral deflection of the rail (mm) and the pitch rate.
    void solve(double y) {
        if (has_vertical_spring() && !given_.Fz) return search_down(y);
        solve_fixed({y, has_vertical_spring() ? (*given_.Fz + given_.rail.Fz) / *springs_->z : 0});
    }

    /// Finds the height of the wheel over the rail at which contact and spring carry the same force.
    void search_down(double y) {
        RightWheel wheel = wheel_.with(setup_, deflected(given_, {y, 0}));
        std::optional<HeightTask> over_rail = height_over_rail(wheel, given_, *springs_->z);
        if (!over_rail) return solve_fixed({y, given_.rail.Fz / *springs_->z});
        HeightTask& task = *over_rail;
        task.force = [&](double& z) {
            solve_fixed({y, given_.position.height() - z});
            return solution_.forces.track.Fz;
        };
        task.correction = estimates_.height;
        estimates_.height = find_height(task).correction;
    }

    void solve_fixed(const RailDeflection& deflection) {
        if (!fixed_ || !(deflection == deflection_)) {
            deflection_ = deflection;
            // The position of a RightWheel is fixed on construction.
            fixed_.reset(new RightWheel(wheel_.with(setup_, deflected(given_, deflection))));
        }
        WheelsetVelocity velocity = given_.velocity;
        velocity.pitch = pitch_;
        fixed_->set_velocity(velocity);
        fixed_->start_from(estimates_);
        solution_ = fixed_->solve(observer_);
        ++evaluations_;
        solves_ += solution_.force ? solution_.force->iterations : 1;
    }

    void report_deflection(double seconds) {
        const double left = std::max(std::abs(excess_aside()), std::abs(excess_down()));
        solution_.rail_search = {solves_, left, left <= tolerance_, seconds};
        solution_.rail_deflection = deflection_;
        if (solution_.force) solution_.force->converged = solution_.force->residual <= tolerance_;
        if (left > tolerance_)
            solution_.warnings.push_back(
                "No deflection of the rail balances its springs: at y = " + short_text(deflection_.y) +
                " mm and z = " + short_text(deflection_.z) + " mm, a fraction of " + short_text(left) +
                " of the force remains after " + std::to_string(solves_) + " solves.");
        if (const double most = std::max(std::abs(deflection_.y), std::abs(deflection_.z));
            most > most_usual_deflection)
            solution_.warnings.push_back(
                "The rail deflects by " + short_text(most) +
                " mm, but rails usually deflect by one or two. Give stiffnesses of track.springs in N/mm.");
    }

    void report_pitch(double seconds) {
        const double left = std::abs(excess_forwards());
        solution_.pitch_search = {evaluations_, left, left <= tolerance_, seconds};
        if (left <= tolerance_) return;
        solution_.warnings.push_back("No pitch rate produces Fx = " + number_text(*given_.Fx) + " N: at " +
                                     number_text(pitch_) + " rad/s it is " + short_text(solution_.forces.wheelset.Fx) +
                                     " N.");
    }

    static constexpr int most_evaluations = 15;
    static constexpr double first_deflection = 0.2;  // mm
    static constexpr double usual_force = 80'000;    // N
    static constexpr double Kalker_slope = 100;      // approximate slope of Fx/Fz over the longitudinal creepage

    const RightWheel& wheel_;
    const WheelRailState& given_;
    const std::optional<RailSprings> springs_;
    WheelRailSetup setup_;
    WheelRailEstimates& estimates_;
    Observer& observer_;
    const double rolling_;  // pitch rate without creepage (rad/s)
    double pitch_, tolerance_;
    RailDeflection deflection_{};
    std::unique_ptr<RightWheel> fixed_;  // on a rail that is fixed in its deflected position
    WheelRailSolution solution_{};
    int evaluations_ = 0, solves_ = 0;
};

}  // namespace

WheelRailSolution solve_in_balance(const RightWheel& wheel, WheelRailEstimates& estimates, Observer& observer) {
    return Balance(wheel, estimates, observer).find();
}

}  // namespace contactd
