#include "geometry/profile/curve_cotangent.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace contactd::geometry {
namespace {

/// Solves the equations of natural_curving, which are symmetric, for another right-hand side.
std::vector<double> solved(const std::vector<double>& knots, std::size_t from, std::size_t to,
                           const std::vector<double>& right) {
    const std::size_t n = to - from + 1;
    std::vector<double> x(n, 0.0), upper(n, 0.0);
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const double before = knots[from + i] - knots[from + i - 1], behind = knots[from + i + 1] - knots[from + i];
        const double pivot = 2 * (before + behind) - before * upper[i - 1];
        upper[i] = behind / pivot;
        x[i] = (right[from + i] - before * x[i - 1]) / pivot;
    }
    for (std::size_t i = n - 1; i-- > 1;) x[i] -= upper[i] * x[i + 1];
    return x;
}

}  // namespace

CurveCotangent::CurveCotangent(ProfileCurve curve) : curve_(std::move(curve)) {
    const std::size_t count = curve_.points().size();
    for (Sums* sums : {&y_, &z_}) {
        sums->values.assign(count, 0.0);
        sums->curving.assign(2 * count, 0.0);  // at both ends of each interval
    }
    by_knots_.assign(count, 0.0);
    by_width_.assign(count - 1, 0.0);
    const std::vector<double>& knots = curve_.knots();
    for (std::size_t i = 0; i + 1 < count; ++i) {
        const double middle = 0.5 * (knots[i] + knots[i + 1]);
        const ProfilePoint begin = curve_.curving(knots[i]), half = curve_.curving(middle);
        curving_.push_back(begin);
        curving_.push_back({2 * half.y - begin.y, 2 * half.z - begin.z});
    }
}

void CurveCotangent::add(double s, double ProfilePoint::* coordinate, Sums& sums, double by_value, double by_slope) {
    if (by_value == 0 && by_slope == 0) return;
    const std::vector<double>& knots = curve_.knots();
    const auto above = std::upper_bound(knots.begin(), knots.end(), s) - knots.begin();
    const auto i = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(above - 1, 0, std::ssize(knots) - 2));
    const double h = knots[i + 1] - knots[i], t = std::clamp(s - knots[i], 0.0, h);
    const double rise = curve_.points()[i + 1].*coordinate - curve_.points()[i].*coordinate;
    const double begin = curving_[2 * i].*coordinate, end = curving_[2 * i + 1].*coordinate;
    const auto place = curve_.place(knots[i] + t);
    sums.values[i + 1] += by_value * t / h + by_slope / h;
    sums.values[i] += by_value * (1 - t / h) - by_slope / h;
    sums.curving[2 * i] +=
        by_value * (-t * h / 3 + t * t / 2 - t * t * t / (6 * h)) + by_slope * (-h / 3 + t - t * t / (2 * h));
    sums.curving[2 * i + 1] += by_value * (-t * h / 6 + t * t * t / (6 * h)) + by_slope * (-h / 6 + t * t / (2 * h));
    const double mean = rise / (h * h) + (2 * begin + end) / 6, bend = (end - begin) / (h * h);
    by_width_[i] += -by_value * (t * mean + t * t * t / 6 * bend) - by_slope * (mean + t * t / 2 * bend);
    by_knots_[i] -= by_value * place.slope.*coordinate + by_slope * place.curving.*coordinate;
}

void CurveCotangent::add(double s, const ProfilePoint& by_point, const ProfilePoint& by_slope) {
    add(s, &ProfilePoint::y, y_, by_point.y, by_slope.y);
    add(s, &ProfilePoint::z, z_, by_point.z, by_slope.z);
}

// The displacement is y' dz - z' dy, and its derivative y'' dz + y' dz' - z'' dy - z' dy'.
void CurveCotangent::add_normal(double s, double by_displacement, double by_slope) {
    const auto [at, slope, curving] = curve_.place(s);
    add(s, {-slope.z * by_displacement - curving.z * by_slope, slope.y * by_displacement + curving.y * by_slope},
        {-slope.z * by_slope, slope.y * by_slope});
}

std::vector<ProfilePoint> CurveCotangent::by_points() const {
    const std::vector<ProfilePoint>& points = curve_.points();
    const std::vector<double>& knots = curve_.knots();
    std::vector<ProfilePoint> result(points.size());
    std::vector<double> by_width = by_width_;
    for (const auto& [coordinate, sums] : {std::pair(&ProfilePoint::y, &y_), std::pair(&ProfilePoint::z, &z_)}) {
        for (std::size_t i = 0; i < points.size(); ++i) result[i].*coordinate += sums->values[i];
        std::vector<double> right(points.size(), 0.0);
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            right[i] += sums->curving[2 * i];
            right[i + 1] += sums->curving[2 * i + 1];
        }
        for (std::size_t part = 0, from = 0; part <= curve_.kinks().size(); ++part) {
            const std::size_t to = part < curve_.kinks().size() ? curve_.kinks()[part] : points.size() - 1;
            const std::vector<double> x = solved(knots, from, to, right);
            for (std::size_t i = from; i < to; ++i) {
                const double h = knots[i + 1] - knots[i], rise = points[i + 1].*coordinate - points[i].*coordinate;
                const double left = x[i - from], next = x[i - from + 1];
                const double begin = curving_[2 * i].*coordinate, end = curving_[2 * i + 1].*coordinate;
                result[i + 1].*coordinate += 6 * (left - next) / h;
                result[i].*coordinate -= 6 * (left - next) / h;
                by_width[i] += 6 * (next - left) * rise / (h * h) - left * (2 * begin + end) - next * (begin + 2 * end);
            }
            from = to;
        }
    }
    double beyond = 0;  // Each knot moves with all widths before it.
    for (std::size_t i = by_width.size(); i-- > 0;) {
        beyond += by_knots_[i + 1];
        by_width[i] += beyond;
    }
    add_by_widths(points, by_width, result);
    return result;
}

void add_by_widths(const std::vector<ProfilePoint>& points, const std::vector<double>& by_width,
                   std::vector<ProfilePoint>& by_points) {
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const double y = points[i + 1].y - points[i].y, z = points[i + 1].z - points[i].z;
        const double over = by_width[i] / std::hypot(y, z);
        by_points[i + 1].y += over * y;
        by_points[i + 1].z += over * z;
        by_points[i].y -= over * y;
        by_points[i].z -= over * z;
    }
}

}  // namespace contactd::geometry
