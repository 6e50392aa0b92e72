// Represents a closed curve by its arc length.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "geometry/section/outline_piece.hpp"

namespace contactd::geometry {

class ClosedCurve {
   public:
    /// Throws InvalidArgument below `field` if the curve is not closed, or as its pieces do.
    ClosedCurve(const Outline& outline, const std::string& field);

    double length() const { return begin_.back(); }
    /// Returns the place at any arc length, modulo the curve's length. Where two pieces meet, it is that behind the
    /// joint.
    OutlinePlace place(double s) const;

    const std::vector<OutlinePiece>& pieces() const { return pieces_; }
    /// Returns the arc length at which a piece begins; begin_of(pieces().size()) is the length.
    double begin_of(std::size_t piece) const { return begin_[piece]; }
    /// Returns the angle by which the outward normal rotates where the piece begins (rad), positive where the body has
    /// a convex corner.
    double turn_before(std::size_t piece) const;
    /// Returns the piece at an arc length in [0, length()], which at a joint is the one behind it.
    std::size_t piece_at(double s) const;
    /// Returns an arc length modulo the length, in [0, length()).
    double reduced(double s) const;
    /// Returns points of all pieces in the order of travel.
    std::vector<SectionPoint> points() const;

   private:
    std::vector<OutlinePiece> pieces_;
    std::vector<double> begin_;
};

}  // namespace contactd::geometry
