#include "friction_law.hpp"

#include <algorithm>
#include <cmath>

#include "contact/support/solver_support.hpp"

namespace contactd {
namespace {

constexpr double least_relaxation = 0.05;

}  // namespace

SlipLawIteration::SlipLawIteration(const KineticFriction& kinetic, std::span<const double> mu_static)
    : kinetic_(kinetic),
      static_(mu_static.begin(), mu_static.end()),
      mu_(static_),
      last_mu_(static_.size()),
      last_error_(static_.size()) {
    validate(kinetic, mu_static);
    if (kinetic.start == SlipStart::full_slip) std::ranges::fill(mu_, kinetic.mu);
}

double SlipLawIteration::follow(std::span<const double> slip_velocity, std::span<const double> pressure) {
    require_size(slip_velocity, mu_.size(), "slip_velocity");
    require_size(pressure, mu_.size(), "pressure");
    std::vector<double> asked(mu_.size());
    for (std::size_t i = 0; i < mu_.size(); ++i)
        asked[i] = friction_coefficient(kinetic_, static_[i], slip_velocity[i]);
    if (memory_ != nullptr) asked = memory_->after(asked, slip_velocity, pressure);
    double square = 0, reference = 0;
    for (std::size_t i = 0; i < mu_.size(); ++i) {
        const double error = asked[i] - mu_[i];
        if (pressure[i] > 0) {
            square += std::pow(error * pressure[i], 2);
            reference += std::pow(static_[i] * pressure[i], 2);
        }
        // The step is -error/slope of a secant, or 1 if the error does not decrease with mu or is not known.
        double relaxation = 1;
        const double step = mu_[i] - last_mu_[i];
        if (!is_first_ && step != 0) {
            const double slope = (error - last_error_[i]) / step;
            if (slope < -1) relaxation = std::max(-1 / slope, least_relaxation);
        }
        last_mu_[i] = mu_[i];
        last_error_[i] = error;
        mu_[i] = std::clamp(mu_[i] + relaxation * error, kinetic_.mu, static_[i]);
    }
    is_first_ = false;
    return square > 0 ? std::sqrt(square / reference) : 0;
}

}  // namespace contactd
