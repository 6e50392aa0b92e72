#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "geometry/distance/heights.hpp"
#include "geometry/distance/row_nodes.hpp"
#include "geometry/placement/ascending_root.hpp"

namespace contactd::geometry {
namespace {

// The track's x has no component along the z axis of a wheelset that yaws first and rolls then. Therefore the x at
// which the wheel's surface is above a point of the plane follows from s alone, and s is the root of one function.
class WheelAbovePlane {
   public:
    WheelAbovePlane(const WheelSurface& wheel, const ContactReference& reference) : wheel_(wheel) {
        const Frame contact = contact_frame(reference);
        const Rotation& axes = wheel.frame().axes;
        along_ = axes.rotated_back(contact.axes.x);
        across_ = axes.rotated_back(contact.axes.y);
        normal_ = axes.rotated_back(contact.axes.z);
        centre_ = wheel.frame().inside(contact.origin);
        const auto& profile = wheel.profile();
        const double s = profile.s_at_y(centre_.y - wheel.base_y());
        span_ = ascending_span(profile, s,
                               [&](const ProfilePoint& point) { return across_.y * point.y + across_.z * point.z; });
        start_ = std::clamp(s, span_.from, span_.to);
    }

    /// Adds the heights at the row's elements from their nodes if the surface is smooth there. Otherwise adds nothing
    /// and returns false.
    bool add_row_by_nodes(double y, const RowNodes& nodes, double settled, std::vector<double>& heights) {
        const bool goes_on = !lines_.empty();
        if (!goes_on) lines_.assign(RowNodes::count, Line(start_));
        RowNodes::Values values;
        for (std::size_t j = 0; j < RowNodes::count; ++j) {
            double s = goes_on || j == 0 ? lines_[j].next() : lines_[j - 1].last();
            values[j] = height(nodes.x()[j], y, s);
            lines_[j].learn(s);
        }
        if (!RowNodes::smooth(values, settled)) {
            lines_.clear();
            return false;
        }
        nodes.interpolate(values, heights);
        return true;
    }

    /// Adds the heights at the row's elements, from x0 on.
    void add_row(double y, double x0, double dx, int count, std::vector<double>& heights) {
        Line line(start_);
        for (int i = 0; i < count; ++i) {
            double s = line.next();
            heights.push_back(height(x0 + i * dx, y, s));
            if (std::isnan(heights.back())) {
                line = Line(line.last());
                continue;
            }
            line.learn(s);
            if (i == 0) start_ = s;
        }
    }

   private:
    struct At {
        double y, y_slope;            // along the plane
        double height, height_slope;  // by s, at constant x of the track
    };

    At at(double x, double s) const {
        const ProfileCurve::Place place = wheel_.profile().place(s);
        const double side = wheel_.base_y() + place.at.y - centre_.y;
        const double along = centre_.x + (x - along_.y * side) / along_.x;
        const double along_slope = -along_.y / along_.x * place.slope.y;
        const BelowAxle below = wheel_.below_axle(along, place, s);
        const double z_slope = (below.by_s + below.by_x * along_slope) / below.over;
        const Vector3 from_centre{along - centre_.x, side, below.z - centre_.z};
        const Vector3 slope{along_slope, place.slope.y, z_slope};
        return {dot(across_, from_centre), dot(across_, slope), dot(normal_, from_centre), dot(normal_, slope)};
    }

    // If the guess is good, one evaluation is sufficient: the error is of second order.
    double height(double x, double y, double& s) const {
        constexpr double near = 1e-5;  // mm
        At here = at(x, s);
        if (!(std::abs(here.y - y) < near && s >= span_.from && s <= span_.to)) {
            const auto look = [&](double there) {
                here = at(x, there);
                return Sloped{here.y, here.y_slope};
            };
            if (!find_ascending(look, y, span_.from, span_.to, s)) return no_height;
        }
        const double step = (y - here.y) / here.y_slope;
        s += step;
        return here.height + step * here.height_slope;
    }

    /// Holds the profile's s of a node, from row to row.
    class Line {
       public:
        explicit Line(double start) : s_(start) {}
        double next() const {
            return known_ > 2 ? 3 * (s_ - before_) + before_that_ : known_ > 1 ? 2 * s_ - before_ : s_;
        }
        void learn(double s) {
            before_that_ = before_;
            before_ = s_;
            s_ = s;
            ++known_;
        }
        double last() const { return s_; }

       private:
        double s_, before_ = 0, before_that_ = 0;
        int known_ = 0;
    };

    const WheelSurface& wheel_;
    std::vector<Line> lines_;
    Vector3 along_, across_, normal_, centre_;  // axes of the contact, in the wheel's coordinates
    Span span_;
    double start_ = 0;
};

}  // namespace

std::vector<double> wheel_heights(const WheelSurface& wheel, const ContactReference& reference,
                                  const PlanePoints& points, double settled) {
    WheelAbovePlane above(wheel, reference);
    std::vector<double> heights;
    heights.reserve(points.rows.size() * static_cast<std::size_t>(points.nx()));
    constexpr int worthwhile = 12;  // elements of a row
    std::optional<RowNodes> nodes;
    if (wheel.is_round() && points.nx() >= worthwhile) nodes.emplace(points.x(0), points.columns.dx, points.nx());
    for (const double y : points.rows)
        if (!nodes || !above.add_row_by_nodes(y, *nodes, settled, heights))
            above.add_row(y, points.x(0), points.columns.dx, points.nx(), heights);
    return heights;
}

}  // namespace contactd::geometry
