// Cleans the points of a measured profile, and finds where they are broken and what of them is seen.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "contactd/profile_spec.hpp"

namespace contactd::geometry {

using Points = std::vector<ProfilePoint>;

/// Without points closer than 1e-4 mm to the one before.
Points without_repetitions(const Points& points);

/// Where two turns of more than 150 degrees follow each other, both points become their mean.
Points without_zigzags(Points points);

/// Returns the points of a wheel that are seen from above its middle: both ways from there, as far as y goes on.
Points wheel_seen_from_above(const Points& points);

/// Returns the points of a rail that are not hidden from above: of two with the same y the upper one, outwards from its
/// top.
Points rail_seen_from_above(const Points& points);

Points seen_from_above(const Points& points, ProfileKind kind);

/// Points at which the curve is broken. One that lies alone between two of them is one, too: smoothed through three
/// points a curve would follow none of them.
std::vector<std::size_t> kinks_of(const Points& points, const KinkRule& rule = {});

/// What bodies that come from above can touch.
struct Visible {
    Points points;
    std::vector<std::optional<std::size_t>> places;              ///< among all points; of none that was put in
    std::vector<std::size_t> kinks;                              ///< indices of points
    std::vector<std::pair<ProfilePoint, ProfilePoint>> bridged;  ///< neighbours with much that is hidden between
};

/// Leaves out what is hidden behind a lip. Where that is more than 2 mm and recedes by more than 0.1 mm, the curve goes
/// upright from the lip to where the other side comes out: a spline would swing out there.
Visible visible_part(const Points& points, const std::vector<std::size_t>& kinks, ProfileKind kind);

/// The first chord that another one crosses or touches, and that other one; their first points' indices, or {0, 0}.
struct Crossing {
    std::size_t first = 0, second = 0;
    bool found() const { return second > 0; }
};
Crossing crossing_of(const Points& points);

}  // namespace contactd::geometry
