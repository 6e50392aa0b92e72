#include "contactd/ic_family.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <span>
#include <string>

#include "contactd/error.hpp"
#include "contactd/half_space.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

void check(const std::vector<IcTable>& family) {
    if (family.size() < 4 || family.size() % 2 != 0)
        throw InvalidArgument("family", "contains " + std::to_string(family.size()) +
                                            " tables; it must contain at least two for each of its halves");
    for (const IcTable& table : family)
        if (table.nx != family[0].nx || table.ny != family[0].ny)
            throw InvalidArgument("family", "contains tables of different extents; all must have the same extent");
}

void check_nu(double nu) {
    if (!(nu >= 0 && nu <= largest_family_nu))
        throw InvalidArgument("material.nu", "is " + number_text(nu) + "; a family of tables covers 0 to " +
                                                 number_text(largest_family_nu));
}

struct Half {
    double from, to;
};

Half half_of(bool upper) {
    return upper ? Half{family_break, largest_family_nu} : Half{0, family_break};
}

std::vector<double> half_points(const Half& half, int n) {
    std::vector<double> points(static_cast<std::size_t>(n));
    for (int j = 0; j < n; ++j) {
        const double sine = std::sin(std::numbers::pi / 2 * (static_cast<double>(j) / (n - 1)));
        // This is (1 - cos)/2 without its cancellation.
        points[static_cast<std::size_t>(j)] = half.from + (half.to - half.from) * sine * sine;
    }
    points.back() = half.to;
    return points;
}

using Tables = std::span<const IcTable>;

Tables tables_of(const std::vector<IcTable>& family, bool upper) {
    const std::size_t n = family.size() / 2;
    return Tables(family).subspan(upper ? n : 0, n);
}

// Returns weights of the values at half_points(half, n) in the polynomial's value at nu, by the barycentric formula
// (Trefethen, theorem 5.2).
std::vector<double> interpolation_weights(const Half& half, std::size_t n, double nu) {
    const std::vector<double> points = half_points(half, static_cast<int>(n));
    std::vector<double> weights(points.size());
    double sum = 0;
    for (std::size_t j = 0; j < points.size(); ++j) {
        if (nu == points[j]) {
            std::fill(weights.begin(), weights.end(), 0);
            weights[j] = 1;
            return weights;
        }
        const bool end = j == 0 || j + 1 == points.size();
        weights[j] = (j % 2 == 0 ? 1 : -1) * (end ? 0.5 : 1) / (nu - points[j]);
        sum += weights[j];
    }
    for (double& weight : weights) weight /= sum;
    return weights;
}

// Returns weights of the values at half_points(half, n) in the polynomial's Chebyshev coefficient of degree k
// (Trefethen, chapter 3).
std::vector<double> coefficient_weights(int n, int k) {
    const int degree = n - 1;
    std::vector<double> weights(static_cast<std::size_t>(n));
    for (int j = 0; j < n; ++j) {
        const bool end = j == 0 || j == degree;
        // Points ascend: point j is number degree - j of the cosines.
        const double angle = std::numbers::pi * k * (degree - j) / degree;
        weights[static_cast<std::size_t>(j)] = std::cos(angle) * (end ? 1 : 2) / degree;
    }
    if (k == 0 || k == degree)
        for (double& weight : weights) weight /= 2;
    return weights;
}

// Sums the tables times their weights, piece by piece, so that the sum stays in the nearest cache.
IcTable weighted_sum(Tables family, const std::vector<double>& weights) {
    IcTable result(family[0].nx, family[0].ny);
    constexpr std::size_t piece = 2048;
    for (std::size_t first = 0; first < result.values.size(); first += piece) {
        const std::size_t n = std::min(piece, result.values.size() - first);
        double* sum = result.values.data() + first;
        for (std::size_t t = 0; t < family.size(); ++t) {
            const double weight = weights[t];
            if (weight == 0) continue;
            const double* values = family[t].values.data() + first;
            for (std::size_t i = 0; i < n; ++i) sum[i] += weight * values[i];
        }
    }
    return result;
}

// Returns the largest of the coefficients in the measures of a table's errors.
double largest(const IcSpec& spec, Tables family, const IcTable& coefficient) {
    double result = 0;
    IcSpec stiffest = spec;  // The half-space's coefficients decrease with nu.
    stiffest.material = {1, largest_family_nu};
    std::vector<IcTable> units;
    for (const IcTable& table : family) units.push_back(error_unit(stiffest, table));
    const double unit = 2 * std::numbers::pi / (spec.dx * spec.dy);
    for (const Axis i : {Axis::x, Axis::y, Axis::z})
        for (const Axis j : {Axis::x, Axis::y, Axis::z})
            for (int l = 0; l < coefficient.ny; ++l)
                for (int k = 0; k < coefficient.nx; ++k) {
                    const std::size_t at = coefficient.index(i, j, k, l);
                    const double value = std::abs(coefficient.values[at]);
                    if (value == 0) continue;
                    if (i != j) {
                        result = std::max(result, value * unit * std::hypot(k * spec.dx, l * spec.dy));
                        continue;
                    }
                    double smallest = units[0].values[at];
                    for (const IcTable& unit_of_one : units) smallest = std::min(smallest, unit_of_one.values[at]);
                    result = std::max(result, value / smallest);
                }
    return result;
}

// The coefficients a_k of a function that is analytic around the interval decay as q^k, and the error of the
// interpolant of degree N is at most 2 (|a_N+1| + |a_N+2| + ...), that is, 2 |a_N| q/(1 - q). The coefficients of the
// interpolant include those beyond N folded back, c_N = a_N and c_N-1 = a_N-1 + a_N+1, so their ratio is q/(1 + q^2)
// (Trefethen, chapter 4). q is at least 1/2, because a small last coefficient may be chance, and at most 4/5: locking
// finite elements have a pole at nu = 1/2, q = 0.75.
double decay(double last, double before) {
    constexpr double fastest = 0.5, slowest = 0.8;
    const double ratio = last / before;
    if (!(ratio > fastest / (1 + fastest * fastest))) return fastest;
    if (ratio >= slowest / (1 + slowest * slowest)) return slowest;
    return (1 - std::sqrt(1 - 4 * ratio * ratio)) / (2 * ratio);
}

}  // namespace

std::vector<double> family_points(int n) {
    if (n < 2)
        throw InvalidArgument("n", "is " + std::to_string(n) + "; each half of a family needs at least two points");
    std::vector<double> points = half_points(half_of(false), n);
    const std::vector<double> upper = half_points(half_of(true), n);
    points.insert(points.end(), upper.begin(), upper.end());
    return points;
}

IcTable interpolated(const std::vector<IcTable>& family, double given_nu) {
    check(family);
    check_nu(given_nu);
    const bool upper = rounded(given_nu) > family_break;
    const double nu = upper ? given_nu : std::min(given_nu, family_break);
    const Tables tables = tables_of(family, upper);
    return weighted_sum(tables, interpolation_weights(half_of(upper), tables.size(), nu));
}

double interpolation_error(const IcSpec& spec, const std::vector<IcTable>& family) {
    return std::ranges::max(interpolation_errors(spec, family));
}

std::array<double, 2> interpolation_errors(const IcSpec& spec, const std::vector<IcTable>& family) {
    check(family);
    std::array<double, 2> errors{};
    for (const bool upper : {false, true}) {
        const Tables tables = tables_of(family, upper);
        const auto n = static_cast<int>(tables.size()), degree = n - 1;
        const double last = largest(spec, tables, weighted_sum(tables, coefficient_weights(n, degree)));
        const double before = largest(spec, tables, weighted_sum(tables, coefficient_weights(n, degree - 1)));
        if (before == 0 && last == 0) continue;
        const double q = decay(last, before);
        errors[upper ? 1 : 0] = 2 * std::max(last, before / 4) * q / (1 - q);
    }
    return errors;
}

}  // namespace contactd
