#include "geometry/profile/profile_fit.hpp"

#include <span>

#include "contactd/error.hpp"
#include "geometry/profile/curve_cotangent.hpp"
#include "geometry/profile/smoothing.hpp"
#include "geometry/profile/smoothing_gradient.hpp"

namespace contactd::geometry {

Fit fit_of(const ProfilePoints& points) {
    return {.length = points.smoothing_length};
}

Fit fit_of(const ProfileFile& file) {
    return {file.smoothing_length, file.smoothing_lambda, file.smoothing_order, file.kinks};
}

std::vector<double> factors_between(std::size_t count, std::size_t from, std::size_t to, const Fit& fit) {
    std::vector<double> factors;
    for (std::size_t i = from; i <= to; ++i) {
        const bool end = i == 0 || i + 1 == count, kink = !end && (i == from || i == to);
        factors.push_back((end && !(fit.lambda > 0) ? 20 : 1) * (kink && fit.order == 2 ? 100 : 1));
    }
    return factors;
}

std::vector<double> weights_between(const std::vector<double>& s, std::size_t from, std::size_t to, const Fit& fit) {
    std::vector<double> weights = factors_between(s.size(), from, to, fit);
    if (fit.lambda > 0) return weights;
    for (std::size_t i = from; i <= to; ++i) {
        const double before = i > from ? s[i] - s[i - 1] : 0, behind = i < to ? s[i + 1] - s[i] : 0;
        weights[i - from] *= (before + behind) / 2;
    }
    return weights;
}

Points smoothed(const ProfileCurve& rough, const Fit& fit) {
    const Points& points = rough.points();
    const auto& s = rough.knots();
    const double lambda = fit.lambda > 0 ? fit.lambda : lambda_of(fit.length);
    Points smooth(points.size());
    std::size_t from = 0;
    for (std::size_t part = 0; part <= rough.kinks().size(); ++part) {
        const std::size_t to = part < rough.kinks().size() ? rough.kinks()[part] : points.size() - 1;
        const auto weights = weights_between(s, from, to, fit);
        for (double ProfilePoint::* coordinate : {&ProfilePoint::y, &ProfilePoint::z}) {
            std::vector<double> values;
            for (std::size_t i = from; i <= to; ++i) values.push_back(points[i].*coordinate);
            const std::span<const double> knots(s.data() + from, values.size());
            const auto found = fit.order == 2 ? smoothed(knots, values, weights, lambda)
                                              : smoothed_by_third(knots, values, weights, fit.length);
            for (std::size_t i = from; i <= to; ++i) {
                const bool shared = (i == from && from > 0) || (i == to && to + 1 < points.size());
                smooth[i].*coordinate += (shared ? 0.5 : 1) * found[i - from];
            }
        }
        from = to;
    }
    return smooth;
}

Points by_rough_points(const ProfileCurve& rough, const Fit& fit, const Points& by_smoothed) {
    if (fit.order != 2)
        throw InvalidArgument("profile.smoothing_order", "is 3, for which there are no gradients by points; use 2");
    const Points& points = rough.points();
    const auto& s = rough.knots();
    const double lambda = fit.lambda > 0 ? fit.lambda : lambda_of(fit.length);
    Points by_points(points.size());
    std::vector<double> by_width(points.size() - 1, 0.0);
    for (std::size_t part = 0, from = 0; part <= rough.kinks().size(); ++part) {
        const std::size_t to = part < rough.kinks().size() ? rough.kinks()[part] : points.size() - 1;
        const auto weights = weights_between(s, from, to, fit), factors = factors_between(s.size(), from, to, fit);
        for (double ProfilePoint::* coordinate : {&ProfilePoint::y, &ProfilePoint::z}) {
            std::vector<double> values, by_values;
            for (std::size_t i = from; i <= to; ++i) {
                const bool shared = (i == from && from > 0) || (i == to && to + 1 < points.size());
                values.push_back(points[i].*coordinate);
                by_values.push_back((shared ? 0.5 : 1) * by_smoothed[i].*coordinate);
            }
            const SmoothingGradient by =
                smoothing_gradient({s.data() + from, values.size()}, values, weights, lambda, by_values);
            for (std::size_t i = from; i <= to; ++i) by_points[i].*coordinate += by.values[i - from];
            for (std::size_t i = from; i < to; ++i) {
                by_width[i] += by.widths[i - from];
                if (fit.lambda > 0) continue;
                for (const std::size_t end : {i - from, i - from + 1})
                    by_width[i] += by.weights[end] * factors[end] / 2;
            }
        }
        from = to;
    }
    add_by_widths(points, by_width, by_points);
    return by_points;
}

}  // namespace contactd::geometry
