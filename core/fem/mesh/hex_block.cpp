#include "hex_block.hpp"

#include <algorithm>

#include "shells.hpp"

namespace contactd::fem {
namespace {

/// Numbers the vertices: those of the box first, then shell by shell.
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

void add_element(mfem::Mesh& mesh, const Shells& shells, const VertexNumbers& number, const ElementPosition& place) {
    // Lists the sides along X, Y, Z of the corners in MFEM's order, (xi, eta, zeta) = (Y, X, Z). Two axes are swapped,
    // because the quarter block is the mirror image of the positive octant.
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
            ElementPosition place{layer, face, {first, second, second}};
            if (face == 0) place.index = {0, first, second};
            if (face == 1) place.index = {first, 0, second};
            if (face == 2) place.index = {first, second, 0};
            add_element(mesh, shells, number, place);
        }
}

}  // namespace

BlockMesh make_hex_block(const IcSpec& spec) {
    const Shells shells = make_shells(spec);
    BlockMesh block{mfem::Mesh(3, static_cast<int>(shells.vertices()), static_cast<int>(shells.elements())), {}};
    add_vertices(block.mesh, shells);
    add_elements(block.mesh, shells);
    block.mesh.FinalizeTopology();  // makes the boundary elements
    mark_boundary(block.mesh, load_extent(spec));
    // Neither refinement nor a correction of orientations may reorder the elements, because element_number() depends on
    // the order.
    block.mesh.Finalize(false, false);
    block.locate = [shells](double X, double Y) {
        const SurfacePoint at = contactd::fem::locate(shells, X, Y);
        ElementPoint result{element_number(shells, at.place), {}};
        result.point.Set3(at.local[1], at.local[0], at.local[2]);  // xi along Y, eta along X
        return result;
    };
    return block;
}

}  // namespace contactd::fem
