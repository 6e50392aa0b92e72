// How far wheel and rail are from each other, seen from above: for each y the least vertical distance along the track.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "contactd/observer.hpp"
#include "contactd/wheel_rail_solution.hpp"
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
    double rise = 0;    ///< of the rail: dz/dy
    double angle = 0;   ///< inclination of the rail (rad), of which rise is the tangent
};

/// Rows that lie step apart, from the first point of the rail on. They are looked at where they may count only: the
/// first pass leaves out most of them.
class Locus {
   public:
    /// The wheel stands at z = 0. All must live longer. Throws InvalidArgument ("patches.locus_step") for rows that are
    /// too many, and here and later Cancelled when the observer, which is asked span by span, says so.
    Locus(const WheelSurface& wheel, const RailSurface& rail, double step, const Observer& observer);

    /// Has all rows looked at that may have a gap below `height`.
    void look_below(double height);
    const std::vector<LocusRow>& rows() const { return rows_; }
    std::span<const LocusRow> rows_within(const Extent& y) const;
    /// Where the gap is `height` between two rows, of which the one inside has less, the neighbour outside not.
    LocusRow crossing(std::size_t inside, std::size_t outside, double height) const;
    double step() const { return step_; }
    double least_gap() const { return least_gap_; }  ///< infinite where no part of the wheel is above the rail

    /// Along x the gap grows by curvature() times the square of the distance (1/mm).
    double curvature() const;

   private:
    /// The parameter of a curve at the last row, and how it goes on.
    struct Trace {
        double s;
        double slope = 0, bend = 0;  // ds/dy, and that of slope

        double ahead(double step) const { return s + step * (slope + 0.5 * step * bend); }
        void go_on(double step, double to, double new_slope) {
            bend = slope > 0 ? (new_slope - slope) / step : 0;
            slope = new_slope;
            s = to;
        }
    };
    /// Where the row that follows begins to look.
    struct Start {
        double y;
        Trace wheel, rail;
    };
    bool look(LocusRow& row, Start& start) const;
    void look_at(std::size_t row, Start& start);
    double dent(std::size_t begin, std::size_t end) const;
    double least_between(std::size_t begin) const;
    void look_between(std::size_t begin);
    /// Beyond the first and the last one rows have no gap.
    LocusRow row_at(std::size_t row) const {
        return row < rows_.size() ? rows_[row] : LocusRow{0, std::numeric_limits<double>::infinity()};
    }
    Start start_at(std::size_t row) const { return {rows_[row].y, {wheel_s_[row]}, {rows_[row].rail_s}}; }

    const WheelSurface& wheel_;
    const RailSurface& rail_;
    const Observer& observer_;
    double step_, least_gap_;
    std::vector<LocusRow> rows_;
    std::vector<double> wheel_s_;  // of rows that have both
    std::vector<double> least_;    // gap that the spans of the first pass may have; infinite once they were looked at
};

}  // namespace contactd::geometry
