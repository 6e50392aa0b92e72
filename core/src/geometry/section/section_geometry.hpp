// Represents a section as curves: its outline and holes by arc length, and the strips on one of them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "contactd/section.hpp"
#include "geometry/section/closed_curve.hpp"

namespace contactd::geometry {

/// A curve has a corner where its angle changes by more than this (rad); smaller changes are rounding errors of
/// coordinates.
inline constexpr double least_corner = 0.02;
/// The angle may change by at most this over a strip's arc (rad).
inline constexpr double most_strip_turn = 0.5;

class SectionGeometry {
   public:
    /// `ds` is the arc length of a strip (mm). Throws InvalidArgument below `field` as validate() and check_outlines()
    /// do and, with coordinates, for strips that pass a corner, lie on a clamped part or on each other, or turn by more
    /// than most_strip_turn.
    SectionGeometry(const Section& section, int strips, double ds, const std::string& field = "section");

    /// Returns the outside first, then the holes.
    const std::vector<ClosedCurve>& curves() const { return curves_; }
    /// Returns the index of the curve that carries the strips.
    std::size_t carrier_index() const { return carrier_; }
    const ClosedCurve& carrier() const { return curves_[carrier_]; }

    int strips() const { return strips_; }
    double ds() const { return ds_; }
    /// Returns the arc length of the carrier at which a strip begins, or the last one ends (strip = strips()). It is in
    /// [0, length) for the first strip, and exceeds the length if strips pass the start of the outline.
    double begin_of(int strip) const { return first_ + strip * ds_; }
    /// Returns the length of the carrier if it has no corner, so that strips may cover all of it; otherwise 0.
    double perimeter() const;
    /// Returns whether the body has a convex corner at this arc length of the carrier, except for rounding.
    bool is_edge(double s) const;

    /// Returns the frames at the midpoints of the strips.
    std::vector<StripFrame> frames() const;

   private:
    std::vector<ClosedCurve> curves_;
    std::size_t carrier_ = 0;
    int strips_;
    double ds_;
    double first_ = 0;
};

}  // namespace contactd::geometry
