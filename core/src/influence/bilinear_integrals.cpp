// The hat function is 1/h times the box convolved with the box, so an integral over it along one axis is 1/h times the
// second central difference, step h, of the kernel's second antiderivative. Along each axis either that difference is
// used or, where the kernel is smooth over the hat function and the difference would lose digits, Gauss's rule for its
// weight.
#include <algorithm>
#include <array>
#include <numbers>

#include "gauss_rules.hpp"
#include "kernel_integrals.hpp"

namespace contactd {
namespace {

struct Stencil {
    int offset;
    double weight;
};
constexpr std::array<Stencil, 3> second_difference = {{{-1, 1}, {0, -2}, {1, 1}}};

// Returns how smooth the integrand is over the interval `at` +- `half` if it is singular at the complex points +-i
// `beside`: E = (sum of the distances to both ends)/(2 half). An n-point Gauss rule has an error of about (E + sqrt(E^2
// - 1))^(-2n) (Trefethen, Approximation Theory and Approximation Practice, theorem 19.3).
double smoothness(double at, double beside, double half) {
    return (std::hypot(at - half, beside) + std::hypot(at + half, beside)) / (2 * half);
}

constexpr double smooth_enough = 3;  // for ten points; differences lose E^2 or, along both axes, E^4 of the digits

void add(KernelIntegrals& sum, double weight, const KernelIntegrals& term) {
    sum.xx += weight * term.xx;
    sum.yy += weight * term.yy;
    sum.xy += weight * term.xy;
    sum.x += weight * term.x;
    sum.y += weight * term.y;
}

KernelIntegrals axes_exchanged(const KernelIntegrals& k) {
    return {k.yy, k.xx, k.xy, k.y, k.x};
}

// y asinh(x/|y|) equals y ln(x + rho) up to y ln|y|, and loses no digits for x < 0.
double y_log(double x, double y) {
    if (std::abs(y) <= 1e-200 * std::abs(x)) return 0;
    return y * std::asinh(x / std::abs(y));
}

// Returns antiderivatives, twice in x and twice in y, of the kernels; terms that are of degree one in x or in y are
// omitted.
KernelIntegrals fourfold_antiderivatives(double x, double y) {
    const double rho = std::hypot(x, y);
    if (rho == 0) return {};
    const double xx = x * x, yy = y * y, ln_rho = std::log(rho);
    const double of_x = y_log(x, y), of_y = y_log(y, x);
    // Where a quotient is infinite, its angle is multiplied by zero.
    const double to_y = x == 0 ? 0 : std::atan(y / x), to_x = y == 0 ? 0 : std::atan(x / y);
    KernelIntegrals k;
    k.xx = 0.5 * x * y * of_x + rho * (xx - 2 * yy) / 6;
    k.yy = 0.5 * x * y * of_y + rho * (yy - 2 * xx) / 6;
    k.xy = -x * y * rho / 3 - (xx * of_y + yy * of_x) / 6;
    k.x = x * (3 * yy - xx) * ln_rho / 6 + 0.5 * xx * y * to_y + y * yy * to_x / 6;
    k.y = y * (3 * xx - yy) * ln_rho / 6 + 0.5 * x * yy * to_x + x * xx * to_y / 6;
    return k;
}

// Returns antiderivatives, twice in x, of the kernels, for x >= 0 or y > 0; terms linear in x are omitted.
KernelIntegrals twofold_antiderivatives(double x, double y) {
    const double rho = std::hypot(x, y), ln_rho = std::log(rho), angle = std::atan2(y, x);
    const double ln_sum = x >= 0 ? std::log(x + rho) : std::log(y * y / (rho - x));  // ln(x + rho)
    return {x * ln_sum - 2 * rho, rho, -y * ln_sum, x * ln_rho - y * angle, -x * angle - y * ln_rho};
}

// Uses differences along x and Gauss's rule along y.
template <class Rule>
KernelIntegrals by_both(const Rule& rule, double x, double y, double dx, double dy) {
    KernelIntegrals sum;
    for (const auto& along_y : rule)
        for (const auto& along_x : second_difference)
            add(sum, along_x.weight * along_y.weight * dy / dx,
                twofold_antiderivatives(x + along_x.offset * dx, y + along_y.node * dy));
    return sum;
}

// Holds means, weighted with the hat function around y, of the functions of Y that twofold_over_hat() must not sum at
// Gauss points.
struct NonSmoothMeans {
    double log = 0;    // ln|Y|
    double y_log = 0;  // Y ln|Y|
    double abs = 0;    // |Y|
    double sign = 0;   // of Y
};

NonSmoothMeans non_smooth_means(double y, double dy) {
    NonSmoothMeans mean;
    for (const auto& along_y : second_difference) {
        const double Y = y + along_y.offset * dy, weight = along_y.weight / (dy * dy);
        const double ln = Y == 0 ? 0 : std::log(std::abs(Y));
        mean.log += weight * Y * Y * (0.5 * ln - 0.75);
        mean.y_log += weight * Y * Y * Y * (ln / 6 - 5.0 / 36);
        mean.abs += weight * Y * Y * std::abs(Y) / 6;
        mean.sign += weight * Y * std::abs(Y) / 2;
    }
    return mean;
}

// Returns means, weighted with the hat function around y, of the kernels' second antiderivatives in x, for a corner
// where smooth_enough. Other corners use fourfold_antiderivatives(), so terms linear in x matter: 5/6 and |Y| are those
// that it implies.
KernelIntegrals twofold_over_hat(double x, double y, double dy, const NonSmoothMeans& rest) {
    const double a = std::abs(x), sign = x < 0 ? -1 : 1, quarter_turn = std::numbers::pi / 2;
    KernelIntegrals mean{-a * rest.log, 0, sign * rest.y_log, sign * quarter_turn * rest.abs,
                         a * quarter_turn * rest.sign};
    for (const auto& along_y : hat10) {
        const double Y = y + along_y.node * dy, rho = std::hypot(x, Y);
        const double ln_sum = std::log(a + rho), ln_rho = std::log(rho) + 5.0 / 6, angle = std::atan(Y / x);
        add(mean, along_y.weight,
            {a * ln_sum - 2 * rho, rho, -sign * Y * ln_sum, x * ln_rho - Y * angle, -x * angle - Y * ln_rho});
    }
    return mean;
}

// Uses differences along x, dx >= dy, and along y as well, unless the corner is so far from x = 0 that this would lose
// digits: (x/dy)^2, a million for the longest elements.
KernelIntegrals by_differences(double x, double y, double dx, double dy) {
    KernelIntegrals sum;
    const NonSmoothMeans rest = non_smooth_means(y, dy);
    for (const auto& along_x : second_difference) {
        const double X = x + along_x.offset * dx;
        if (smoothness(y, X, dy) > smooth_enough) {
            add(sum, along_x.weight * dy / dx, twofold_over_hat(X, y, dy, rest));
            continue;
        }
        for (const auto& along_y : second_difference)
            add(sum, along_x.weight * along_y.weight / (dx * dy), fourfold_antiderivatives(X, y + along_y.offset * dy));
    }
    return sum;
}

// Calls with the rule whose error is below rounding errors.
template <class Call>
KernelIntegrals with_rule(double E, const Call& call) {
    return E > 150 ? call(hat3) : E > 16 ? call(hat5) : call(hat10);
}

KernelIntegrals unit_force(double x, double y, double dx, double dy) {
    // The integrand along one axis is singular where the other axis meets the point, at the nearest point of the load.
    const double along_x = smoothness(x, std::max(y - dy, 0.0), dx);
    const double along_y = smoothness(y, std::max(x - dx, 0.0), dy);
    const bool smooth_x = along_x > smooth_enough, smooth_y = along_y > smooth_enough;
    if (smooth_x && smooth_y)
        return with_rule(std::min(along_x, along_y),
                         [&](const auto& rule) { return gauss_mean(rule, rule, x, y, dx, dy); });
    if (smooth_y) return with_rule(along_y, [&](const auto& rule) { return by_both(rule, x, y, dx, dy); });
    if (smooth_x)
        return axes_exchanged(with_rule(along_x, [&](const auto& rule) { return by_both(rule, y, x, dy, dx); }));
    return dx >= dy ? by_differences(x, y, dx, dy) : axes_exchanged(by_differences(y, x, dy, dx));
}

}  // namespace

KernelIntegrals bilinear_load_integrals(double x, double y, double dx, double dy) {
    return by_symmetry(unit_force, x, y, dx, dy);
}

}  // namespace contactd
