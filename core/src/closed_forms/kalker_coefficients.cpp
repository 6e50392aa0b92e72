#include "contactd/kalker_coefficients.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "kalker_table.hpp"

namespace contactd {
namespace {

constexpr int rows = static_cast<int>(std::size(kalker_table));
constexpr int columns = static_cast<int>(kalker_nu.size());

// Lagrange's weights of equidistant nodes 0, 1, ..., N-1 at t.
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

// Slender contacts have coefficients proportional to 1/(1-nu) across the long axis: (1-nu) C is what is smooth.
Logs logs_at(int row, double nu) {
    const auto weights = lagrange<columns>(nu / kalker_nu[1]);
    Logs values{};
    for (int k = 0; k < columns; ++k)
        for (int c = 0; c < 4; ++c) values[c] += weights[k] * (1 - kalker_nu[k]) * kalker_table[row][k][c];
    for (double& value : values) value = std::log(value / (1 - nu));
    return values;
}

}  // namespace

KalkerCoefficients kalker_coefficients(double a_over_b, double nu) {
    nu = std::clamp(nu, 0.0, 0.5);
    const double position = std::log2(a_over_b) / kalker_log2_step + 0.5 * (rows - 1);
    const double inside = std::clamp(position, 0.0, rows - 1.0);
    const int first = std::clamp(static_cast<int>(inside) - 2, 0, rows - 6);
    const auto weights = lagrange<6>(inside - first);
    Logs value{};
    for (int i = 0; i < 6; ++i) {
        const Logs node = logs_at(first + i, nu);
        for (int c = 0; c < 4; ++c) value[c] += weights[i] * node[c];
    }
    if (position != inside) {  // the power of a/b between the last two rows
        const int last = position < 0 ? 0 : rows - 2;
        const Logs low = logs_at(last, nu), high = logs_at(last + 1, nu);
        for (int c = 0; c < 4; ++c) value[c] += (high[c] - low[c]) * (position - inside);
    }
    return {std::exp(value[0]), std::exp(value[1]), std::exp(value[2]), std::exp(value[3])};
}

}  // namespace contactd
