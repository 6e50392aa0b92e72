#include "temperature_law.hpp"

#include <algorithm>
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
    // Between both ends the law is linear. With a slope of 1 or more there is no solution here, and one of the ends
    // applies.
    const double T = (T0 + rise * (mu - law.change * law.reference / law.range)) / (1 - rise * law.change / law.range);
    return friction_coefficient(law, mu, T);
}

TemperatureLaw::TemperatureLaw(const ContactProblem& problem)
    : laws_(laws_of(*problem.friction)),
      nx_(static_cast<std::size_t>(problem.grid.nx)),
      ny_(static_cast<std::size_t>(problem.grid.ny)),
      backwards_(std::cos(std::get<Rolling>(problem.motion).chi) < 0),
      step_(step_length(std::get<Rolling>(problem.motion), problem.grid) / problem.grid.dx),
      seconds_(step_ * problem.grid.dx / velocity_of(problem)),
      heat_(*problem.temperature, velocity_of(problem), problem.upper_speed, problem.grid.dx, nx_),
      cold_(problem.grid.size()),
      mu_(problem.grid.size()) {
    const double contact = heat_.shares(0).contact_temperature;
    for (std::size_t i = 0; i < mu_.size(); ++i) {
        cold_[i] = problem.friction->mu_of(i);
        mu_[i] = friction_coefficient(law_of(i / nx_), cold_[i], contact);
    }
}

bool TemperatureLaw::has_memory() const {
    return std::ranges::any_of(laws_, [](const TemperatureFriction& law) { return law.memory.has_value(); });
}

/// Marches a row of elements from the leading to the trailing edge.
class TemperatureLaw::Row {
   public:
    Row(const TemperatureLaw& all, std::size_t row, const MotionOfElements& motion, std::span<const double> pressure,
        std::vector<double>& mu)
        : all_(all),
          row_(row),
          motion_(motion),
          pressure_(pressure),
          mu_(mu),
          shares_(all.heat_.shares((all.backwards_ ? -1 : 1) * motion.slip_of_rows[row])),
          changes_(all.nx_) {}

    void march() {
        for (std::size_t k = 0; k < all_.nx_; ++k) {
            const std::size_t i = row_ * all_.nx_ + (all_.backwards_ ? k : all_.nx_ - 1 - k);
            if (pressure_[i] > 0) take(k, i);
        }
    }

   private:
    void take(std::size_t k, std::size_t i) {
        double T = shares_.contact_temperature;
        for (const auto& [ahead, heat] : sources_) T += heat * rise_at(k - ahead);
        const double plastic = motion_.plastic_heat.empty() ? 0 : motion_.plastic_heat[i];
        T += plastic * rise_at(0);
        const double heat_of_mu = pressure_[i] * motion_.slip_velocity[i];
        mu_[i] = coefficient(k, i, T, rise_at(0) * heat_of_mu);
        if (heat_of_mu > 0 || plastic > 0) sources_.emplace_back(k, mu_[i] * heat_of_mu + plastic);
    }

    double rise_at(std::size_t behind) const { return shares_.unit * all_.heat_.weight(behind); }

    // Applies implicit Euler along the path of the particle, which was dq ahead: a part of the carried coefficient
    // remains, and the law determines the rest, so that its temperature still follows from one equation.
    double coefficient(std::size_t k, std::size_t i, double T, double rise) {
        const TemperatureFriction& law = all_.law_of(row_);
        const double cold = all_.cold_[i];
        if (!law.memory) return coefficient_of_own_heat(law, cold, T, rise);
        const double slipped = all_.seconds_ * std::max(motion_.slip_velocity[i], law.memory->least_velocity);
        // A step shorter than an element mixes in the element's own value.
        const double from_behind = std::min(all_.step_, 1.0);
        const double brought = law.memory->distance * from_behind, part = brought / (brought + slipped);
        const double entering = friction_coefficient(law, cold, shares_.contact_temperature);
        TemperatureFriction rest = law;
        rest.change *= 1 - part;
        const double mu =
            coefficient_of_own_heat(rest, part * (entering + change_ahead(k)) + (1 - part) * cold, T, rise);
        changes_[k] = mu - entering;
        return mu;
    }

    // Returns the change of a particle's coefficient from its entry into the contact to its arrival at element k.
    double change_ahead(std::size_t k) const {
        const double step = std::max(all_.step_, 1.0), elements = std::floor(step), beyond = step - elements;
        const auto at = [&](double ahead) {
            return ahead <= static_cast<double>(k) ? changes_[k - static_cast<std::size_t>(ahead)] : 0;
        };
        return (1 - beyond) * at(elements) + (beyond > 0 ? beyond * at(elements + 1) : 0);
    }

    const TemperatureLaw& all_;
    const std::size_t row_;
    const MotionOfElements& motion_;
    const std::span<const double> pressure_;
    std::vector<double>& mu_;
    const RowShares shares_;
    std::vector<std::pair<std::size_t, double>> sources_;  // position and heat of those ahead
    std::vector<double> changes_;                          // changes of coefficients since particles entered
};

double TemperatureLaw::follow(const MotionOfElements& motion, std::span<const double> pressure) {
    std::vector<double> next = mu_;
    for (std::size_t row = 0; row < ny_; ++row) Row(*this, row, motion, pressure, next).march();
    double square = 0, reference = 0;
    for (std::size_t i = 0; i < mu_.size(); ++i) {
        if (!(pressure[i] > 0)) continue;
        square += std::pow((next[i] - mu_[i]) * pressure[i], 2);
        reference += std::pow(next[i] * pressure[i], 2);
    }
    mu_ = std::move(next);
    return square > 0 ? std::sqrt(square / reference) : 0;
}

}  // namespace contactd
