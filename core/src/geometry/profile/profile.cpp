#include "contactd/profile.hpp"

#include <cmath>
#include <mutex>
#include <string>

#include "contactd/error.hpp"
#include "geometry/profile/interval_finder.hpp"
#include "geometry/profile/natural_spline.hpp"
#include "geometry/profile/spline_piece.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

using geometry::Cubic;
using geometry::IntervalFinder;
using geometry::SplinePiece;

constexpr double largest_coordinate = 1e5, narrowest = 1e-6;  // mm

void check(const std::vector<ProfilePoint>& points, const std::vector<std::size_t>& kinks) {
    if (points.size() < 2)
        throw InvalidArgument("points",
                              "has " + std::to_string(points.size()) + " entries; a profile needs at least two points");
    // Rails that vary along the track make many profiles, so only the numbers are checked if all are valid.
    const auto field = [](std::size_t i) { return "points[" + std::to_string(i) + "]"; };
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto& [y, z] = points[i];
        for (const double coordinate : {y, z})
            if (!(std::abs(coordinate) <= largest_coordinate))
                throw InvalidArgument(field(i), "has the coordinate " + number_text(coordinate) +
                                                    "; it must be finite and at most 1e5 mm");
        if (i == 0) continue;
        constexpr double nearest = 1e-9;  // mm
        const double aside = y - points[i - 1].y, up = z - points[i - 1].z;
        if (aside * aside + up * up < nearest * nearest)
            throw InvalidArgument(field(i), "equals the previous point, (" + number_text(y) + ", " + number_text(z) +
                                                "); neighbours must differ: omit one of them");
    }
    for (std::size_t i = 0; i < kinks.size(); ++i) {
        const std::string kink = "kinks[" + std::to_string(i) + "]", is = "is " + std::to_string(kinks[i]);
        if (kinks[i] < 1 || kinks[i] + 1 >= points.size())
            throw InvalidArgument(kink,
                                  is + "; it must be the index of a point that has neighbours on both sides, 1 to " +
                                      std::to_string(points.size() - 2));
        if (i > 0 && kinks[i] <= kinks[i - 1])
            throw InvalidArgument(kink, is + " after " + std::to_string(kinks[i - 1]) + "; kinks must ascend");
    }
}

std::vector<double> chord_lengths(const std::vector<ProfilePoint>& points) {
    std::vector<double> s{0};
    for (std::size_t i = 1; i < points.size(); ++i)
        s.push_back(s.back() + std::hypot(points[i].y - points[i - 1].y, points[i].z - points[i - 1].z));
    return s;
}

}  // namespace

struct ProfileCurve::Tables {
    std::vector<ProfilePoint> points;
    std::vector<std::size_t> kinks;
    IntervalFinder by_s;
    std::vector<SplinePiece> pieces;
    double y_sense = 0;   // 1 if y of the points ascends, -1 if it descends, otherwise 0
    IntervalFinder by_y;  // for y times its sense

    Tables(std::vector<ProfilePoint>&& points_, std::vector<std::size_t>&& kinks_)
        : points(std::move(points_)), kinks(std::move(kinks_)), by_s(chord_lengths(points)) {
        fit();
        find_sense();
    }

    const std::vector<double>& knots() const { return by_s.values(); }
    double width(std::size_t interval) const { return knots()[interval + 1] - knots()[interval]; }

    void fit() {
        pieces.resize(points.size() - 1);
        std::size_t from = 0;
        for (std::size_t part = 0; part <= kinks.size(); ++part) {
            const std::size_t to = part < kinks.size() ? kinks[part] : points.size() - 1;
            fit(from, to, &ProfilePoint::y, &SplinePiece::y);
            fit(from, to, &ProfilePoint::z, &SplinePiece::z);
            from = to;
        }
    }

    void fit(std::size_t from, std::size_t to, double ProfilePoint::* coordinate, Cubic SplinePiece::* powers) {
        std::vector<double> values;
        for (std::size_t i = from; i <= to; ++i) values.push_back(points[i].*coordinate);
        const auto curving = geometry::natural_curving({knots().data() + from, values.size()}, values);
        for (std::size_t i = 0; i + 1 < values.size(); ++i) {
            const double h = width(from + i);
            pieces[from + i].*powers = {values[i],
                                        (values[i + 1] - values[i]) / h - h * (2 * curving[i] + curving[i + 1]) / 6,
                                        curving[i] / 2, (curving[i + 1] - curving[i]) / (6 * h)};
        }
    }

    /// Returns the lengths at the points. They are computed on first use, because sections of rails exist only for one
    /// step.
    const std::vector<double>& arc_lengths() const {
        std::call_once(measured_, [this] {
            arc_lengths_.push_back(0);
            for (std::size_t i = 0; i < pieces.size(); ++i)
                arc_lengths_.push_back(arc_lengths_.back() + pieces[i].length(width(i)));
        });
        return arc_lengths_;
    }

    void find_sense() {
        y_sense = points[1].y > points[0].y ? 1 : -1;
        std::vector<double> values;
        for (const ProfilePoint& point : points) {
            values.push_back(y_sense * point.y);
            if (values.size() > 1 && values.back() <= values[values.size() - 2]) {
                y_sense = 0;
                return;
            }
        }
        if (values.back() - values.front() < narrowest) y_sense = 0;  // The range is too small for buckets.
        if (y_sense != 0) by_y = IntervalFinder(std::move(values));
    }

    /// Returns the s in an interval at which y is reached; y lies between those of its points.
    double s_in(std::size_t interval, double y) const {
        const auto& powers = pieces[interval].y;
        const double h = width(interval), sense = points[interval + 1].y > points[interval].y ? 1 : -1;
        const double share = (y - points[interval].y) / (points[interval + 1].y - points[interval].y);
        return knots()[interval] + geometry::root(h, h * share, [&](double t) {
                   return std::pair(sense * (powers.value(t) - y), sense * powers.first(t));
               });
    }

    double search_y(double y) const {
        std::size_t nearest = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (points[i].y == y) return knots()[i];
            if (i > 0 && (points[i - 1].y < y) != (points[i].y < y)) return s_in(i - 1, y);
            if (std::abs(points[i].y - y) < std::abs(points[nearest].y - y)) nearest = i;
        }
        return knots()[nearest];
    }

   private:
    mutable std::once_flag measured_;
    mutable std::vector<double> arc_lengths_{};
};

ProfileCurve::ProfileCurve(std::vector<ProfilePoint> points, std::vector<std::size_t> kinks) {
    check(points, kinks);
    tables_ = std::make_shared<const Tables>(std::move(points), std::move(kinks));
}

double ProfileCurve::end() const {
    return tables_->knots().back();
}

ProfileCurve::Place ProfileCurve::place(double s) const {
    const double inside = s > 0 ? std::min(s, end()) : 0.0;  // If s is NaN, it is the first point's.
    const std::size_t interval = tables_->by_s(inside);
    const SplinePiece& piece = tables_->pieces[interval];
    const double t = inside - tables_->knots()[interval], beyond = s - inside;
    Place place{{piece.y.value(t), piece.z.value(t)},
                {piece.y.first(t), piece.z.first(t)},
                {piece.y.second(t), piece.z.second(t)}};
    if (beyond != 0) {
        place.at = {place.at.y + beyond * place.slope.y, place.at.z + beyond * place.slope.z};
        place.curving = {};
    }
    return place;
}

ProfilePoint ProfileCurve::at(double s) const {
    return place(s).at;
}

ProfilePoint ProfileCurve::slope(double s) const {
    return place(s).slope;
}

ProfilePoint ProfileCurve::curving(double s) const {
    return place(s).curving;
}

double ProfileCurve::angle(double s) const {
    const ProfilePoint along = slope(s);
    return std::atan2(along.z, along.y);
}

double ProfileCurve::curvature(double s) const {
    const Place here = place(s);
    const double speed = std::hypot(here.slope.y, here.slope.z);
    return (here.slope.y * here.curving.z - here.slope.z * here.curving.y) / (speed * speed * speed);
}

double ProfileCurve::arc_length(double s) const {
    const double inside = s > 0 ? std::min(s, end()) : 0.0;
    const std::size_t interval = tables_->by_s(inside);
    const ProfilePoint along = slope(inside);
    return tables_->arc_lengths()[interval] + tables_->pieces[interval].length(inside - tables_->knots()[interval]) +
           (s - inside) * std::hypot(along.y, along.z);
}

double ProfileCurve::s_at_arc_length(double arc_length) const {
    const auto& lengths = tables_->arc_lengths();
    if (!(arc_length > 0 && arc_length < lengths.back())) {
        const double nearest = arc_length > 0 ? end() : 0.0;
        const ProfilePoint along = slope(nearest);
        return nearest + (arc_length - (arc_length > 0 ? lengths.back() : 0.0)) / std::hypot(along.y, along.z);
    }
    const auto interval =
        static_cast<std::size_t>(std::upper_bound(lengths.begin(), lengths.end(), arc_length) - lengths.begin()) - 1;
    const SplinePiece& piece = tables_->pieces[interval];
    const double rest = arc_length - lengths[interval], h = tables_->width(interval);
    return tables_->knots()[interval] +
           geometry::root(h, h * rest / (lengths[interval + 1] - lengths[interval]),
                          [&](double t) { return std::pair(piece.length(t) - rest, piece.speed(t)); });
}

double ProfileCurve::s_at_y(double y) const {
    if (std::isnan(y)) return y;
    if (tables_->y_sense == 0) return tables_->search_y(y);
    const auto& values = tables_->by_y.values();
    const double along = tables_->y_sense * y;
    if (!(along > values.front())) return 0;
    if (along >= values.back()) return end();
    return tables_->s_in(tables_->by_y(along), y);
}

const std::vector<ProfilePoint>& ProfileCurve::points() const {
    return tables_->points;
}

const std::vector<std::size_t>& ProfileCurve::kinks() const {
    return tables_->kinks;
}

const std::vector<double>& ProfileCurve::knots() const {
    return tables_->knots();
}

bool ProfileCurve::y_is_monotone() const {
    return tables_->y_sense != 0;
}

ProfileCurve ProfileCurve::mirrored() const {
    std::vector<ProfilePoint> points(tables_->points.rbegin(), tables_->points.rend());
    for (ProfilePoint& point : points) point.y = -point.y;
    std::vector<std::size_t> kinks(tables_->kinks.rbegin(), tables_->kinks.rend());
    for (std::size_t& kink : kinks) kink = points.size() - 1 - kink;
    ProfileCurve curve(std::move(points), std::move(kinks));
    return middle_ ? curve.counted_from(end() - *middle_) : curve;
}

ProfileCurve ProfileCurve::counted_from(double s) const {
    ProfileCurve curve = *this;
    curve.middle_ = s;
    return curve;
}

}  // namespace contactd
