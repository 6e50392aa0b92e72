#include "tensor_block.hpp"

namespace contactd::fem {
BlockMesh make_tensor_block(const std::array<std::vector<double>, 3>& planes, const std::array<double, 2>& load) {
    std::array<int, 3> n;  // intervals
    for (std::size_t a = 0; a < 3; ++a) n[a] = static_cast<int>(planes[a].size()) - 1;
    const int vertices = (n[0] + 1) * (n[1] + 1) * (n[2] + 1);
    BlockMesh block{mfem::Mesh(3, vertices, n[0] * n[1] * n[2]), {}};
    for (const double X : planes[0])
        for (const double Y : planes[1])
            for (const double Z : planes[2]) block.mesh.AddVertex(-X, -Y, -Z);
    const auto vertex = [n](int x, int y, int z) { return (x * (n[1] + 1) + y) * (n[2] + 1) + z; };
    for (int x = 0; x < n[0]; ++x)
        for (int y = 0; y < n[1]; ++y)
            for (int z = 0; z < n[2]; ++z)
                // As in the shells: xi along Y, eta along X, zeta along Z, so that the Jacobian is positive.
                block.mesh.AddHex(vertex(x, y, z), vertex(x, y + 1, z), vertex(x + 1, y + 1, z), vertex(x + 1, y, z),
                                  vertex(x, y, z + 1), vertex(x, y + 1, z + 1), vertex(x + 1, y + 1, z + 1),
                                  vertex(x + 1, y, z + 1));
    block.mesh.FinalizeTopology();
    mark_boundary(block.mesh, load);
    block.mesh.Finalize(false, false);
    block.locate = [planes, n](double X, double Y) {
        const auto [x, along_x] = find_interval(planes[0], X);
        const auto [y, along_y] = find_interval(planes[1], Y);
        ElementPoint result{(x * n[1] + y) * n[2], {}};
        result.point.Set3(along_y, along_x, 0);
        return result;
    };
    return block;
}

}  // namespace contactd::fem
