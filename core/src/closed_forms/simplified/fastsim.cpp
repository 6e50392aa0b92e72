#include "fastsim.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "closed_forms/force_search.hpp"
#include "closed_forms/kalker_coefficients.hpp"
#include "closed_forms/rolling_frame.hpp"
#include "fastsim_ellipse.hpp"
#include "fastsim_samples.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

void validate(const FastsimSettings& settings) {
    const auto check = [](int value, const char* field) {
        if (value < 8 || value > 10'000)
            throw InvalidArgument(field, "is " + std::to_string(value) + "; it must lie in [8, 10000]");
    };
    check(settings.steps, "fastsim.steps");
    check(settings.slices, "fastsim.slices");
}

// Estimates the creepage for a force by the cubic law of Vermeulen and Johnson with Kalker's slopes.
Pair estimate(const Pair& force, double bound, const Pair& slope) {
    const double size = std::hypot(force[0], force[1]);
    if (size == 0) return {};
    const double share = 3 * bound * (1 - std::cbrt(1 - size / bound)) / size;
    return {-share * force[0] / slope[0], -share * force[1] / slope[1]};
}

}  // namespace

Flexibilities flexibilities(const SemiAxes& axes, const Material& combined) {
    const double ratio = axes.a / axes.b;
    if (!has_kalker_coefficients(ratio))
        throw InvalidArgument("gap", "results in a contact ellipse with semi-axes of " + number_text(axes.a) +
                                         " mm along and " + number_text(axes.b) +
                                         " mm across the rolling direction, a ratio of " + number_text(ratio) +
                                         "; fastsim has Kalker's coefficients for ratios of 1/32 to 32: use model "
                                         "full, or hertz if there is no spin");
    const KalkerCoefficients C = kalker_coefficients(ratio, combined.nu);
    const double unit = axes.a / combined.G;
    return {8 * unit / (3 * C.C11), 8 * unit / (3 * C.C22),
            std::numbers::pi * unit * std::sqrt(axes.a / axes.b) / (4 * C.C23)};
}

EllipticFriction fastsim(const Grid& grid, const EllipticContact& contact, double mu, const Rolling& rolling,
                         const FastsimSettings& settings) {
    validate(settings);
    const PrescribedForce prescribed{rolling.force.Fx, rolling.force.Fy, mu * contact.Fn};
    check_reach(prescribed, "friction.rolling.force");
    EllipticFriction result;
    for (auto* values : {&result.traction_x, &result.traction_y, &result.slip_x, &result.slip_y})
        values->resize(grid.size());
    result.element_division.assign(grid.size(), ElementState::exterior);
    result.frictional_power = 0;
    result.motion = rolling;
    if (contact.empty()) {
        if (!rolling.force.empty()) result.force = SolverEvidence{0, 0, true, 0};
        return result;
    }
    const RollingFrame frame = rolling_frame(contact.axes, rolling.chi);
    const FastsimEllipse ellipse(frame, contact.combined, 2 * prescribed.bound / contact.area(), settings);
    const auto local = [&](const Pair& w) {
        return FastsimCreepages<double>{frame.along(w[0], w[1]), frame.across(w[0], w[1]), rolling.phi};
    };
    const auto force = [&](const Pair& w) {
        const FastsimTotals<double> sum = ellipse.totals(local(w));
        return Pair{frame.x_of(sum.Fx, sum.Fy), frame.y_of(sum.Fx, sum.Fy)};
    };
    const Flexibilities& L = ellipse.L();
    const double volume = 8 * frame.axes.a * frame.axes.a * frame.axes.b / 3;
    const Pair slope{volume / L.L1, volume / L.L2};
    const double Fx = rolling.force.Fx.value_or(0), Fy = rolling.force.Fy.value_or(0);
    const Pair guess = estimate({frame.along(Fx, Fy), frame.across(Fx, Fy)}, prescribed.bound, slope);
    Pair w{rolling.force.Fx ? frame.x_of(guess[0], guess[1]) : rolling.xi,
           rolling.force.Fy ? frame.y_of(guess[0], guess[1]) : rolling.eta};
    result.force = find_motion(force, prescribed, {prescribed.bound / slope[0], prescribed.bound / slope[1]}, w);
    std::get<Rolling>(result.motion).xi = w[0];
    std::get<Rolling>(result.motion).eta = w[1];

    const FastsimTotals<double> sum = ellipse.totals(local(w));
    result.Fx = frame.x_of(sum.Fx, sum.Fy);
    result.Fy = frame.y_of(sum.Fx, sum.Fy);
    result.Mz = sum.Mz;
    result.frictional_power = sum.power * rolling.velocity;
    result.slip_area = sum.slip_area;
    result.adhesion_area = std::max(0.0, contact.area() - sum.slip_area);
    sample(grid, frame, ellipse, local(w), settings.steps / 2, result);
    return result;
}

ForcesByMotion fastsim_by_motion(const EllipticContact& contact, double mu, const Rolling& rolling,
                                 const FastsimSettings& settings) {
    const RollingFrame frame = rolling_frame(contact.axes, rolling.chi);
    const FastsimEllipse ellipse(frame, contact.combined, 2 * mu * contact.Fn / contact.area(), settings);
    const FastsimTotals<Dual> sum = ellipse.totals(
        FastsimCreepages<Dual>{Dual::input(frame.along(rolling.xi, rolling.eta), 0),
                               Dual::input(frame.across(rolling.xi, rolling.eta), 1), Dual::input(rolling.phi, 2)});
    return in_coordinates(frame, {sum.Fx.by, sum.Fy.by, sum.Mz.by});
}

}  // namespace contactd
