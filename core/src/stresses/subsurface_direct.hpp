// The tractions of a contact as subsurface stresses need them, and their stresses point by point.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "contactd/grid.hpp"
#include "contactd/subsurface.hpp"
#include "subsurface_raster.hpp"

namespace contactd {

/// Where rows of elements end along y: with the grid, or nowhere, in plane strain.
enum class RowEnds { grid, nowhere };

/// The smallest rectangle of elements that holds all tractions. Rows that end nowhere have an infinite dy about y = 0.
class LoadedPatch {
   public:
    LoadedPatch(const Grid& grid, const SurfaceTractions& tractions, RowEnds ends = RowEnds::grid);

    int nx() const { return loads_[0].nx; }
    int ny() const { return loads_[0].ny; }
    double x() const { return grid_.x(first_x_); }  ///< centre of the first element
    double y() const { return ends_ == RowEnds::grid ? grid_.y(first_y_) : 0; }
    /// Where stresses are infinite, those at this distance are given.
    double smallest() const { return 1e-6 * std::min(grid_.dx, grid_.dy); }
    /// Along x, y and z; values are empty where all are zero.
    const std::array<TractionPatch, 3>& loads() const { return loads_; }

   private:
    Grid grid_;
    RowEnds ends_;
    int first_x_, first_y_;
    std::array<TractionPatch, 3> loads_;
};

/// A corner of elements, and the second difference of the tractions there.
struct LoadedCorner {
    double x, y;
    std::array<double, 3> jump;
};

/// Finds the corners where that is not zero.
std::vector<LoadedCorner> corners_of(const LoadedPatch& patch);

/// Sums over corners: what a corner adds to its four elements is one product with the second difference of the
/// tractions, and inside a region of equal tractions none.
template <class Field>
class DirectSum {
   public:
    DirectSum(const Field& field, const LoadedPatch& patch) : field_(field), corners_(corners_of(patch)) {}

    const Field& field() const { return field_; }
    std::size_t corners() const { return corners_.size(); }
    typename Field::Components at(double x, double y, double z) const {
        typename Field::Components sum{};
        for (const LoadedCorner& corner : corners_)
            for (const Axis load : {Axis::x, Axis::y, Axis::z}) {
                const double jump = corner.jump[static_cast<std::size_t>(load)];
                if (jump == 0) continue;
                const auto part = field_.at_corner(load, x - corner.x, y - corner.y, -z);
                for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += jump * part[c];
            }
        return sum;
    }

   private:
    const Field field_;
    const std::vector<LoadedCorner> corners_;
};

}  // namespace contactd
