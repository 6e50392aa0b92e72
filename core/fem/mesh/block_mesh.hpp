// Provides a mesh of the quarter block [-L,0]^3 of any kind, and finds the element that contains a surface point.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include <mfem.hpp>

#include "contactd/ic_spec.hpp"

namespace contactd::fem {

/// Attributes of the boundary; faces are named as in the paper (Table 1).
enum class BoundaryPart {
    front = 1,   ///< x = 0
    right = 2,   ///< y = 0
    free = 3,    ///< z = 0 outside the load
    loaded = 4,  ///< z = 0, the quarter of the loaded element (of the hat function: of its support)
    far = 5      ///< x = -L, y = -L or z = -L
};

struct ElementPoint {
    int element = 0;               ///< number in BlockMesh::mesh
    mfem::IntegrationPoint point;  ///< reference coordinates in it
};

struct BlockMesh {
    mfem::Mesh mesh;  ///< has the boundary attributes of BoundaryPart; the order of elements must not change
    /// Finds the element that contains the surface point (-X, -Y, 0), and the point's place in it, for 0 <= X, Y <= L,
    /// by the inverse of the element map in closed form. A point on a shared face always gets the same element.
    std::function<ElementPoint(double X, double Y)> locate;
};

/// Returns the interval of ascending `lines` that contains `position`, the lower one of two, and the relative position
/// in it, 0 to 1.
struct Interval {
    int number = 0;
    double local = 0;
};
Interval find_interval(const std::vector<double>& lines, double position);

/// Makes the mesh named by spec.fem.mesh; `spec` must be dimensionless and valid.
BlockMesh make_block_mesh(const IcSpec& spec);

/// Gives the faces of a quarter block their BoundaryPart; `load` as from load_extent().
void mark_boundary(mfem::Mesh& mesh, const std::array<double, 2>& load);

/// Returns the extent of the quarter of the load along x and y: dx/2, dy/2 for a constant load, dx, dy for a bilinear
/// one.
std::array<double, 2> load_extent(const IcSpec& spec);

}  // namespace contactd::fem
