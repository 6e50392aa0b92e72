#include "wheel_rail/differentiate.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/motion/creepages.hpp"
#include "wheel_rail/patch_derivatives.hpp"
#include "wheel_rail/resultants.hpp"
#include "wheel_rail/right_wheel.hpp"

namespace contactd {
namespace {

using geometry::CandidatePatch;
using geometry::Position;

/// Returns (a - b) over a length.
Wrench difference(const Wrench& a, const Wrench& b, double over) {
    const auto of = [&](double Wrench::* part) { return (a.*part - b.*part) / over; };
    return {of(&Wrench::Fx), of(&Wrench::Fy), of(&Wrench::Fz), of(&Wrench::Mx), of(&Wrench::My), of(&Wrench::Mz)};
}

void add(Wrench& sum, double factor, const Wrench& part) {
    for (double Wrench::* of : {&Wrench::Fx, &Wrench::Fy, &Wrench::Fz, &Wrench::Mx, &Wrench::My, &Wrench::Mz})
        sum.*of += factor * (part.*of);
}

/// Describes a component of the motion, and its step to either side.
struct VelocityStep {
    double WheelsetVelocity::* of;
    Wrench WheelRailDerivatives::ByVelocity::* derivative;
    double size;
};
struct PositionStep {
    double& (*of)(WheelsetPosition&);
    Wrench WheelRailDerivatives::ByPosition::* derivative;
    double size;
};

class Differences {
   public:
    Differences(RightWheel& wheel, const WheelRailSolution& solution, Observer& observer)
        : wheel_(wheel), solution_(solution), observer_(observer), fine_(wheel.setup()), state_(wheel.state()) {
        constexpr double finer = 1e-2;
        for (SolverSettings* settings : {&fine_.settings.normal, &fine_.settings.tangential, &fine_.settings.outer})
            settings->tolerance *= finer;
        state_.position.z = solution.z;
        state_.velocity.pitch = solution.pitch_rate;
    }

    WheelRailDerivatives find() {
        WheelRailDerivatives derivatives;
        for (const PositionStep& step : position_steps()) derivatives.position.*step.derivative = by(step);
        if (!by_creepages(derivatives.velocity))
            for (const VelocityStep& step : velocity_steps(1e-5)) derivatives.velocity.*step.derivative = by(step);
        return derivatives;
    }

   private:
    /// Returns steps that change the approach by a thousandth at the contacts that carry the wheel.
    std::vector<PositionStep> position_steps() const {
        double approach = 0, incline = 0;
        for (const WheelRailPatch& patch : solution_.patches) {
            approach = std::max(approach, patch.place.approach);
            incline = std::max(incline, std::abs(std::tan(patch.place.reference.angle)));
        }
        const double arm = wheel_.position().wheel(0).base_y(), down = 1e-3 * approach;
        const double aside = std::min(5e-3, 10 * down / std::max(incline, 0.1));
        using By = WheelRailDerivatives::ByPosition;
        using At = WheelsetPosition;
        return {{[](At& at) -> double& { return at.y; }, &By::y, aside},
                {[](At& at) -> double& { return *at.z; }, &By::z, down},
                {[](At& at) -> double& { return at.roll; }, &By::roll, down / arm},
                {[](At& at) -> double& { return at.yaw; }, &By::yaw, 1e-5}};
    }

    std::vector<VelocityStep> velocity_steps(double share) const {
        double speed = 0;
        for (const WheelRailPatch& patch : solution_.patches) speed = std::max(speed, patch.place.creepages.velocity);
        const double straight = share * speed, angular = straight / wheel_.setup().wheelset.nominal_radius;
        using By = WheelRailDerivatives::ByVelocity;
        return {{&WheelsetVelocity::x, &By::x, straight},    {&WheelsetVelocity::y, &By::y, straight},
                {&WheelsetVelocity::z, &By::z, straight},    {&WheelsetVelocity::roll, &By::roll, angular},
                {&WheelsetVelocity::yaw, &By::yaw, angular}, {&WheelsetVelocity::pitch, &By::pitch, angular}};
    }

    Wrench forces_of(const WheelRailState& state) const {
        return wheel_.with(fine_, state).at(state.position.height(), observer_).forces.track;
    }

    Wrench by(const PositionStep& step) const {
        WheelRailState more = state_, less = state_;
        step.of(more.position) += step.size;
        step.of(less.position) -= step.size;
        return difference(forces_of(more), forces_of(less), 2 * step.size);
    }

    Wrench by(const VelocityStep& step) const {
        if (step.size == 0) return {};
        WheelRailState more = state_, less = state_;
        more.velocity.*step.of += step.size;
        less.velocity.*step.of -= step.size;
        return difference(forces_of(more), forces_of(less), 2 * step.size);
    }

    /// Computes derivatives through the creepages of each contact; returns false if these are not available.
    bool by_creepages(WheelRailDerivatives::ByVelocity& derivatives) {
        if (!fine_.friction) return true;  // Nothing depends on the motion.
        if (!acts_through_creepages(fine_, state_)) return false;
        wheel_.set_velocity(state_.velocity);
        for (CandidatePatch& found : wheel_.position().candidates(solution_.z)) {
            if (!wheel_.position().measure(found, solution_.z)) continue;
            ContactProblem problem = wheel_.problem_of(found);
            if (!problem.friction) return true;
            problem.derivatives = true;
            const ContactSolution solution = wheel_.solve(std::move(problem), found, observer_);
            if (!solution.derivatives || !solution.derivatives->Fx) return false;
            for (const VelocityStep& step : velocity_steps(1e-4))
                add_creepages(found, *solution.derivatives, step, derivatives.*step.derivative);
        }
        return true;
    }

    Creepages creepages_at(const ContactPlace& place, const VelocityStep& step, double sign) const {
        WheelRailState state = state_;
        state.velocity.*step.of += sign * step.size;
        return geometry::creepages(wheel_.position().wheel(solution_.z), wheel_.position().rail(), state,
                                   place.reference, place.approach);
    }

    void add_creepages(const CandidatePatch& found, const Derivatives& known, const VelocityStep& step, Wrench& sum) {
        const ContactPlace& place = found.place;
        const Creepages more = creepages_at(place, step, 1), less = creepages_at(place, step, -1);
        const auto add_one = [&](double Creepages::* creepage, std::optional<double> DerivativesOfAnswer::* by) {
            ContactSolution unit;
            const auto of = [&](const std::optional<DerivativesOfAnswer>& answer) {
                return answer ? ((*answer).*by).value_or(0) : 0;
            };
            unit.forces = {0, of(known.Fx), of(known.Fy), of(known.Mz)};
            const Wrench track = resultants(place, unit, true, {found.slopes, fine_.slope_forces}, {}, {}).track;
            add(sum, (more.*creepage - less.*creepage) / (2 * step.size), track);
        };
        add_one(&Creepages::xi, &DerivativesOfAnswer::xi);
        add_one(&Creepages::eta, &DerivativesOfAnswer::eta);
        add_one(&Creepages::phi, &DerivativesOfAnswer::phi);
    }

    RightWheel& wheel_;
    const WheelRailSolution& solution_;
    Observer& observer_;
    WheelRailSetup fine_;
    WheelRailState state_;
};

}  // namespace

void differentiate(RightWheel& wheel, WheelRailSolution& solution, Observer& observer) {
    if (solution.in_contact() && solution.converged()) {
        solution.derivatives = Differences(wheel, solution, observer).find();
        differentiate_pressures(wheel, solution, observer);
        return;
    }
    solution.warnings.emplace_back(solution.in_contact() ? "The solution did not converge, so it has no derivatives."
                                                         : "There is no contact, so there are no derivatives.");
}

}  // namespace contactd
