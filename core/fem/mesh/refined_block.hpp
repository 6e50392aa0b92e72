// Represents a hexahedral block whose elements are divided one by one. Divisions leave hanging nodes at their edges,
// which MFEM ties to their neighbours.
#pragma once

#include <vector>

#include "block_mesh.hpp"

namespace contactd::fem {

/// Holds the place of an element in the element of the start mesh that contains it, in the latter's reference
/// coordinates. It is exact, because every division halves the edges.
struct ReferenceBox {
    int ancestor = 0;
    std::array<double, 3> low{0, 0, 0}, size{1, 1, 1};
};

class RefinedBlock {
   public:
    /// `start` must consist of hexahedra whose surface faces are zeta = 0, as made by make_hex_block().
    explicit RefinedBlock(BlockMesh start);

    /// Divides each of these elements into eight, and numbers all elements anew.
    void refine(const std::vector<int>& elements);

    const mfem::Mesh& mesh() const { return mesh_; }

    /// Returns a copy of the mesh, with the start mesh's function to find the element that contains a surface point.
    BlockMesh block() const;

   private:
    mfem::Mesh mesh_;
    std::function<ElementPoint(double, double)> locate_;  ///< in the start mesh
    std::vector<ReferenceBox> boxes_;
};

}  // namespace contactd::fem
