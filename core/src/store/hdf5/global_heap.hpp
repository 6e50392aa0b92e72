// The global heaps of an HDF5 image, where texts of variable length lie (HDF5 file format, III.E).
#pragma once

#include <span>

namespace contactd {

/// Throws DamagedTable for a heap in which an object takes no room: the library would look for the next one at the same
/// place, and never end.
void check_global_heaps(std::span<const unsigned char> image);

}  // namespace contactd
