// Describes positions of slices along the track or round a wheel.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace contactd::geometry {

/// Holds at least two ascending knots. With a period the first one follows the last one. The piece i lies between the
/// knots i and i + 1. With a period, knots and pieces may have any index, otherwise only existing ones.
class KnotsAlong {
   public:
    explicit KnotsAlong(std::vector<double> knots, double period = 0) : knots_(std::move(knots)), period_(period) {}

    const std::vector<double>& all() const { return knots_; }
    std::size_t size() const { return knots_.size(); }
    double period() const { return period_; }

    std::size_t wrapped(std::ptrdiff_t knot) const;
    double place(std::ptrdiff_t knot) const;
    double width(std::ptrdiff_t piece) const { return place(piece + 1) - place(piece); }
    bool exists(std::ptrdiff_t piece) const {
        return period_ > 0 || (piece >= 0 && piece + 1 < static_cast<std::ptrdiff_t>(knots_.size()));
    }
    std::size_t next(std::size_t knot) const { return (knot + 1) % knots_.size(); }

    /// Returns how well the knots on both sides describe the values within a piece: 1 if it is at most twice as wide as
    /// the wider neighbour, 0 if it is four times as wide.
    double support(std::ptrdiff_t piece) const;

   private:
    std::vector<double> knots_;
    double period_;
};

}  // namespace contactd::geometry
