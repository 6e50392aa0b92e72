// The quarter block divided by planes normal to the axes.
#pragma once

#include <array>
#include <vector>

#include "block_mesh.hpp"

namespace contactd::fem {

/// `planes[a]`: distances from the origin along axis a (of depth for z), ascending from 0 to L.
BlockMesh make_tensor_block(const std::array<std::vector<double>, 3>& planes, const std::array<double, 2>& load);

}  // namespace contactd::fem
