#include "geometry/profile/cleaning.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace contactd::geometry {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double least_distance = 1e-4, least_advance = 1e-9;  // mm
constexpr double zigzag = 150 * degree;

double distance(const ProfilePoint& a, const ProfilePoint& b) {
    return std::hypot(b.y - a.y, b.z - a.z);
}

/// Returns the angle between the chords before and behind a point.
double turn(const Points& points, std::size_t i) {
    const double y0 = points[i].y - points[i - 1].y, z0 = points[i].z - points[i - 1].z;
    const double y1 = points[i + 1].y - points[i].y, z1 = points[i + 1].z - points[i].z;
    return std::abs(std::atan2(y0 * z1 - z0 * y1, y0 * y1 + z0 * z1));
}

/// Returns the points from one on whose y is farther out than that of any previous point.
template <class Iterator>
Points outwards(Iterator from, Iterator end, double sense) {
    Points kept{*from};
    for (++from; from != end; ++from)
        if (sense * (from->y - kept.back().y) > least_advance) kept.push_back(*from);
    return kept;
}

/// Returns the points that are not hidden: points that turn back above earlier ones hide these.
template <class Iterator>
Points uppermost(Iterator from, Iterator end, double sense) {
    Points kept{*from};
    for (++from; from != end; ++from) {
        const bool above = from->z < kept.back().z;
        while (above && kept.size() > 1 && sense * (from->y - kept.back().y) <= least_advance) kept.pop_back();
        if (sense * (from->y - kept.back().y) > least_advance) kept.push_back(*from);
    }
    return kept;
}

Points joined(Points left, const Points& right) {
    std::reverse(left.begin(), left.end());
    left.insert(left.end(), right.begin() + 1, right.end());
    return left;
}

/// Returns the point where the other side emerges from behind a lip. `beside` is the hidden point next to its end.
ProfilePoint behind_lip(const ProfilePoint& lip, const ProfilePoint& other, const ProfilePoint& beside) {
    constexpr double advance = 1e-3;  // mm, so that y increases or decreases throughout
    const double y = lip.y + std::copysign(std::min(advance, std::abs(other.y - lip.y) / 2), other.y - lip.y);
    const double share = std::clamp((y - beside.y) / (other.y - beside.y), 0.0, 1.0);
    return {y, beside.z + share * (other.z - beside.z)};
}

}  // namespace

Points without_repetitions(const Points& points) {
    Points kept;
    for (const ProfilePoint& point : points)
        if (kept.empty() || distance(kept.back(), point) >= least_distance) kept.push_back(point);
    return kept;
}

Points without_zigzags(Points points) {
    Points kept;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool twice = i > 0 && i + 2 < points.size() && turn(points, i) > zigzag && turn(points, i + 1) > zigzag;
        if (twice) {
            const ProfilePoint mean{(points[i].y + points[i + 1].y) / 2, (points[i].z + points[i + 1].z) / 2};
            points[++i] = mean;  // The next turn is that of the mean.
        }
        kept.push_back(points[i]);
    }
    return kept;
}

Points wheel_seen_from_above(const Points& points) {
    const auto by_y = [](const auto& a, const auto& b) { return a.y < b.y; };
    const auto [least, most] = std::minmax_element(points.begin(), points.end(), by_y);
    const double centre = (least->y + most->y) / 2;
    const auto middle = std::min_element(points.begin(), points.end(), [&](const auto& a, const auto& b) {
        return std::abs(a.y - centre) < std::abs(b.y - centre);
    });
    return joined(outwards(std::make_reverse_iterator(middle + 1), points.rend(), -1),
                  outwards(middle, points.end(), 1));
}

Points rail_seen_from_above(const Points& points) {
    const auto top =
        std::min_element(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.z < b.z; });
    return joined(uppermost(std::make_reverse_iterator(top + 1), points.rend(), -1), uppermost(top, points.end(), 1));
}

Points seen_from_above(const Points& points, ProfileKind kind) {
    return kind == ProfileKind::wheel ? wheel_seen_from_above(points) : rail_seen_from_above(points);
}

std::vector<std::size_t> kinks_of(const Points& points, const KinkRule& rule) {
    std::vector<double> s{0}, angles{0};
    for (std::size_t i = 1; i < points.size(); ++i) {
        s.push_back(s.back() + distance(points[i - 1], points[i]));
        angles.push_back(i + 1 < points.size() ? turn(points, i) : 0);
    }
    std::vector<std::size_t> kinks;
    const auto mark = [&](std::size_t i) {
        if (!kinks.empty() && i == kinks.back() + 2) kinks.push_back(i - 1);
        kinks.push_back(i);
    };
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        if (angles[i] <= rule.angle) continue;
        const auto from = std::lower_bound(s.begin(), s.end(), s[i] - rule.width) - s.begin();
        const auto to = std::upper_bound(s.begin(), s.end(), s[i] + rule.width) - s.begin();
        const auto bends =
            std::count_if(angles.begin() + from, angles.begin() + to, [&](double t) { return t > rule.rest; });
        if (bends == 1) mark(i);
    }
    return kinks;
}

Visible visible_part(const Points& points, const std::vector<std::size_t>& kinks, ProfileKind kind) {
    constexpr double width = 2, depth = 0.1;  // mm: noise hides less
    const Points seen = seen_from_above(points, kind);
    std::vector<std::size_t> places;  // among all points
    for (std::size_t i = 0; i < points.size() && places.size() < seen.size(); ++i)
        if (points[i] == seen[places.size()]) places.push_back(i);
    const auto hides_before = [&](std::size_t i) {
        if (i == 0 || i >= seen.size() || distance(seen[i - 1], seen[i]) <= width) return false;
        double most = seen[i - 1].y, least = seen[i].y;
        for (std::size_t k = places[i - 1] + 1; k < places[i]; ++k) {
            most = std::max(most, points[k].y);
            least = std::min(least, points[k].y);
        }
        return std::max(seen[i - 1].y - least, most - seen[i].y) > depth;
    };
    // A rail's lip is above the part that it hides, a wheel's below.
    const auto is_lip_beside = [kind](const ProfilePoint& end, const ProfilePoint& other) {
        return kind == ProfileKind::rail ? end.z < other.z : end.z > other.z;
    };
    Visible visible;
    const auto keep = [&](const ProfilePoint& point, std::optional<std::size_t> place, bool is_kink) {
        if (is_kink) visible.kinks.push_back(visible.points.size());
        visible.points.push_back(point);
        visible.places.push_back(place);
    };
    for (std::size_t i = 0; i < seen.size(); ++i) {
        if (hides_before(i)) {
            const ProfilePoint &left = seen[i - 1], &right = seen[i];
            keep(is_lip_beside(left, right) ? behind_lip(left, right, points[places[i] - 1])
                                            : behind_lip(right, left, points[places[i - 1] + 1]),
                 std::nullopt, true);
            visible.bridged.push_back({left, right});
        }
        const bool is_lip = (hides_before(i) && is_lip_beside(seen[i], seen[i - 1])) ||
                            (hides_before(i + 1) && is_lip_beside(seen[i], seen[i + 1]));
        keep(seen[i], places[i], is_lip || std::ranges::binary_search(kinks, places[i]));
    }
    std::erase_if(visible.kinks, [&](std::size_t i) { return i == 0 || i + 1 == visible.points.size(); });
    return visible;
}

Crossing crossing_of(const Points& points) {
    struct Chord {
        double from, to;  // in y
        std::size_t at;
    };
    std::vector<Chord> chords;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const auto [from, to] = std::minmax(points[i].y, points[i + 1].y);
        chords.push_back({from, to, i});
    }
    std::sort(chords.begin(), chords.end(), [](const Chord& a, const Chord& b) { return a.from < b.from; });
    const auto side = [&](std::size_t chord, const ProfilePoint& point) {
        const ProfilePoint &a = points[chord], &b = points[chord + 1];
        return (b.y - a.y) * (point.z - a.z) - (b.z - a.z) * (point.y - a.y);
    };
    const auto between = [&](std::size_t chord, std::size_t other) {
        return side(chord, points[other]) * side(chord, points[other + 1]) < 0;
    };
    for (std::size_t i = 0; i < chords.size(); ++i)
        for (std::size_t k = i + 1; k < chords.size() && chords[k].from <= chords[i].to; ++k) {
            const auto [first, second] = std::minmax(chords[i].at, chords[k].at);
            if (second > first + 1 && between(first, second) && between(second, first)) return {first, second};
        }
    return {};
}

}  // namespace contactd::geometry
