#include "temperature_law.hpp"

#include <cmath>
#include <utility>
#include <variant>

namespace contactd {
namespace {

std::vector<TemperatureFriction> laws_of(const FrictionLaw& friction) {
    return friction.temperature ? std::vector{*friction.temperature} : friction.temperature_of_rows;
}

double velocity_of(const ContactProblem& problem) {
    return std::get<Rolling>(problem.motion).velocity;
}

}  // namespace

double coefficient_of_own_heat(const TemperatureFriction& law, double mu, double T0, double rise) {
    if (T0 + rise * mu <= law.reference) return mu;
    const double hot = mu + law.change;
    if (T0 + rise * hot >= law.reference + law.range) return hot;
    // In between it is linear; a slope of 1 or more has no solution there, and left by one of the ends.
    const double T = (T0 + rise * (mu - law.change * law.reference / law.range)) / (1 - rise * law.change / law.range);
    return friction_coefficient(law, mu, T);
}

TemperatureLaw::TemperatureLaw(const ContactProblem& problem)
    : laws_(laws_of(*problem.friction)),
      nx_(static_cast<std::size_t>(problem.grid.nx)),
      ny_(static_cast<std::size_t>(problem.grid.ny)),
      backwards_(std::cos(std::get<Rolling>(problem.motion).chi) < 0),
      heat_(*problem.temperature, velocity_of(problem), problem.grid.dx, nx_),
      cold_(problem.grid.size()),
      mu_(problem.grid.size()) {
    for (std::size_t i = 0; i < mu_.size(); ++i) {
        cold_[i] = problem.friction->mu_of(i);
        mu_[i] = friction_coefficient(law_of(i / nx_), cold_[i], heat_.contact_temperature());
    }
}

double TemperatureLaw::follow(std::span<const double> slip_velocity, std::span<const double> pressure) {
    std::vector<double> next = mu_;
    for (std::size_t row = 0; row < ny_; ++row) march(row, slip_velocity, pressure, next);
    double square = 0, reference = 0;
    for (std::size_t i = 0; i < mu_.size(); ++i) {
        if (!(pressure[i] > 0)) continue;
        square += std::pow((next[i] - mu_[i]) * pressure[i], 2);
        reference += std::pow(next[i] * pressure[i], 2);
    }
    mu_ = std::move(next);
    return square > 0 ? std::sqrt(square / reference) : 0;
}

void TemperatureLaw::march(std::size_t row, std::span<const double> slip_velocity, std::span<const double> pressure,
                           std::vector<double>& mu) const {
    std::vector<std::pair<std::size_t, double>> sources;  // place and heat of those ahead
    for (std::size_t k = 0; k < nx_; ++k) {
        const std::size_t i = row * nx_ + (backwards_ ? k : nx_ - 1 - k);
        if (!(pressure[i] > 0)) continue;
        double T = heat_.contact_temperature();
        for (const auto& [ahead, heat] : sources) T += heat * heat_.weight(k - ahead);
        const double heat_of_mu = pressure[i] * slip_velocity[i];
        mu[i] = coefficient_of_own_heat(law_of(row), cold_[i], T, heat_.weight(0) * heat_of_mu);
        if (heat_of_mu > 0) sources.emplace_back(k, mu[i] * heat_of_mu);
    }
}

}  // namespace contactd
