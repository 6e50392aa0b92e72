// Computes distances of wheel and rail, seen from above: for each y the least vertical distance along the track.
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

/// Describes the distance at one y of the track (mm). gap is that of a wheelset at z = 0: one lowered by z has gap - z.
/// It is infinite if there is no wheel or no rail, or if it was not evaluated because it is too large.
struct LocusRow {
    double y = 0, gap = 0;
    double x = 0;       ///< position along the track
    double rail_z = 0;  ///< z of the rail there
    double rail_s = 0;  ///< s of its profile there
    double rise = 0;    ///< slope of the rail: dz/dy
    double angle = 0;   ///< inclination of the rail (rad), of which rise is the tangent
};

/// Holds rows at a distance of `step`, from the first point of the rail on. They are only evaluated where they may
/// matter; the first pass omits most of them.
class Locus {
   public:
    /// The wheel stands at z = 0. All arguments must outlive this object. Throws InvalidArgument ("patches.locus_step")
    /// for too many rows, and here and later Cancelled if the observer, which is called for each span, cancels.
    Locus(const WheelSurface& wheel, const RailSurface& rail, double step, const Observer& observer);

    /// Evaluates all rows that may have a gap below `height`.
    void look_below(double height);
    const std::vector<LocusRow>& rows() const { return rows_; }
    std::span<const LocusRow> rows_within(const Extent& y) const;
    /// Returns the point between two rows where the gap is `height`; the row inside has less, the neighbour outside
    /// does not.
    LocusRow crossing(std::size_t inside, std::size_t outside, double height) const;
    double step() const { return step_; }
    double least_gap() const { return least_gap_; }  ///< infinite if no part of the wheel is above the rail

    /// Returns the factor of the square of the distance along x with which the gap increases (1/mm).
    double curvature() const;

   private:
    /// Holds the parameter of a curve at the last row, and its derivatives.
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
    /// Describes the start of the search for the next row.
    struct Start {
        double y;
        Trace wheel, rail;
    };
    bool look(LocusRow& row, Start& start) const;
    void look_at(std::size_t row, Start& start);
    double dent(std::size_t begin, std::size_t end) const;
    double least_between(std::size_t begin) const;
    void look_between(std::size_t begin);
    /// Returns a row; beyond the first and the last one, rows have no gap.
    LocusRow row_at(std::size_t row) const {
        return row < rows_.size() ? rows_[row] : LocusRow{0, std::numeric_limits<double>::infinity()};
    }
    Start start_at(std::size_t row) const { return {rows_[row].y, {wheel_s_[row]}, {rows_[row].rail_s}}; }

    const WheelSurface& wheel_;
    const RailSurface& rail_;
    const Observer& observer_;
    double step_, least_gap_;
    std::vector<LocusRow> rows_;
    std::vector<double> wheel_s_;  // values of rows with both bodies
    std::vector<double> least_;    // lower bound of the gap in spans of the first pass; infinite for evaluated ones
};

}  // namespace contactd::geometry
