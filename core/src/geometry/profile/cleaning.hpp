// Cleans the points of a measured profile before a curve goes through them.
#pragma once

#include <cstddef>
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

/// Points at which the curve is broken.
std::vector<std::size_t> kinks_of(const Points& points, const KinkRule& rule = {});

/// The first chord that another one crosses or touches, and that other one; their first points' indices, or {0, 0}.
struct Crossing {
    std::size_t first = 0, second = 0;
    bool found() const { return second > 0; }
};
Crossing crossing_of(const Points& points);

}  // namespace contactd::geometry
