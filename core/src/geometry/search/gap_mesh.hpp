// Computes distances of wheel and rail, seen from above, on a mesh. This is for rails that curve along the track, for
// which the least distance of each y is not sufficient.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "contactd/observer.hpp"
#include "contactd/wheel_rail_solution.hpp"
#include "geometry/distance/node_mesh.hpp"
#include "geometry/placement/rail_surface.hpp"
#include "geometry/placement/wheel_surface.hpp"

namespace contactd::geometry {

/// Returns how far to both sides of the wheel's middle the rail may reach it (mm).
double reach_along(const WheelSurface& wheel);

/// Evaluates gaps on nodes, which lie on lines of equal x, at least an eighth of the wheel's radius to both sides of
/// it, and of equal y, from the first point of the rail on. Gaps are vertical distances of a wheelset at z = 0 (mm):
/// one lowered by z has gap - z. They are only evaluated where they may matter, in squares of nodes; the first pass
/// evaluates the corners.
class GapMesh {
   public:
    /// Describes a line of equal y: its position, and the rail's profile at x = 0 there.
    struct Row {
        double y = 0, rail_z = 0;
        double angle = 0;  ///< inclination of the rail (rad)
    };
    struct Node {
        std::size_t column, row;
    };
    /// Extends from its first node to its last one on both lines.
    struct Square {
        Node from, to;
    };

    /// The wheel stands at z = 0. All arguments must outlive this object. Steps are in mm. Throws InvalidArgument
    /// ("dx") for too many nodes, and here and later Cancelled if the observer, which is called before each row of
    /// squares, cancels.
    GapMesh(const WheelSurface& wheel, const RailSurface& rail, double step_x, double step_y, const Observer& observer);
    /// Uses separate nodes of the wheel, in the track (search_nodes.hpp). Lines of equal x correspond to the columns of
    /// these; lines of equal y begin at the third point of the rail's profile, and end at the third from its end.
    GapMesh(const WheelSurface& wheel, const RailSurface& rail, NodeMesh nodes, double step_y,
            const Observer& observer);

    /// Evaluates all nodes that may have a gap below `height`.
    void look_below(double height);
    double least_gap() const { return least_gap_; }  ///< infinite if no part of the wheel is above the rail

    std::size_t columns() const { return columns_; }
    const std::vector<Row>& rows() const { return rows_; }
    double x(std::size_t column) const { return first_x_ + static_cast<double>(column) * step_x_; }
    double y(std::size_t row) const { return rows_[row].y; }
    /// Returns the gap at a node. It is infinite if there is no wheel or no rail, or if it was not evaluated because it
    /// is too large.
    double gap(const Node& node) const { return gaps_[index(node)]; }
    std::size_t index(const Node& node) const { return node.row * columns_ + node.column; }
    double step_x() const { return step_x_; }
    double step_y() const { return step_y_; }

    /// Returns a square that contains all nodes that may have a gap below the height of the last evaluation.
    const Square& looked_at() const { return looked_at_; }

    /// Returns groups of connected nodes, also by corners, with a gap below z, which were evaluated, by descending y.
    /// On separate nodes of the wheel, groups whose boxes overlap or touch are connected, too.
    std::vector<std::vector<Node>> connected_below(double z) const;

   private:
    struct Lines {
        double first_x, step_x;
        std::size_t columns;
        double first_y, last_y, step_y;
    };
    GapMesh(const WheelSurface& wheel, const RailSurface& rail, const Lines& lines, std::optional<NodeMesh> nodes,
            const Observer& observer);
    static Lines lines_around(const WheelSurface& wheel, const RailSurface& rail, double step_x, double step_y);
    static Lines lines_of(const NodeMesh& nodes, const RailSurface& rail, double step_y);
    std::vector<double> wheel_heights_at(const ContactReference& plane, const Grid& columns, std::vector<double> y,
                                         double settled);
    void join_boxes(std::vector<std::vector<Node>>& parts) const;
    Square square(std::size_t column, std::size_t row) const;
    /// Returns the least gap. Heights are those of polynomials that have settled to this value (mm).
    double look_at(const Square& square, std::size_t every, double settled);
    /// Returns a lower bound of the gaps in the square, from those at its corners.
    double floor_of(const Square& square) const;
    std::vector<Node> spread(const Node& start, double z, std::vector<bool>& seen) const;

    const WheelSurface& wheel_;
    const RailSurface& rail_;
    const Observer& observer_;
    double step_x_, step_y_, first_x_;
    std::size_t columns_;
    std::optional<NodeMesh> nodes_;
    std::vector<Row> rows_;
    std::vector<double> gaps_;
    std::vector<double> floors_;  // bounds of squares, by rows of them; infinite for evaluated ones
    Square looked_at_{{static_cast<std::size_t>(-1), static_cast<std::size_t>(-1)},
                      {0, 0}};  // around all evaluated squares
    double least_gap_;
};

}  // namespace contactd::geometry
