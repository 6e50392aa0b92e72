// A hexahedral block whose elements are divided one by one. What is left at the edges of a division are hanging nodes;
// MFEM ties them to their neighbours.
#pragma once

#include <vector>

#include "block_mesh.hpp"

namespace contactd::fem {

/// Where an element lies in the element of the start mesh that holds it, in the latter's reference coordinates: exact,
/// since every division halves the edges.
struct ReferenceBox {
    int ancestor = 0;
    std::array<double, 3> low{0, 0, 0}, size{1, 1, 1};
};

class RefinedBlock {
   public:
    /// `start` must be of hexahedra whose surface faces are zeta = 0, as make_hex_block() makes them.
    explicit RefinedBlock(BlockMesh start);

    /// Divides each of these elements into eight; all elements are numbered anew.
    void refine(const std::vector<int>& elements);

    const mfem::Mesh& mesh() const { return mesh_; }

    /// A copy of the mesh, with the start mesh's way to find the element that holds a surface point.
    BlockMesh block() const;

   private:
    mfem::Mesh mesh_;
    std::function<ElementPoint(double, double)> locate_;  ///< in the start mesh
    std::vector<ReferenceBox> boxes_;
};

}  // namespace contactd::fem
