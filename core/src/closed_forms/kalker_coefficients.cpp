#include "kalker_coefficients.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "contactd/error.hpp"
#include "generated/kalker_table.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

constexpr int rows = static_cast<int>(std::size(kalker_table));
constexpr int columns = static_cast<int>(kalker_nu.size());

// Returns Lagrange's weights of equidistant nodes 0, 1, ..., N-1 at t.
template <std::size_t N>
std::array<double, N> lagrange(double t) {
    std::array<double, N> weights;
    weights.fill(1);
    for (std::size_t i = 0; i < N; ++i)
        for (std::size_t j = 0; j < N; ++j) {
            const double node = static_cast<double>(j);
            if (i != j) weights[i] *= (t - node) / (static_cast<double>(i) - node);
        }
    return weights;
}

using Logs = std::array<double, 4>;

// Coefficients of slender contacts across the long axis are proportional to 1/(1-nu), so that (1-nu) C is smooth.
Logs logs_at(int row, double nu) {
    const auto weights = lagrange<columns>(nu / kalker_nu[1]);
    Logs values{};
    for (int k = 0; k < columns; ++k)
        for (int c = 0; c < 4; ++c) values[c] += weights[k] * (1 - kalker_nu[k]) * kalker_table[row][k][c];
    for (double& value : values) value = std::log(value / (1 - nu));
    return values;
}

}  // namespace

// Ratios beyond the ends of the table by rounding errors count as inside.
bool has_kalker_coefficients(double a_over_b) {
    constexpr double last = 0.5 * (rows - 1) * kalker_log2_step, rounding = 1e-9;
    return a_over_b > 0 && std::abs(std::log2(a_over_b)) <= last + rounding;
}

KalkerCoefficients kalker_coefficients(double a_over_b, double nu) {
    if (!has_kalker_coefficients(a_over_b))
        throw InvalidArgument("a_over_b", "is " + number_text(a_over_b) + "; it must lie in [1/32, 32]");
    nu = std::clamp(nu, 0.0, 0.5);
    const double position = std::log2(a_over_b) / kalker_log2_step + 0.5 * (rows - 1);
    const int first = std::clamp(static_cast<int>(position) - 2, 0, rows - 6);
    const auto weights = lagrange<6>(position - first);
    Logs value{};
    for (int i = 0; i < 6; ++i) {
        const Logs node = logs_at(first + i, nu);
        for (int c = 0; c < 4; ++c) value[c] += weights[i] * node[c];
    }
    return {std::exp(value[0]), std::exp(value[1]), std::exp(value[2]), std::exp(value[3])};
}

}  // namespace contactd
