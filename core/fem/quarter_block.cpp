#include "quarter_block.hpp"

#include <algorithm>

namespace contactd::fem {
namespace {

/// Numbers of vertices: the box's first, then shell by shell.
class VertexNumbers {
   public:
    explicit VertexNumbers(int m) : n_(m + 1), on_surface_(static_cast<std::size_t>(n_) * n_ * n_, -1) {
        for (int x = 0; x < n_; ++x)
            for (int y = 0; y < n_; ++y)
                for (int z = 0; z < n_; ++z)
                    if (std::max({x, y, z}) == m) on_surface_[at({x, y, z})] = surface_size_++;
    }
    int operator()(const Vertex& vertex) const {
        const std::size_t place = at(vertex.index);
        if (vertex.shell == 0) return static_cast<int>(place);
        return n_ * n_ * n_ + (vertex.shell - 1) * surface_size_ + on_surface_[place];
    }

   private:
    std::size_t at(const std::array<int, 3>& index) const {
        return static_cast<std::size_t>((index[0] * n_ + index[1]) * n_ + index[2]);
    }
    int n_;
    int surface_size_ = 0;
    std::vector<int> on_surface_;
};

void add_vertices(mfem::Mesh& mesh, const Shells& shells) {
    const auto add = [&](const Vertex& vertex) {
        const auto [X, Y, Z] = position(shells, vertex);
        mesh.AddVertex(-X, -Y, -Z);
    };
    const int m = shells.m;
    for (int shell = 0; shell <= shells.k; ++shell)
        for (int x = 0; x <= m; ++x)
            for (int y = 0; y <= m; ++y)
                for (int z = 0; z <= m; ++z)
                    if (shell == 0 || std::max({x, y, z}) == m) add({shell, {x, y, z}});
}

void add_element(mfem::Mesh& mesh, const Shells& shells, const VertexNumbers& number, const Place& place) {
    // Sides along X, Y, Z of the corners in MFEM's order, (xi, eta, zeta) = (Y, X, Z).
    static constexpr std::array<std::array<int, 3>, 8> sides{
        {{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}}};
    std::array<int, 8> vertices;
    std::transform(sides.begin(), sides.end(), vertices.begin(),
                   [&](const auto& side) { return number(corner(shells, place, side)); });
    mesh.AddHex(vertices.data());
}

void add_elements(mfem::Mesh& mesh, const Shells& shells) {
    const VertexNumbers number(shells.m);
    const int m = shells.m;
    for (int x = 0; x < m; ++x)
        for (int y = 0; y < m; ++y)
            for (int z = 0; z < m; ++z) add_element(mesh, shells, number, {0, 0, {x, y, z}});
    for (int layer = 1; layer <= shells.k; ++layer)
        for (int i = 0; i < 3 * m * m; ++i) {
            const int face = i / (m * m), first = i / m % m, second = i % m;
            Place place{layer, face, {first, second, second}};
            if (face == 0) place.index = {0, first, second};
            if (face == 1) place.index = {first, 0, second};
            if (face == 2) place.index = {first, second, 0};
            add_element(mesh, shells, number, place);
        }
}

BoundaryPart boundary_part(const mfem::Mesh& mesh, const Shells& shells, int boundary_element) {
    mfem::Array<int> vertices;
    mesh.GetBdrElementVertices(boundary_element, vertices);
    std::array<double, 3> farthest{};  // from the origin along each axis
    for (const int vertex : vertices)
        for (std::size_t a = 0; a < 3; ++a)
            farthest[a] = std::max(farthest[a], -mesh.GetVertex(vertex)[static_cast<int>(a)]);
    if (farthest[0] == 0) return BoundaryPart::front;
    if (farthest[1] == 0) return BoundaryPart::right;
    if (farthest[2] != 0) return BoundaryPart::far;
    const auto under_load = [&](std::size_t a) {
        const double end = shells.edge[a][0] * shells.load_elements[a] / shells.m;
        return farthest[a] <= end * (1 + 1e-12);
    };
    return under_load(0) && under_load(1) ? BoundaryPart::loaded : BoundaryPart::free;
}

}  // namespace

mfem::Mesh make_quarter_block(const Shells& shells) {
    mfem::Mesh mesh(3, static_cast<int>(shells.vertices()), static_cast<int>(shells.elements()));
    add_vertices(mesh, shells);
    add_elements(mesh, shells);
    mesh.FinalizeTopology();  // makes the boundary elements
    for (int i = 0; i < mesh.GetNBE(); ++i) mesh.SetBdrAttribute(i, static_cast<int>(boundary_part(mesh, shells, i)));
    mesh.SetAttributes();
    // Neither refinement nor a correction of orientations may reorder the elements: element_number() counts on it.
    mesh.Finalize(false, false);
    return mesh;
}

mfem::IntegrationPoint reference_point(const SurfacePoint& point) {
    mfem::IntegrationPoint result;
    result.Set3(point.local[1], point.local[0], point.local[2]);
    return result;
}

}  // namespace contactd::fem
