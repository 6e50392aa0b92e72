#include "prism_block.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "shells.hpp"

namespace contactd::fem {
namespace {

/// Corners of a quadrilateral of the cross-section, as numbers of vertices. The first is nearest to the origin, the
/// others follow counterclockwise with Y to the right and Z up, so the third is the farthest.
using Cell = std::array<int, 4>;
using Triangle = std::array<int, 3>;

/// Numbers the cross-section x = const: (m+1)^2 vertices of the square, then 2m+1 of each shell along the path from the
/// surface down its side and along its bottom to z = -edge, y = 0.
struct CrossSection {
    std::vector<std::array<double, 2>> vertices;  ///< (Y, Z)
    std::vector<Triangle> triangles;  ///< cells from the origin outwards, two triangles each, counterclockwise
};

/// Shell 0 is the edge of the square.
int vertex_on_path(int m, int shell, int step) {
    if (shell > 0) return (m + 1) * (m + 1) + (shell - 1) * (2 * m + 1) + step;
    return step <= m ? m * (m + 1) + step : (2 * m - step) * (m + 1) + m;
}

std::vector<std::array<double, 2>> make_vertices(const Shells& shells) {
    const int m = shells.m;
    std::vector<std::array<double, 2>> result;
    const auto add = [&](int shell, int y, int z) {
        const auto j = static_cast<std::size_t>(shell);
        result.push_back({shells.edge[1][j] * y / m, shells.edge[2][j] * z / m});
    };
    for (int y = 0; y <= m; ++y)
        for (int z = 0; z <= m; ++z) add(0, y, z);
    for (int shell = 1; shell <= shells.k; ++shell)
        for (int step = 0; step <= 2 * m; ++step) add(shell, std::min(m, 2 * m - step), std::min(m, step));
    return result;
}

/// The surface z = 0 contains the first two corners of the first cell of each column of the square, and of the first
/// cell of each layer.
std::vector<Cell> make_cells(int m, int k) {
    std::vector<Cell> cells;
    const auto in_square = [&](int y, int z) { return y * (m + 1) + z; };
    for (int y = 0; y < m; ++y)
        for (int z = 0; z < m; ++z)
            cells.push_back({in_square(y, z), in_square(y + 1, z), in_square(y + 1, z + 1), in_square(y, z + 1)});
    for (int layer = 1; layer <= k; ++layer)
        for (int step = 0; step < 2 * m; ++step) {
            const int inner = vertex_on_path(m, layer - 1, step), inner_next = vertex_on_path(m, layer - 1, step + 1);
            const int outer = vertex_on_path(m, layer, step), outer_next = vertex_on_path(m, layer, step + 1);
            if (step < m)
                cells.push_back({inner, outer, outer_next, inner_next});
            else  // Along the bottom, the path returns towards y = 0.
                cells.push_back({inner_next, inner, outer, outer_next});
        }
    return cells;
}

CrossSection make_cross_section(const Shells& shells, Diagonal diagonal) {
    CrossSection result{make_vertices(shells), {}};
    for (const auto& [a, b, c, d] : make_cells(shells.m, shells.k))
        if (diagonal == Diagonal::outward)
            result.triangles.insert(result.triangles.end(), {{a, b, c}, {a, c, d}});
        else
            result.triangles.insert(result.triangles.end(), {{a, b, d}, {b, c, d}});
    return result;
}

/// Returns positions of the grid lines of the surface along an axis: m intervals of the square, k growing ones.
std::vector<double> make_lines(const Shells& shells, std::size_t axis) {
    const std::vector<double>& edge = shells.edge[axis];
    std::vector<double> lines;
    for (int i = 0; i < shells.m; ++i) lines.push_back(edge[0] * i / shells.m);
    lines.insert(lines.end(), edge.begin(), edge.end());
    return lines;
}

mfem::Mesh extrude(const CrossSection& section, const std::vector<double>& X, const std::array<double, 2>& load) {
    const auto count = static_cast<int>(section.vertices.size());
    const auto slices = static_cast<int>(X.size()) - 1;
    mfem::Mesh mesh(3, count * (slices + 1), static_cast<int>(section.triangles.size()) * slices);
    for (const double x : X)
        for (const auto& [y, z] : section.vertices) mesh.AddVertex(-x, -y, -z);
    for (int slice = 0; slice < slices; ++slice)
        for (const auto& [a, b, c] : section.triangles) {
            const int near = slice * count, far = near + count;
            // Vertices are clockwise in (Y, Z), because the extrusion runs towards negative x.
            mesh.AddWedge(near + a, near + c, near + b, far + a, far + c, far + b);
        }
    mesh.FinalizeTopology();  // makes the boundary elements
    mark_boundary(mesh, load);
    // Neither refinement nor a correction of orientations may reorder the elements, because locate() depends on the
    // order.
    mesh.Finalize(false, false);
    return mesh;
}

}  // namespace

BlockMesh make_prism_block(const IcSpec& spec) {
    const Shells shells = make_shells(spec);
    const CrossSection section = make_cross_section(shells, spec.fem.diagonal);
    const std::vector<double> x_lines = make_lines(shells, 0), y_lines = make_lines(shells, 1);

    BlockMesh result;
    result.mesh = extrude(section, x_lines, load_extent(spec));
    const auto triangles = static_cast<int>(section.triangles.size());
    result.locate = [=, m = shells.m](double X, double Y) {
        const Interval x = find_interval(x_lines, X), y = find_interval(y_lines, Y);
        const int cell = y.number < m ? y.number * m : m * m + (y.number - m) * 2 * m;
        // The first triangle of a surface cell has both corners on the surface: the wedge's first vertex and its third.
        ElementPoint point;
        point.element = x.number * triangles + 2 * cell;
        point.point.Init(0);
        point.point.Set3(0, y.local, x.local);
        return point;
    };
    return result;
}

}  // namespace contactd::fem
