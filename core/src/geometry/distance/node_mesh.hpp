// Represents a surface that is known only at nodes.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "geometry/distance/heights.hpp"
#include "geometry/placement/vector3.hpp"

namespace contactd::geometry {

/// Returns the number of lines across a mesh. Throws InvalidArgument ("dx") before nodes are created if the mesh would
/// have more than four million (96 MB).
std::size_t lines_within_bound(double columns, std::size_t rows);

/// Holds nodes in columns and rows, seen along z: x of each row ascends with the columns, and y of each column with the
/// rows. A point lies in a cell at fractions u and v of its sides, from which the cell's corners determine x and y.
class NodeMesh {
   public:
    /// Between nodes, z is bilinear or cubic in u and v. The cubic has slopes at a node from its neighbours, and at a
    /// border those of the last side.
    enum class Between { straight, cubic };

    /// Takes at least two columns and two rows; nodes are in the order of rows.
    NodeMesh(std::size_t columns, std::vector<Vector3> nodes, Between between);

    std::size_t columns() const { return columns_; }
    std::size_t rows() const { return rows_; }
    const Vector3& node(std::size_t column, std::size_t row) const { return nodes_[row * columns_ + column]; }

    /// Returns z at a point, or no_height beside the mesh. The search begins in the last cell found.
    double height(double x, double y);

   private:
    struct Shares {
        double u, v;
    };
    using Weights = std::array<double, 4>;  // for the nodes -1, 0, 1, 2 of a cell along a direction

    Shares inside_cell(double x, double y) const;
    double value(const Shares& at) const;
    Weights weights(double share, std::size_t cell, std::size_t count) const;
    void start_at(double x, double y);

    std::size_t columns_, rows_;
    std::vector<Vector3> nodes_;
    Between between_;
    std::size_t column_ = 0, row_ = 0;  // last cell found
};

}  // namespace contactd::geometry
