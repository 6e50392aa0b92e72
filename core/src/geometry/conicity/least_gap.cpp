#include "geometry/conicity/least_gap.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "contactd/count_of.hpp"
#include "geometry/conicity/bracketed_root.hpp"
#include "types/number_text.hpp"

namespace contactd::geometry {
namespace {

constexpr double step = 0.5;  // mm: step of the search along the wheel
constexpr int most_places = 100'000;
// The search is this many times finer around gaps near the least, because of the bumps of measured profiles.
constexpr int closer = 8;
constexpr double rivals = 0.1;     // mm: largest difference of such gaps
constexpr double precise = 1e-11;  // mm: accuracy along the wheel

class Gap {
   public:
    Gap(const WheelOverRail& pair, double shift, double roll)
        : pair_(pair),
          radius_(pair.nominal_radius),
          shift_(shift),
          cos_(std::cos(roll)),
          sin_(std::sin(roll)),
          inner_(pair.rail.at(pair.rail.begin()).y),
          outer_(pair.rail.at(pair.rail.end()).y) {}

    LeastGap at(double s) const {
        const ProfilePoint wheel = pair_.wheel.at(s);
        const double y = y_of(wheel), on_rail = y - pair_.rail_origin.y;
        LeastGap found;
        if (on_rail < inner_ || on_rail > outer_) return found;
        found.wheel_s = s;
        found.rail_s = pair_.rail.s_at_y(on_rail);
        found.place = {y, pair_.rail_origin.z + pair_.rail.at(found.rail_s).z};
        found.gap = found.place.z - (sin_ * (pair_.wheel_origin + wheel.y) + cos_ * (radius_ + wheel.z) - radius_);
        return found;
    }

    /// Returns the cross product of both tangents, which has the sign of the gap's derivative.
    double slope(double s) const {
        const auto wheel = pair_.wheel.place(s);
        const ProfilePoint rail = pair_.rail.slope(pair_.rail.s_at_y(y_of(wheel.at) - pair_.rail_origin.y));
        return rail.z * (cos_ * wheel.slope.y - sin_ * wheel.slope.z) -
               rail.y * (sin_ * wheel.slope.y + cos_ * wheel.slope.z);
    }

   private:
    double y_of(const ProfilePoint& wheel) const {
        return shift_ + cos_ * (pair_.wheel_origin + wheel.y) - sin_ * (radius_ + wheel.z);
    }

    const WheelOverRail& pair_;
    double radius_, shift_, cos_, sin_, inner_, outer_;  // inner and outer: y of the rail's ends
};

/// Refines the least gap between the neighbours of a sample that is lower than both.
LeastGap refined(const Gap& gap, const LeastGap& before, const LeastGap& sample, const LeastGap& behind) {
    if (std::isinf(before.gap) || std::isinf(behind.gap)) {
        LeastGap end = sample;
        end.at_end = true;
        return end;
    }
    const double at_low = gap.slope(before.wheel_s), at_high = gap.slope(behind.wheel_s);
    if (!(at_low < 0 && at_high > 0)) return sample;  // both are equal
    return gap.at(bracketed_root(before.wheel_s, behind.wheel_s, at_low, at_high, precise,
                                 [&](double s) { return gap.slope(s); }));
}

/// Samples along the wheel, in small steps around the least gaps, and with nothing beyond both ends.
std::vector<LeastGap> samples_along(const Gap& gap, double length) {
    const int count =
        count_of(std::ceil(length / step), {"wheel", "has a profile that is " + short_text(length) + " mm long",
                                            "sampling points", "omit points that jump up and down", most_places});
    std::vector<LeastGap> coarse;
    for (int i = 0; i <= count; ++i) coarse.push_back(gap.at(length * i / count));
    const double near = rivals + std::min_element(coarse.begin(), coarse.end(), [](const auto& a, const auto& b) {
                                     return a.gap < b.gap;
                                 })->gap;
    std::vector<LeastGap> samples{LeastGap{}, coarse.front()};
    for (int i = 1; i <= count; ++i) {
        if (std::fmin(coarse[i - 1].gap, coarse[i].gap) <= near)
            for (int k = 1; k < closer; ++k)
                samples.push_back(gap.at(length * (i - 1 + static_cast<double>(k) / closer) / count));
        samples.push_back(coarse[i]);
    }
    samples.push_back(LeastGap{});
    return samples;
}

}  // namespace

LeastGap least_gap(const WheelOverRail& pair, double shift, double roll) {
    const Gap gap(pair, shift, roll);
    const auto samples = samples_along(gap, pair.wheel.end());
    LeastGap found;
    for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
        const LeastGap& sample = samples[i];
        if (sample.gap > found.gap + rivals || sample.gap > samples[i - 1].gap || sample.gap > samples[i + 1].gap)
            continue;
        if (const LeastGap lower = refined(gap, samples[i - 1], sample, samples[i + 1]); lower.gap < found.gap)
            found = lower;
    }
    return found;
}

}  // namespace contactd::geometry
