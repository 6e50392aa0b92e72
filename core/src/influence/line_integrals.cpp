#include <algorithm>
#include <numbers>

#include "kernel_integrals.hpp"

namespace contactd {
namespace {

// Differences of antiderivatives lose digits with the distance. From this distance on (in elements), a series does not.
constexpr double far = 8;
constexpr int terms = 10;

double times_log(double factor, double x) {
    return x != 0 ? factor * std::log(std::abs(x)) : 0;
}

// Returns the mean of ln|1 - s/x| over the load: -sum of <s^2n>/(2n x^2n), with `moment(2n)` = <s^2n> over (dx/2)^2n or
// dx^2n.
template <class Moment>
double far_log(double ratio, const Moment& moment) {
    double sum = 0, power = 1;
    for (int n = 1; n <= terms; ++n) {
        power *= ratio * ratio;
        sum -= power * moment(2 * n) / (2 * n);
    }
    return sum;
}

// Returns the integrals from the means over the load, of force dx.
KernelIntegrals from_means(double log, double sign, double dx) {
    KernelIntegrals result;
    result.yy = -2 * dx * log;
    result.x = std::numbers::pi * dx * sign;
    return result;
}

double sign_of(double x) {
    return x < 0 ? -1 : x > 0 ? 1 : 0;
}

}  // namespace

KernelIntegrals constant_line_integrals(double x, double dx, double datum) {
    const double X = std::abs(x) / dx;
    const double log = X > far ? std::log(X) + far_log(0.5 / X, [](int m) { return 1.0 / (m + 1); })
                               : times_log(X + 0.5, X + 0.5) - times_log(X - 0.5, X - 0.5) - 1;
    return from_means(log + std::log(dx / datum), sign_of(x) * std::min(2 * X, 1.0), dx);
}

KernelIntegrals bilinear_line_integrals(double x, double dx, double datum) {
    const double X = std::abs(x) / dx;
    const auto antiderivative = [](double t) { return times_log(0.5 * t * t, t); };
    const double log = X > far ? std::log(X) + far_log(1 / X, [](int m) { return 2.0 / ((m + 1) * (m + 2)); })
                               : antiderivative(X + 1) - 2 * antiderivative(X) + antiderivative(X - 1) - 1.5;
    const double rest = std::max(1 - X, 0.0);
    return from_means(log + std::log(dx / datum), sign_of(x) * (1 - rest * rest), dx);
}

}  // namespace contactd
