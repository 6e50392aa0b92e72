// Cleans the points of a measured profile, and finds its breaks and its visible part.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "contactd/profile_spec.hpp"

namespace contactd::geometry {

using Points = std::vector<ProfilePoint>;

/// Returns the points without those closer than 1e-4 mm to the previous one.
Points without_repetitions(const Points& points);

/// Returns the points with zigzags averaged: if two turns of more than 150 degrees follow each other, their mean
/// replaces both points.
Points without_zigzags(Points points);

/// Returns the points of a wheel that are visible from above its middle: both ways from there, as long as y increases.
Points wheel_seen_from_above(const Points& points);

/// Returns the points of a rail that are not hidden from above: of two with the same y the upper one, outwards from its
/// top.
Points rail_seen_from_above(const Points& points);

Points seen_from_above(const Points& points, ProfileKind kind);

/// Returns points at which the curve is broken. A single point between two of them is included, because a curve
/// smoothed through three points would follow none of them.
std::vector<std::size_t> kinks_of(const Points& points, const KinkRule& rule = {});

/// Holds the part that bodies from above can touch.
struct Visible {
    Points points;
    std::vector<std::optional<std::size_t>> places;              ///< indices among all points; absent for inserted ones
    std::vector<std::size_t> kinks;                              ///< indices of points
    std::vector<std::pair<ProfilePoint, ProfilePoint>> bridged;  ///< neighbours with a large hidden part between them
};

/// Omits the part hidden behind a lip. If that is more than 2 mm and recedes by more than 0.1 mm, the curve is vertical
/// from the lip to where the other side emerges, because a spline would overshoot there.
Visible visible_part(const Points& points, const std::vector<std::size_t>& kinks, ProfileKind kind);

/// Holds the first chord that another one crosses or touches, and that other one, by their first points' indices, or
/// {0, 0}.
struct Crossing {
    std::size_t first = 0, second = 0;
    bool found() const { return second > 0; }
};
Crossing crossing_of(const Points& points);

}  // namespace contactd::geometry
