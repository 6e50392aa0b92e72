// How far wheel and rail are from each other, seen from above: for each y the least vertical distance along the track.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/placement/rail_surface.hpp"
#include "geometry/placement/wheel_surface.hpp"

namespace contactd::geometry {

/// At one y of the track (mm). gap is that of a wheelset at z = 0: one lower by z has gap - z. Infinite where there is
/// no wheel or no rail, or where nobody looked, because it is too far away.
struct LocusRow {
    double y = 0, gap = 0;
    double x = 0;       ///< where along the track
    double rail_z = 0;  ///< of the rail there
    double rail_s = 0;  ///< of its profile
    double angle = 0;   ///< inclination of the rail (rad)
};

/// Rows that lie step apart, from the first point of the rail on. They are looked at where they may count only: the
/// first pass leaves out most of them.
class Locus {
   public:
    /// The wheel stands at z = 0. Both must live longer.
    Locus(const WheelSurface& wheel, const RailSurface& rail, double step);

    /// Has all rows looked at that may have a gap below `height`.
    void look_below(double height);
    const std::vector<LocusRow>& rows() const { return rows_; }
    /// Where the gap is `height` between two rows, of which the one inside has less, the neighbour outside not.
    LocusRow crossing(std::size_t inside, std::size_t outside, double height) const;
    double step() const { return step_; }
    double least_gap() const { return least_gap_; }  ///< infinite where no part of the wheel is above the rail

    /// Along x the gap grows by curvature() times the square of the distance (1/mm).
    double curvature() const;

   private:
    /// Where the rows that follow begin to look: parameters of both curves at y, and how they go on.
    struct Start {
        double y, wheel_s, rail_s;
        double wheel_slope = 0, rail_slope = 0;  // ds/dy
    };
    bool look(LocusRow& row, Start& start) const;
    void look_at(std::size_t row, Start& start);
    double dent(std::size_t begin, std::size_t end) const;
    double least_between(std::size_t begin) const;
    void look_between(std::size_t begin);
    Start start_at(std::size_t row) const { return {rows_[row].y, wheel_s_[row], rows_[row].rail_s}; }

    const WheelSurface& wheel_;
    const RailSurface& rail_;
    double step_, least_gap_;
    std::vector<LocusRow> rows_;
    std::vector<double> wheel_s_;  // of rows that have both
    std::vector<double> least_;    // gap that the spans of the first pass may have; infinite once they were looked at
};

}  // namespace contactd::geometry
