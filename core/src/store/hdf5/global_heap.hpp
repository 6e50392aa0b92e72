// Checks the global heaps of an HDF5 image, which contain texts of variable length (HDF5 file format, III.E).
#pragma once

#include <span>

namespace contactd {

/// Throws DamagedTable for a heap in which an object has no size: the library would look for the next one at the same
/// place, and never end.
void check_global_heaps(std::span<const unsigned char> image);

}  // namespace contactd
