// Integrates functions that are singular as 1/rho at the origin over rectangles by adaptive quadrature, for tests.
#pragma once

#include <array>
#include <cmath>
#include <functional>

namespace contactd::test {

using Function = std::function<double(double, double)>;

inline double gauss(const Function& f, double x0, double x1, double y0, double y1) {
    constexpr std::array<double, 4> node = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                            0.9602898564975363};
    constexpr std::array<double, 4> weight = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                              0.1012285362903763};
    const double cx = 0.5 * (x0 + x1), rx = 0.5 * (x1 - x0), cy = 0.5 * (y0 + y1), ry = 0.5 * (y1 - y0);
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            for (const int sx : {-1, 1})
                for (const int sy : {-1, 1})
                    sum += weight[i] * weight[j] * f(cx + sx * rx * node[i], cy + sy * ry * node[j]);
    return sum * rx * ry;
}

inline double adaptive(const Function& f, double x0, double x1, double y0, double y1, double tolerance) {
    const double cx = 0.5 * (x0 + x1), cy = 0.5 * (y0 + y1);
    const double whole = gauss(f, x0, x1, y0, y1);
    const double parts =
        gauss(f, x0, cx, y0, cy) + gauss(f, cx, x1, y0, cy) + gauss(f, x0, cx, cy, y1) + gauss(f, cx, x1, cy, y1);
    if (std::abs(whole - parts) <= tolerance) return parts;
    return adaptive(f, x0, cx, y0, cy, tolerance / 4) + adaptive(f, cx, x1, y0, cy, tolerance / 4) +
           adaptive(f, x0, cx, cy, y1, tolerance / 4) + adaptive(f, cx, x1, cy, y1, tolerance / 4);
}

/// Integrates over the rectangle between the origin and (a, b); Duffy's transformation of its two triangles removes the
/// singularity.
inline double from_origin(const Function& f, double a, double b, double tolerance) {
    const auto lower = [&](double u, double t) { return f(a * u, b * u * t) * u; };
    const auto upper = [&](double u, double t) { return f(a * u * t, b * u) * u; };
    const double area = std::abs(a * b);
    return area * (adaptive(lower, 0, 1, 0, 1, tolerance / area) + adaptive(upper, 0, 1, 0, 1, tolerance / area));
}

/// Integrates over any rectangle, split along the axes, so that the origin is a corner of the parts that touch it.
inline double integrate(const Function& f, double x0, double x1, double y0, double y1, double tolerance) {
    if (x0 < 0 && x1 > 0) return integrate(f, x0, 0, y0, y1, tolerance) + integrate(f, 0, x1, y0, y1, tolerance);
    if (y0 < 0 && y1 > 0) return integrate(f, x0, x1, y0, 0, tolerance) + integrate(f, x0, x1, 0, y1, tolerance);
    const bool at_origin = x0 * x1 == 0 && y0 * y1 == 0;
    if (at_origin) return from_origin(f, x0 == 0 ? x1 : x0, y0 == 0 ? y1 : y0, tolerance);
    return adaptive(f, x0, x1, y0, y1, tolerance);
}

}  // namespace contactd::test
