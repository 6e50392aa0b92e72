#include "influence/layered/octave_integrals.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace contactd {
namespace {

using Kernel = RadialFunction::Kernel;

double integer_power(double base, int exponent) {
    double result = 1;
    for (int i = 0; i < std::abs(exponent); ++i) result *= base;
    return exponent < 0 ? 1 / result : result;
}

// Returns the wavenumber below which compliances are those at zero for any layers: a plate on soft ground has an effect
// at small wavenumbers.
double smallest_wavenumber(const Layers& body) {
    double total = 0, softest = body.surface().G, stiffest = softest;
    const auto add = [&](double G) {
        softest = std::min(softest, G);
        stiffest = std::max(stiffest, G);
    };
    for (const Layer& layer : body.layers) {
        total += layer.thickness;
        add(layer.G);
    }
    if (!body.base.is_rigid()) add(body.base.G);
    return softest / stiffest / (16 * total);
}

}  // namespace

/// Holds the first powers of z = k rho in J_1, J_0 - 1 and J_1 - z/2; the exponent increases by two.
struct OctaveIntegrals::Series {
    int first;
    std::array<double, terms> factors;
};

OctaveIntegrals::Series OctaveIntegrals::series_of(Kernel kernel) {
    switch (kernel) {
        case Kernel::J1:
            return {1, {1.0 / 2, -1.0 / 16, 1.0 / 384}};
        case Kernel::J0_regularised:
            return {2, {-1.0 / 4, 1.0 / 64, -1.0 / 2304}};
        case Kernel::J1_regularised:
            break;
    }
    return {3, {-1.0 / 16, 1.0 / 384, -1.0 / 18432}};
}

OctaveIntegrals::OctaveIntegrals(const Layers& body, std::vector<RadialFunction> functions, double largest)
    : waves_(body),
      functions_(std::move(functions)),
      length_(largest / 4),
      smallest_(smallest_wavenumber(body)),
      G_(body.surface().G),
      gauss_(gauss_legendre(20)),
      moments_(functions_.size()),
      weighted_(functions_.size(), std::vector<double>(wavenumbers().k.size())),
      added_(functions_.size()) {}

double OctaveIntegrals::lacking(double k) const {
    return -std::expm1(-(k * length_) * (k * length_));
}

void OctaveIntegrals::add_panel(double from, double to) {
    for (const auto& [node, part] : gauss_) {
        const double k = from + node * (to - from), weight = part * (to - from);
        const WaveCompliance compliance = waves_.at(k);
        for (std::size_t f = 0; f < functions_.size(); ++f) {
            const auto& [component, power, kernel] = functions_[f];
            const double value = weight * component(compliance);
            double term = value * integer_power(k, series_of(kernel).first - power);
            for (double& moment : moments_[f].powers) {
                moment += term;
                term *= k * k;
            }
            if (kernel != Kernel::J1)
                moments_[f].regularisation +=
                    value * integer_power(k, (kernel == Kernel::J1_regularised ? 1 : 0) - power) * lacking(k);
        }
    }
}

// Panels of doubling length resolve all scales that layers may have.
void OctaveIntegrals::add_moments(double to) {
    double end = to;
    if (below_ == 0)
        for (; end > smallest_; end /= 2) add_panel(end / 2, end);
    add_panel(below_, end);
    below_ = to;
}

void OctaveIntegrals::weigh(double p) {
    const Wavenumbers& rule = wavenumbers();
    added_.assign(functions_.size(), 0);
    for (std::size_t j = 0; j < rule.k.size(); ++j) {
        const double k = rule.k[j] / p, missing = lacking(k);
        const WaveCompliance compliance = waves_.at(k);
        for (std::size_t f = 0; f < functions_.size(); ++f) {
            const auto& [component, power, kernel] = functions_[f];
            const double value = rule.weight[j] / p * component(compliance) * integer_power(k, -power);
            weighted_[f][j] = value;
            if (kernel == Kernel::J0_regularised) added_[f] += value * missing;
            if (kernel == Kernel::J1_regularised) added_[f] += value * k * missing;
        }
    }
}

double OctaveIntegrals::value(std::size_t function, std::size_t radius, double p) const {
    const Wavenumbers& rule = wavenumbers();
    const Kernel kernel = functions_[function].kernel;
    const auto& bessel = (kernel == Kernel::J1               ? rule.J1
                          : kernel == Kernel::J0_regularised ? rule.J0_less_1
                                                             : rule.J1_less_half)[radius];
    const std::vector<double>& weighted = weighted_[function];
    double sum = 0;
    for (std::size_t j = 0; j < weighted.size(); ++j) sum += weighted[j] * bessel[j];

    const Moments& moments = moments_[function];
    const Series series = series_of(kernel);
    const double rho = p * rule.rho[radius];
    double power = integer_power(rho, series.first);
    for (std::size_t n = 0; n < terms; ++n) {
        sum += series.factors[n] * power * moments.powers[n];
        power *= rho * rho;
    }
    const double added = added_[function] + moments.regularisation;
    if (kernel == Kernel::J0_regularised) sum += added;
    if (kernel == Kernel::J1_regularised) sum += rho / 2 * added;
    return sum / (2 * std::numbers::pi * G_);
}

OctaveIntegrals::Values OctaveIntegrals::at_nodes(double p) {
    add_moments(Wavenumbers::least / p);
    weigh(p);
    Values result;
    for (std::size_t i = 0; i < result.size(); ++i)
        for (std::size_t f = 0; f < functions_.size(); ++f) result[i].push_back(value(f, i, p));
    return result;
}

}  // namespace contactd
