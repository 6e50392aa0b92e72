// A surface that is known at nodes only.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "geometry/distance/heights.hpp"
#include "geometry/placement/vector3.hpp"

namespace contactd::geometry {

/// Returns the number of lines across a mesh. Throws InvalidArgument ("dx") where such a mesh has more than four
/// million nodes (96 MB), of which none must be made before.
std::size_t lines_within_bound(double columns, std::size_t rows);

/// Nodes in columns and rows, seen along z: x of each row ascends with the columns, and y of each column with the rows.
/// A point lies in a cell at shares u and v of its sides, by which the cell's corners make x and y of it.
class NodeMesh {
   public:
    /// Between nodes z is bilinear in u and v; or it is a cubic in both, with the slopes at a node that its neighbours
    /// have, and at a border those of the last side.
    enum class Between { straight, cubic };

    /// Takes two columns and two rows at least; nodes row by row.
    NodeMesh(std::size_t columns, std::vector<Vector3> nodes, Between between);

    std::size_t columns() const { return columns_; }
    std::size_t rows() const { return rows_; }
    const Vector3& node(std::size_t column, std::size_t row) const { return nodes_[row * columns_ + column]; }

    /// Returns z at a point; no_height beside the mesh. The search begins in the cell that was found last.
    double height(double x, double y);

   private:
    struct Shares {
        double u, v;
    };
    using Weights = std::array<double, 4>;  // of the nodes -1, 0, 1, 2 of a cell along a direction

    Shares inside_cell(double x, double y) const;
    double value(const Shares& at) const;
    Weights weights(double share, std::size_t cell, std::size_t count) const;
    void start_at(double x, double y);

    std::size_t columns_, rows_;
    std::vector<Vector3> nodes_;
    Between between_;
    std::size_t column_ = 0, row_ = 0;  // of the cell found last
};

}  // namespace contactd::geometry
