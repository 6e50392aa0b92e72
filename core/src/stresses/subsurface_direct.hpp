// Prepares the tractions of a contact for subsurface stresses, and computes these point by point.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "contactd/grid.hpp"
#include "contactd/subsurface.hpp"
#include "subsurface_raster.hpp"

namespace contactd {

/// Selects the ends of rows of elements along y: at the grid, or nowhere, in plane strain.
enum class RowEnds { grid, nowhere };

/// Holds the smallest rectangle of elements that contains all tractions. Rows without ends have an infinite dy about y
/// = 0.
class LoadedPatch {
   public:
    LoadedPatch(const Grid& grid, const SurfaceTractions& tractions, RowEnds ends = RowEnds::grid);

    int nx() const { return loads_[0].nx; }
    int ny() const { return loads_[0].ny; }
    double x() const { return grid_.x(first_x_); }  ///< centre of the first element
    double y() const { return ends_ == RowEnds::grid ? grid_.y(first_y_) : 0; }
    /// Returns the distance at which stresses are evaluated where they are infinite.
    double smallest() const { return 1e-6 * std::min(grid_.dx, grid_.dy); }
    /// Returns the loads along x, y and z. Values are empty if all are zero.
    const std::array<TractionPatch, 3>& loads() const { return loads_; }

   private:
    Grid grid_;
    RowEnds ends_;
    int first_x_, first_y_;
    std::array<TractionPatch, 3> loads_;
};

/// Holds a corner of elements, and the second difference of the tractions there.
struct LoadedCorner {
    double x, y;
    std::array<double, 3> jump;
};

/// Returns the corners where the second difference is not zero.
std::vector<LoadedCorner> corners_of(const LoadedPatch& patch);

/// Sums over corners. The contribution of a corner to its four elements is one product with the second difference of
/// the tractions, which vanishes inside a region of equal tractions.
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
