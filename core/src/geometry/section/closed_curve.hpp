// A closed curve by its arc length.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "geometry/section/outline_piece.hpp"

namespace contactd::geometry {

class ClosedCurve {
   public:
    /// Throws InvalidArgument below `field` when it is not closed, or as its pieces do.
    ClosedCurve(const Outline& outline, const std::string& field);

    double length() const { return begin_.back(); }
    /// The place at any arc length, modulo its length. Where two pieces meet, that behind the joint.
    OutlinePlace place(double s) const;

    const std::vector<OutlinePiece>& pieces() const { return pieces_; }
    /// Arc length at which a piece begins; begin_of(pieces().size()) is the length.
    double begin_of(std::size_t piece) const { return begin_[piece]; }
    /// By which the outward normal turns where the piece begins (rad), positive where the body has a convex corner.
    double turn_before(std::size_t piece) const;
    /// The piece at an arc length in [0, length()]; that behind a joint.
    std::size_t piece_at(double s) const;
    /// An arc length modulo the length, in [0, length()).
    double reduced(double s) const;
    /// Points of all pieces in the order of travel.
    std::vector<SectionPoint> points() const;

   private:
    std::vector<OutlinePiece> pieces_;
    std::vector<double> begin_;
};

}  // namespace contactd::geometry
