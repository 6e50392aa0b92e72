#include "geometry/search/locus.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "contactd/count_of.hpp"
#include "geometry/placement/ascending_root.hpp"
#include "types/number_text.hpp"

namespace contactd::geometry {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double near = 1e-6;          // mm: so short a step along a tangent is exact
constexpr double longest_span = 0.5;   // mm: length of rows that the first pass skips
constexpr double deepest_dent = 0.25;  // in lengths of a span
constexpr double least_dent = 0.02;    // mm: by this much a gap within a span may be less than those at its ends
constexpr int most_rows = 1'000'000;   // 64 MB

std::size_t rows_in_span(double step) {
    return static_cast<std::size_t>(std::max(1.0, longest_span / step));  // The constructor has limited the quotient.
}

/// Returns y where the gap is `height`, by a parabola through three rows, or by the line through the first two if the
/// third has no gap or the gap of one of them.
double y_of_gap(const LocusRow& a, const LocusRow& b, const LocusRow& c, double height) {
    const double along = (height - a.gap) / (b.gap - a.gap), line = a.y + along * (b.y - a.y);
    if (!std::isfinite(c.gap) || c.gap == a.gap || c.gap == b.gap) return line;
    const double rise_ab = (b.y - a.y) / (b.gap - a.gap), rise_bc = (c.y - b.y) / (c.gap - b.gap);
    return line + (height - a.gap) * (height - b.gap) * (rise_bc - rise_ab) / (c.gap - a.gap);
}

}  // namespace

Locus::Locus(const WheelSurface& wheel, const RailSurface& rail, double step, const Observer& observer)
    : wheel_(wheel), rail_(rail), observer_(observer), step_(step), least_gap_(infinite) {
    const Span& seen = rail.visible();
    const auto count =
        static_cast<std::size_t>(
            count_of((seen.high - seen.low) / step, {"patches.locus_step", "times dy is " + number_text(step) + " mm",
                                                     "rows along the rail", "increase one of them", most_rows})) +
        1;
    rows_.assign(count, {0, infinite});
    wheel_s_.assign(count, 0);
    for (std::size_t i = 0; i < count; ++i) rows_[i].y = seen.low + static_cast<double>(i) * step;
    const std::size_t span = rows_in_span(step);
    Start start{seen.low, {wheel.visible().from}, {seen.from}};
    for (std::size_t i = 0; i < count; i += span) look_at(i, start);
    if ((count - 1) % span != 0) look_at(count - 1, start);
    for (std::size_t begin = 0; begin < count; begin += span) least_.push_back(least_between(begin));
    if (least_gap_ < infinite) look_below(least_gap_);
}

std::span<const LocusRow> Locus::rows_within(const Extent& y) const {
    const auto below = [](const LocusRow& row, double value) { return row.y < value; };
    const auto above = [](double value, const LocusRow& row) { return value < row.y; };
    return {std::lower_bound(rows_.begin(), rows_.end(), y.from, below),
            std::upper_bound(rows_.begin(), rows_.end(), y.to, above)};
}

double Locus::curvature() const {
    return 0.5 / wheel_.nominal_radius() + 0.5 * rail_.curvature_along();
}

/// Fills the row at row.y; returns false if there is no wheel or no rail. Rows are close to each other, so that the
/// start is usually near: one evaluation of each curve and its tangents are sufficient.
bool Locus::look(LocusRow& row, Start& start) const {
    const double step = row.y - start.y;
    double rail_s = start.rail.ahead(step), wheel_s = start.wheel.ahead(step);
    ProfileCurve::Place rail;
    LocusPoint wheel;
    const auto rail_at = [&](double s) {
        rail = rail_.place(s);
        return Sloped{rail.at.y, rail.slope.y};
    };
    const auto rail_slope = [&](double x) { return rail_.slope_along(x, row.y, rail.at.z); };
    const auto wheel_at = [&](double s) {
        wheel = rail_.is_sliced() ? wheel_.locus(s, std::ref(rail_slope))
                                  : wheel_.locus(s, rail_.curvature_around(rail.at));
        return Sloped{wheel.at.y, wheel.slope.y};
    };
    if (!find_ascending(rail_at, row.y, rail_.visible().from, rail_.visible().to, rail_s, near)) return false;
    if (const double rest = (row.y - rail.at.y) / rail.slope.y; std::abs(rest) <= near) {
        rail_s += rest;
        rail.at.z += rest * rail.slope.z;
    }
    if (!find_ascending(wheel_at, row.y, wheel_.visible().from, wheel_.visible().to, wheel_s, near)) return false;
    if (const double rest = (row.y - wheel.at.y) / wheel.slope.y; std::abs(rest) <= near) {
        wheel_s += rest;
        wheel.at = wheel.at + rest * wheel.slope;
    }
    const double z = rail_.z_at(wheel.at.x, row.y, rail.at.z);
    if (!std::isfinite(z)) return false;
    start.y = row.y;
    start.rail.go_on(step, rail_s, 1 / rail.slope.y);
    start.wheel.go_on(step, wheel_s, 1 / wheel.slope.y);
    const double rise = rail.slope.z / rail.slope.y;
    row = {row.y, z - wheel.at.z, wheel.at.x, z, rail_s, rise, std::atan(rise)};
    return true;
}

void Locus::look_at(std::size_t i, Start& start) {
    if (!look(rows_[i], start)) return;
    wheel_s_[i] = start.wheel.s;
    least_gap_ = std::min(least_gap_, rows_[i].gap);
}

// Straight lines are not accurate enough where the rail is steep, because from row to row it falls by more than wheels
// penetrate. Through three rows, y is a parabola of the gap, which is used if it stays between the two rows around the
// height.
LocusRow Locus::crossing(std::size_t inside, std::size_t outside, double height) const {
    constexpr double settled = 1e-7;  // mm
    LocusRow in = rows_[inside], out = rows_[outside],
             third = inside > outside ? row_at(inside + 1) : row_at(inside - 1);
    Start start = start_at(inside);
    for (int iteration = 0; iteration < 20 && std::abs(out.y - in.y) > settled; ++iteration) {
        LocusRow between;
        between.y = y_of_gap(in, out, third, height);
        // Near one end, a parabola moves only that end, so the middle is used now and then.
        if (iteration % 4 == 3 || !((between.y - in.y) * (between.y - out.y) < 0)) between.y = 0.5 * (in.y + out.y);
        if (between.y == in.y || between.y == out.y || !look(between, start)) break;
        if (std::abs(between.gap - height) < settled) return between;
        LocusRow& replaced = between.gap < height ? in : out;
        third = replaced;
        replaced = between;
    }
    return in;
}

void Locus::look_below(double height) {
    const std::size_t span = rows_in_span(step_);
    for (std::size_t k = 0; k < least_.size(); ++k) {
        if (least_[k] > height) continue;
        least_[k] = infinite;
        look_between(k * span);
    }
}

double Locus::least_between(std::size_t begin) const {
    const std::size_t end = std::min(begin + rows_in_span(step_), rows_.size() - 1);
    return std::min(rows_[begin].gap, rows_[end].gap) - dent(begin, end);
}

// A parabola through the ends of two spans dents each by an eighth of its second difference. The estimate is much
// larger to be safe, and larger where profiles are rough, up to the size of a kink. Spans are unknown if there is no
// wheel beside them.
double Locus::dent(std::size_t begin, std::size_t end) const {
    const std::size_t span = rows_in_span(step_);
    const auto bend = [&](std::size_t at) {
        if (at < span || at + span >= rows_.size()) return 0.0;
        const double second = rows_[at - span].gap - 2 * rows_[at].gap + rows_[at + span].gap;
        return std::isfinite(second) ? std::abs(second) : 0.0;
    };
    const double deepest = deepest_dent * static_cast<double>(end - begin) * step_;
    return std::min(least_dent + 2 * std::max(bend(begin), bend(end)), std::max(deepest, least_dent));
}

void Locus::look_between(std::size_t begin) {
    observer_.throw_if_cancelled();
    const std::size_t span = rows_in_span(step_), end = std::min(begin + span, rows_.size() - 1);
    const bool from_begin = rows_[begin].gap < infinite;
    Start start = start_at(from_begin ? begin : end);
    for (std::size_t i = begin + 1; i < end; ++i) look_at(i, start);
}

}  // namespace contactd::geometry
