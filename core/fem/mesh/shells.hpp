// Describes the geometry of Mesh1 (paper, section 3.1): a uniform box under the load and shells of graded frusta around
// it. Does not depend on MFEM. Lengths X, Y, Z are distances from the origin into the quarter block [-L,0]^3, so they
// are positive: X = -x and so on.
#pragma once

#include <array>
#include <vector>

#include "contactd/fem/ic_builder.hpp"

namespace contactd::fem {

/// Shell j is the surface of the box edge[0][j] x edge[1][j] x edge[2][j]; shell 0 is that of the uniform box. Each of
/// its three faces is divided into m x m. The hexahedra between shells j-1 and j form layer j.
struct Shells {
    int m = 0;                                ///< elements per edge of the box and of every shell
    int k = 0;                                ///< layers
    std::array<std::vector<double>, 3> edge;  ///< k+1 edges of the shells along each axis

    long long elements() const { return 1LL * m * m * (m + 3LL * k); }
    long long vertices() const { return 1LL * (m + 1) * (m + 1) * (m + 1) + 1LL * k * surface_vertices(); }
    long long surface_vertices() const { return 1LL * (m + 1) * (m + 1) * (m + 1) - 1LL * m * m * m; }
};

Shells make_shells(const IcSpec& spec);

/// Identifies an element by its place. In the box, `layer` is 0 and `index` counts along the axes. In layer j >= 1, the
/// element belongs to the frustum beyond the face normal to axis `face`, and index[face] is unused.
struct ElementPosition {
    int layer = 0;
    int face = 0;
    std::array<int, 3> index{};
};

/// Elements are numbered from the origin outwards: the box, then layer by layer.
int element_number(const Shells& shells, const ElementPosition& place);

/// Identifies a corner of an element, or any vertex: its shell (0 represents the whole box) and its position on it,
/// 0..m along each axis.
struct Vertex {
    int shell = 0;
    std::array<int, 3> index{};
};
/// `side[a]` is 0 for the corner nearer to the origin along axis a, 1 for the farther one.
Vertex corner(const Shells& shells, const ElementPosition& place, const std::array<int, 3>& side);
std::array<double, 3> position(const Shells& shells, const Vertex& vertex);  ///< X, Y, Z

/// Holds the element that contains the surface point (X, Y, 0), and the point's coordinates in it: `local[a]` runs from
/// 0 at the corners with side[a] = 0 to 1. The element map on the surface is bilinear with parallel straight edges, so
/// this is its exact inverse. A point on a shared face always gets the same element. X and Y must lie inside the block.
struct SurfacePoint {
    ElementPosition place;
    std::array<double, 3> local{};
};
SurfacePoint locate(const Shells& shells, double X, double Y);

}  // namespace contactd::fem
