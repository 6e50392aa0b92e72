#include "geometry/placement/sliced_rail.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "contactd/count_of.hpp"
#include "contactd/error.hpp"
#include "types/number_text.hpp"

namespace contactd::geometry {
namespace {

constexpr double spacing = 0.5;         // mm: distance of points on the longest slice
constexpr int most_places = 2'000'000;  // 64 MB
constexpr double rounding = 1e-6;       // mm
constexpr double at_a_kink = 0.1;       // mm: features are rounded

std::string of_slice(std::size_t i, const char* member) {
    return "rail_slices[" + std::to_string(i) + "]." + member;
}

std::vector<double> ends_at_kinks(const ProfileCurve& curve) {
    std::vector<double> ends{0};
    for (const std::size_t kink : curve.kinks()) ends.push_back(curve.knots()[kink]);
    ends.push_back(curve.end());
    return ends;
}

std::vector<double> ends_at_features(const SlicedRail::Slice& slice, const std::string& field) {
    const double length = slice.curve.end();
    std::vector<double> ends = slice.features;
    ends.back() = std::min(ends.back(), length);
    for (std::size_t i = 0; i < ends.size(); ++i) {
        const bool is_first = i == 0 || ends[i - 1] < 0;
        if (ends[i] > length || (!is_first && ends[i] >= 0 && ends[i] <= ends[i - 1]))
            throw InvalidArgument(field + "[" + std::to_string(i) + "]",
                                  "is " + number_text(slice.features[i]) + " mm, but the profile ends at " +
                                      short_text(length) + " mm; only the last feature may lie beyond its end");
    }
    return ends;
}

/// Parts that begin or end between two slices cannot be joined unless features identify them.
void check_kinks(const std::vector<std::vector<double>>& ends) {
    const std::size_t parts = ends.front().size() - 1;
    for (std::size_t i = 1; i < ends.size(); ++i)
        if (const std::size_t here = ends[i].size() - 1; here != parts)
            throw InvalidArgument(
                of_slice(i, "profile"),
                "has " + std::to_string(here) + (here == 1 ? " part" : " parts") +
                    " between kinks, but the first slice has " + std::to_string(parts) +
                    "; slices are joined part by part, so all need the same number of kinks (turns of more than 30 "
                    "degrees at a point): give `features`, smooth the noise, or trim the slices consistently");
}

bool has_kink_near(const ProfileCurve& curve, double length) {
    return std::ranges::any_of(curve.kinks(),
                               [&](std::size_t kink) { return std::abs(curve.knots()[kink] - length) < at_a_kink; });
}

bool exists(const std::vector<double>& ends, std::size_t part) {
    return ends[part] >= 0 && ends[part + 1] >= 0;
}

}  // namespace

SlicedRail::SlicedRail(const std::vector<Slice>& slices, SliceSpline spline) {
    std::vector<Ends> ends;
    const bool has_features = !slices.front().features.empty();
    for (const Slice& slice : slices) {
        x_.push_back(slice.x);
        ends.push_back(has_features ? ends_at_features(slice, of_slice(ends.size(), "features"))
                                    : ends_at_kinks(slice.curve));
        kinked_.emplace_back();
        for (const double end : ends.back()) kinked_.back().push_back(has_kink_near(slice.curve, end));
    }
    check_kinks(ends);
    const std::size_t parts = ends.front().size() - 1;
    for (std::size_t part = 0; part < parts; ++part) join(slices, ends, part, spline);
    for (const Stretch& stretch : stretches_) go_along(stretch.first, stretch.last);
    for (Stretch& before : stretches_)
        for (Stretch& behind : stretches_)
            if (behind.part == before.part + 1) join_at_feature(before, behind);
    for (std::size_t i = 0; i + 1 < slices.size(); ++i)
        if (std::ranges::none_of(stretches_, [i](const Stretch& at) { return at.first <= i && i < at.last; }))
            throw InvalidArgument(of_slice(i + 1, "features"),
                                  "have no part in common with the previous slice, so there is no rail between them");
    find_steepest();
}

void SlicedRail::join(const std::vector<Slice>& slices, const std::vector<Ends>& ends, std::size_t part,
                      SliceSpline spline) {
    double longest = 0;
    for (const Ends& of_slice : ends)
        if (exists(of_slice, part)) longest = std::max(longest, of_slice[part + 1] - of_slice[part]);
    const int pieces = std::max(
        3, count_of(std::floor((longest + rounding) / spacing) + 1,
                    {"rail_slices", "have a part that is " + short_text(longest) + " mm long",
                     "points along all slices together", "use fewer slices, or omit points that jump up and down",
                     most_places / static_cast<int>(slices.size())}));
    for (std::size_t first = 0, last; first < slices.size(); first = last + 1) {
        last = first;
        if (!exists(ends[first], part)) continue;
        while (last + 1 < slices.size() && exists(ends[last + 1], part)) ++last;
        if (last == first) continue;
        std::vector<double> along(x_.begin() + static_cast<std::ptrdiff_t>(first),
                                  x_.begin() + static_cast<std::ptrdiff_t>(last) + 1);
        Stretch stretch{first, last, part, SplineAlong(std::move(along), spline), {}, {}};
        for (int piece = 0; piece <= pieces; ++piece) {
            std::vector<double> y, z;
            for (std::size_t i = first; i <= last; ++i) {
                const double from = ends[i][part], to = ends[i][part + 1];
                const ProfileCurve& curve = slices[i].curve;
                const ProfilePoint at = curve.at(from + (to - from) * piece / pieces);
                y.push_back(at.y);
                z.push_back(at.z);
            }
            stretch.y.push_back({std::move(y), {}});
            stretch.z.push_back({std::move(z), {}});
        }
        stretches_.push_back(std::move(stretch));
    }
}

// Parts of the same slices are computed together, so that they meet at the features between them.
void SlicedRail::go_along(std::size_t first, std::size_t last) {
    std::vector<Stretch*> parts;
    for (Stretch& stretch : stretches_)
        if (stretch.first == first && stretch.last == last) parts.push_back(&stretch);
    if (!parts.front()->y.front().derivatives.empty()) return;  // They were already computed.
    for (const auto lines : {&Stretch::y, &Stretch::z}) {
        std::vector<SlicePoints> points(last + 1 - first);
        for (const Stretch* stretch : parts)
            for (const LineAlong& line : stretch->*lines)
                for (std::size_t i = 0; i < points.size(); ++i) points[i].push_back(line.values[i]);
        const std::vector<DerivativeShares> shares = parts.front()->along.shares(points);
        for (Stretch* stretch : parts)
            for (LineAlong& line : stretch->*lines) line = stretch->along.line(std::move(line.values), shares);
    }
}

// A part that begins or ends beside a longer one depends on other slices, so that the feature between both would leave
// a slice in two directions. It takes the direction of the longer one, and the difference decays across it.
void SlicedRail::join_at_feature(Stretch& before, Stretch& behind) {
    if (before.first == behind.first && before.last == behind.last) return;
    const bool before_is_longer = before.last - before.first > behind.last - behind.first;
    const Stretch& longer = before_is_longer ? before : behind;
    Stretch& shorter = before_is_longer ? behind : before;
    const std::size_t pieces = shorter.y.size() - 1;
    const std::size_t first = std::max(before.first, behind.first), last = std::min(before.last, behind.last);
    for (const auto lines : {&Stretch::y, &Stretch::z})
        for (std::size_t slice = first; slice <= last && last > first; ++slice) {
            const LineAlong& there = before_is_longer ? (longer.*lines).back() : (longer.*lines).front();
            const LineAlong& here = before_is_longer ? (shorter.*lines).front() : (shorter.*lines).back();
            const KnotDerivatives to = there.derivatives[slice - longer.first];
            const KnotDerivatives from = here.derivatives[slice - shorter.first];
            for (std::size_t k = 0; k <= pieces; ++k) {
                const double share =
                    static_cast<double>(before_is_longer ? pieces - k : k) / static_cast<double>(pieces);
                KnotDerivatives& at = (shorter.*lines)[k].derivatives[slice - shorter.first];
                at.slope += share * (to.slope - from.slope);
                at.curving += share * (to.curving - from.curving);
            }
        }
}

double SlicedRail::next_slice(double x) const {
    const auto next = std::upper_bound(x_.begin(), x_.end(), x);
    return next == x_.end() ? std::numeric_limits<double>::infinity() : *next;
}

std::size_t SlicedRail::slice_before(double x) const {
    return static_cast<std::size_t>(std::upper_bound(x_.begin() + 1, x_.end() - 1, x) - x_.begin()) - 1;
}

ProfileCurve SlicedRail::at(double x) const {
    const double inside = std::clamp(x, x_.front(), x_.back());
    const std::size_t slice = slice_before(inside);
    std::vector<ProfilePoint> points;
    std::vector<std::size_t> kinks;
    for (const Stretch& stretch : stretches_) {
        if (slice < stretch.first || slice >= stretch.last) continue;
        const std::size_t knot = slice - stretch.first;
        const double h = stretch.along.width(knot);
        const QuinticWeights weights = QuinticWeights::of_value((inside - x_[slice]) / h, h);
        const bool goes_on = !points.empty();
        if (goes_on && (kinked_[slice][stretch.part] || kinked_[slice + 1][stretch.part]))
            kinks.push_back(points.size() - 1);
        for (std::size_t k = goes_on ? 1 : 0; k < stretch.y.size(); ++k)
            points.push_back({stretch.y[k].between(knot, weights), stretch.z[k].between(knot, weights)});
    }
    return ProfileCurve(std::move(points), std::move(kinks));
}

}  // namespace contactd::geometry
