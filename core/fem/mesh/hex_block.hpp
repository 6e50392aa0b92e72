// Makes Mesh1 as an MFEM mesh of the quarter block [-L,0]^3.
#pragma once

#include "block_mesh.hpp"

namespace contactd::fem {

/// Creates right-handed hexahedra in the order of element_number() (shells.hpp): from the origin outwards.
BlockMesh make_hex_block(const IcSpec& spec);

}  // namespace contactd::fem
