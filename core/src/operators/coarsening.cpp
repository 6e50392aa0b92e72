#include "coarsening.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace contactd {
namespace {

constexpr int smallest_size_to_coarsen = 20;

int factor(int n) {
    return n >= smallest_size_to_coarsen ? 2 : 1;
}

// Describes the position of the centre of fine element i between the centres of coarse ones.
struct Between {
    std::size_t first, second;
    double weight;  // of the second
};

Between between(int i, int factor, int coarse_n) {
    const double at = (i + 0.5) / factor - 0.5;
    const int first = at < 0 ? 0 : static_cast<int>(at);
    const double weight = std::clamp(at - first, 0.0, 1.0);
    return {static_cast<std::size_t>(first), static_cast<std::size_t>(std::min(first + 1, coarse_n - 1)), weight};
}

// Returns the mean of `at(a, b)` over the pairs of fine elements in two coarse ones, times the number of loaded ones.
// Each offset of fine elements is weighted with its frequency between two coarse ones, over the number of observed
// elements.
template <class At>
double mean_offset(int factor_x, int factor_y, const At& at) {
    const auto weight = [](int difference, int factor) {
        return static_cast<double>(factor - std::abs(difference)) / factor;
    };
    double sum = 0;
    for (int b = 1 - factor_y; b < factor_y; ++b)
        for (int a = 1 - factor_x; a < factor_x; ++a) sum += weight(a, factor_x) * weight(b, factor_y) * at(a, b);
    return sum;
}

std::span<const std::array<Axis, 2>> components(bool coupled) {
    using enum Axis;
    static constexpr std::array<std::array<Axis, 2>, 9> all = {
        {{x, x}, {y, y}, {z, z}, {x, y}, {y, x}, {x, z}, {y, z}, {z, x}, {z, y}}};
    return std::span(all).first(coupled ? 9 : 5);
}

}  // namespace

Coarsening::Coarsening(int nx, int ny)
    : nx_(nx),
      ny_(ny),
      factor_x_(factor(nx)),
      factor_y_(factor(ny)),
      coarse_nx_((nx + factor_x_ - 1) / factor_x_),
      coarse_ny_((ny + factor_y_ - 1) / factor_y_) {}

IcTable Coarsening::coarse(const IcTable& fine, bool coupled) const {
    IcTable result(coarse_nx_, coarse_ny_);
    for (const auto& [i, j] : components(coupled))
        for (int L = 0; L < coarse_ny_; ++L)
            for (int K = 0; K < coarse_nx_; ++K) {
                result(i, j, K, L) = mean_offset(factor_x_, factor_y_, [&](int a, int b) {
                    return fine.at(i, j, std::min(K * factor_x_ + a, fine.nx - 1),
                                   std::min(L * factor_y_ + b, fine.ny - 1));
                });
            }
    return result;
}

namespace {

/// Coarsens a table of offsets of both signs, for the components `pairs`.
template <class Table, class Pairs>
Table coarse_signed(const Table& fine, Table coarse, int factor_x, int factor_y, const Pairs& pairs) {
    const auto inside = [](int offset, int n) { return std::clamp(offset, 1 - n, n - 1); };
    for (const auto& [i, j] : pairs)
        for (int L = 1 - coarse.ny; L < coarse.ny; ++L)
            for (int K = 1 - coarse.nx; K < coarse.nx; ++K)
                coarse(i, j, K, L) = mean_offset(factor_x, factor_y, [&](int a, int b) {
                    return fine(i, j, inside(K * factor_x + a, fine.nx), inside(L * factor_y + b, fine.ny));
                });
    return coarse;
}

}  // namespace

ShiftedTable Coarsening::coarse(const ShiftedTable& fine) const {
    using enum Axis;
    constexpr std::array<std::array<Axis, 2>, 6> pairs = {{{x, x}, {x, y}, {x, z}, {y, x}, {y, y}, {y, z}}};
    return coarse_signed(fine, ShiftedTable(coarse_nx_, coarse_ny_), factor_x_, factor_y_, pairs);
}

RollingTable Coarsening::coarse(const RollingTable& fine, bool coupled) const {
    return coarse_signed(fine, RollingTable(coarse_nx_, coarse_ny_), factor_x_, factor_y_, components(coupled));
}

void Coarsening::average(std::span<const double> fine, std::span<double> coarse) const {
    std::vector<int> count(coarse.size());
    std::fill(coarse.begin(), coarse.end(), 0.0);
    for (int iy = 0; iy < ny_; ++iy)
        for (int ix = 0; ix < nx_; ++ix) {
            const int to = iy / factor_y_ * coarse_nx_ + ix / factor_x_;
            coarse[static_cast<std::size_t>(to)] += fine[static_cast<std::size_t>(iy * nx_ + ix)];
            ++count[static_cast<std::size_t>(to)];
        }
    for (std::size_t i = 0; i < coarse.size(); ++i) coarse[i] /= count[i];
}

void Coarsening::copy(std::span<const double> coarse, std::span<double> fine) const {
    for (int iy = 0; iy < ny_; ++iy)
        for (int ix = 0; ix < nx_; ++ix)
            fine[static_cast<std::size_t>(iy * nx_ + ix)] =
                coarse[static_cast<std::size_t>(iy / factor_y_ * coarse_nx_ + ix / factor_x_)];
}

void Coarsening::interpolate(std::span<const double> coarse, std::span<double> fine) const {
    for (int iy = 0; iy < ny_; ++iy) {
        const Between along_y = between(iy, factor_y_, coarse_ny_);
        const double* lower = coarse.data() + along_y.first * static_cast<std::size_t>(coarse_nx_);
        const double* upper = coarse.data() + along_y.second * static_cast<std::size_t>(coarse_nx_);
        double* row = fine.data() + static_cast<std::ptrdiff_t>(iy) * nx_;
        for (int ix = 0; ix < nx_; ++ix) {
            const Between along_x = between(ix, factor_x_, coarse_nx_);
            const auto blend = [&](const double* values) {
                return values[along_x.first] + along_x.weight * (values[along_x.second] - values[along_x.first]);
            };
            row[ix] = blend(lower) + along_y.weight * (blend(upper) - blend(lower));
        }
    }
}

}  // namespace contactd
