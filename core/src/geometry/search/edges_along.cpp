#include "geometry/search/edges_along.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/search/gap_mesh.hpp"

namespace contactd::geometry {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double further = 0.1;   // mm: heights of a state that are closer are evaluated together
constexpr double inexact = 0.01;  // mm: by this much gaps along lines may be too large
// Gaps may also be too large by this part of the second differences along a line, because cubics overshoot.
constexpr double of_second = 0.125;
constexpr double steepest_side = 3;  // dz/dy above which only the middle of a line is evaluated

/// Approximates the lower side of a round wheel near a place of its profile by a parabola.
class Ring {
   public:
    explicit Ring(const WheelSurface& wheel) : wheel_(wheel) {}

    /// Returns the distance of a point of the track below the wheel, in the direction of the wheel's own z, or infinity
    /// if there is no wheel.
    double gap(const Vector3& point) {
        const Vector3 inside = wheel_.frame().inside(point);
        const double y = inside.y - wheel_.base_y();
        if (!(std::abs(y - y_) <= valid)) look_at(y);
        const double radius = radius_ + (y - y_) * (slope_ + 0.5 * (y - y_) * bend_);
        return exists_ ? inside.z - std::sqrt(std::max(radius * radius - inside.x * inside.x, 0.0)) : infinity;
    }

   private:
    static constexpr double valid = 0.25;  // mm

    void look_at(double y) {
        const Span& seen = wheel_.visible();
        const double s = wheel_.profile().s_at_y(y);
        exists_ = s > seen.from - valid && s < seen.to + valid;
        const ProfileCurve::Place here = wheel_.profile().place(s);
        y_ = y;
        radius_ = wheel_.nominal_radius() + here.at.z;
        slope_ = here.slope.z / here.slope.y;
        bend_ = (here.curving.z - slope_ * here.curving.y) / (here.slope.y * here.slope.y);
    }

    const WheelSurface& wheel_;
    double y_ = infinity, radius_ = 0, slope_ = 0, bend_ = 0;
    bool exists_ = false;
};

/// Returns a row within a step of y that has a gap, or null.
const LocusRow* row_near(const Locus& locus, double y) {
    for (const LocusRow& row : locus.rows_within({y - locus.step(), y + locus.step()}))
        if (std::isfinite(row.gap)) return &row;
    return nullptr;
}

}  // namespace

double expected_gap(const Locus& locus, double x, double y) {
    double least = infinity;
    for (const LocusRow& row : locus.rows_within({y - locus.step(), y + locus.step()})) {
        const double ahead = x - row.x;
        if (std::isfinite(row.gap)) least = std::min(least, row.gap + locus.curvature() * ahead * ahead);
    }
    return least;
}

EdgesAlong::EdgesAlong(const WheelSurface& wheel, const RailSurface& rail) : wheel_(wheel), rail_(rail) {
    constexpr double width = RailSurface::step_along;
    const double middle = std::round(wheel.profile_origin().x / width), beside = std::ceil(reach_along(wheel) / width);
    for (double column = middle - beside - 1; column <= middle + beside + 1; ++column) {
        x_.push_back(width * column);
        there_.push_back(rail.slices()->place(rail.along_slices() + x_.back()));
    }
}

bool EdgesAlong::may_reach(const Locus& locus, double z) {
    if (z > looked_below_) look_below(locus, z + further);
    return std::ranges::any_of(unexpected_, [&](const Place& place) {
        return place.gap < z && place.gap < expected_gap(locus, place.x, place.y) - known_gap;
    });
}

void EdgesAlong::look_below(const Locus& locus, double z) {
    looked_below_ = z;
    unexpected_.clear();
    const SlicedRail& slices = *rail_.slices();
    const double from = rail_.along_slices() + x_.front(), to = rail_.along_slices() + x_.back();
    const ProfilePoint change = slices.largest_change(from, to);
    const double steepest = slices.steepest(from, to);
    const std::size_t middle = x_.size() / 2;
    std::vector<ProfilePoint> line;
    for (std::size_t i = 0; i < slices.lines(); ++i) {
        slices.look_along(i, std::span(there_).subspan(middle, 1), line);
        const ProfilePoint at = rail_.placed(line.front());
        if (floor_of(locus, at.y, change, steepest) > z) continue;
        slices.look_along(i, there_, line);
        for (ProfilePoint& point : line) point = rail_.placed(point);
        look_along_line(locus, line, z);
    }
}

double EdgesAlong::floor_of(const Locus& locus, double y, const ProfilePoint& change, double steepest) const {
    constexpr double beside = 0.6;  // mm
    double least = std::isnan(y) ? -infinity : infinity;
    bool is_known = false;
    for (const LocusRow& row : locus.rows_within({y - change.y - beside, y + change.y + beside}))
        if (std::isfinite(row.gap)) {
            least = std::min(least, row.gap);
            is_known = true;
        }
    if (!is_known) return -infinity;
    return least - change.z - steepest_side * change.y - steepest * steepest / (4 * locus.curvature()) - inexact;
}

void EdgesAlong::look_along_line(const Locus& locus, std::span<const ProfilePoint> line, double z) {
    Ring ring(wheel_);
    const LocusRow* row = nullptr;
    const auto second = [&](std::size_t i) {
        if (i == 0 || i + 1 >= line.size()) return 0.0;
        const double difference = std::abs(line[i - 1].z - 2 * line[i].z + line[i + 1].z);
        return std::isnan(difference) ? 0.0 : difference;
    };
    double largest_second = 0;
    for (std::size_t i = 1; i + 1 < line.size(); ++i) largest_second = std::max(largest_second, second(i));
    const double low = z + inexact + of_second * largest_second;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const auto& [y, height] = line[i];
        const double gap = ring.gap({x_[i], y, height});
        if (!(gap < low)) continue;
        const double beyond = i > 0 ? std::max(second(i - 1), second(i + 1)) : second(i + 1);
        const double least = gap - inexact - of_second * std::max(second(i), beyond);
        if (!(least < z)) continue;
        if (!row || !(std::abs(row->y - y) <= locus.step())) row = row_near(locus, y);
        const double ahead = row ? x_[i] - row->x : 0;
        if (row && least >= row->gap + locus.curvature() * ahead * ahead - known_gap) continue;
        if (least < expected_gap(locus, x_[i], y) - known_gap) unexpected_.push_back({x_[i], y, least});
    }
}

}  // namespace contactd::geometry
