// Mesh1 as an MFEM mesh of the quarter block [-L,0]^3.
#pragma once

#include <mfem.hpp>

#include "shells.hpp"

namespace contactd::fem {

/// Attributes of the boundary. The names of faces are the paper's (Table 1).
enum class BoundaryPart {
    front = 1,   ///< x = 0
    right = 2,   ///< y = 0
    free = 3,    ///< z = 0 outside the load
    loaded = 4,  ///< z = 0, the quarter of the loaded element
    far = 5      ///< x = -L, y = -L or z = -L
};

/// Right-handed hexahedra in the order of element_number(), whose reference axes run: xi along Y, eta along X, zeta
/// along Z (two axes swapped, since the quarter block is the mirror image of the positive octant).
mfem::Mesh make_quarter_block(const Shells& shells);

/// `local` coordinates of a surface point as MFEM's reference coordinates.
mfem::IntegrationPoint reference_point(const SurfacePoint& point);

}  // namespace contactd::fem
