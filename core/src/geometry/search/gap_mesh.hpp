// How far wheel and rail are from each other, seen from above, on a mesh: for rails that curve along the track, of
// which the least distance of each y tells too little.
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

/// Nodes lie on lines of equal x, an eighth of the wheel's radius and more to both sides of it, and of equal y, from
/// the first point of the rail on. Gaps are vertical distances of a wheelset at z = 0 (mm): one lower by z has gap - z.
/// They are looked at where they may count only, in squares of nodes: the first pass takes the corners.
class GapMesh {
   public:
    /// A line of equal y: where it is, and the rail's profile at x = 0 there.
    struct Row {
        double y = 0, rail_z = 0;
        double angle = 0;  ///< inclination of the rail (rad)
    };
    struct Node {
        std::size_t column, row;
    };
    /// Reaches from its first node to its last one on both lines.
    struct Square {
        Node from, to;
    };

    /// The wheel stands at z = 0. All must live longer. Steps in mm. Throws InvalidArgument ("dx") for nodes that are
    /// too many, and here and later Cancelled when the observer, which is asked before each row of squares, says so.
    GapMesh(const WheelSurface& wheel, const RailSurface& rail, double step_x, double step_y, const Observer& observer);
    /// Takes the wheel by nodes of its own, in the track (search_nodes.hpp). Lines of equal x are as many as columns of
    /// these, and reach as far; those of equal y begin at the third point of the rail's profile, and end with the third
    /// from its end.
    GapMesh(const WheelSurface& wheel, const RailSurface& rail, NodeMesh nodes, double step_y,
            const Observer& observer);

    /// Has all nodes looked at that may have a gap below `height`.
    void look_below(double height);
    double least_gap() const { return least_gap_; }  ///< infinite where no part of the wheel is above the rail

    std::size_t columns() const { return columns_; }
    const std::vector<Row>& rows() const { return rows_; }
    double x(std::size_t column) const { return first_x_ + static_cast<double>(column) * step_x_; }
    double y(std::size_t row) const { return rows_[row].y; }
    /// Infinite where there is no wheel or no rail, or where nobody looked, because it is too far away.
    double gap(const Node& node) const { return gaps_[index(node)]; }
    std::size_t index(const Node& node) const { return node.row * columns_ + node.column; }
    double step_x() const { return step_x_; }
    double step_y() const { return step_y_; }

    /// Nodes that may have a gap below the height that was looked below last lie in it.
    const Square& looked_at() const { return looked_at_; }

    /// Connected nodes, also by corners, with a gap below z, which were looked at; by descending y. On nodes of the
    /// wheel's own those whose boxes overlap or touch are connected, too.
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
    /// Returns the least gap. Heights are those of polynomials that have settled so far (mm).
    double look_at(const Square& square, std::size_t every, double settled);
    /// Returns what no gap in the square is below, by those at its corners.
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
    std::vector<double> floors_;  // of squares, by rows of them; infinite of those that were looked at
    Square looked_at_{{static_cast<std::size_t>(-1), static_cast<std::size_t>(-1)}, {0, 0}};  // around all of these
    double least_gap_;
};

}  // namespace contactd::geometry
