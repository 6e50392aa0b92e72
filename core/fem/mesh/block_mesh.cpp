#include "block_mesh.hpp"

#include <algorithm>

#include "contactd/error.hpp"

#include "hex_block.hpp"
#include "prism_block.hpp"

namespace contactd::fem {
namespace {

BoundaryPart boundary_part(const mfem::Mesh& mesh, int boundary_element, const std::array<double, 2>& load) {
    mfem::Array<int> vertices;
    mesh.GetBdrElementVertices(boundary_element, vertices);
    std::array<double, 3> farthest{};  // from the origin along each axis
    for (const int vertex : vertices)
        for (std::size_t a = 0; a < 3; ++a)
            farthest[a] = std::max(farthest[a], -mesh.GetVertex(vertex)[static_cast<int>(a)]);
    if (farthest[0] == 0) return BoundaryPart::front;
    if (farthest[1] == 0) return BoundaryPart::right;
    if (farthest[2] != 0) return BoundaryPart::far;
    constexpr double rounding = 1 + 1e-12;
    return farthest[0] <= load[0] * rounding && farthest[1] <= load[1] * rounding ? BoundaryPart::loaded
                                                                                  : BoundaryPart::free;
}

}  // namespace

Interval find_interval(const std::vector<double>& lines, double position) {
    // The search includes both ends: the offset (1,0) is on a line if l = h, and the last line, L, belongs to the
    // block.
    const auto upper =
        std::clamp(std::lower_bound(lines.begin(), lines.end(), position), lines.begin() + 1, lines.end() - 1);
    const double low = *(upper - 1);
    const double local = (position - low) / (*upper - low);
    return {static_cast<int>(upper - lines.begin()) - 1, std::clamp(local, 0.0, 1.0)};
}

void mark_boundary(mfem::Mesh& mesh, const std::array<double, 2>& load) {
    for (int i = 0; i < mesh.GetNBE(); ++i) mesh.SetBdrAttribute(i, static_cast<int>(boundary_part(mesh, i, load)));
    mesh.SetAttributes();
}

std::array<double, 2> load_extent(const IcSpec& spec) {
    const double share = spec.load_shape == LoadShape::constant ? 0.5 : 1;
    return {share * spec.dx, share * spec.dy};
}

BlockMesh make_block_mesh(const IcSpec& spec) {
    switch (spec.fem.mesh) {
        case MeshKind::hex:
            return make_hex_block(spec);
        case MeshKind::prism:
            return make_prism_block(spec);
        case MeshKind::adaptive:
            break;
    }
    throw InvalidArgument("ics.mesh", "is adaptive, which make_block_mesh does not support");
}

}  // namespace contactd::fem
