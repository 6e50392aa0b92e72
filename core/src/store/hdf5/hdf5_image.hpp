// Converts the contents of an IC file to an HDF5 image in memory and back. HDF5 itself never accesses the disk, so that
// a file can be checked before HDF5 parses it, and written at once.
#pragma once

#include <span>
#include <vector>

#include "contactd/file_contents.hpp"

namespace contactd {

/// Returns the image of the contents. Throws StoreError.
std::vector<unsigned char> to_hdf5(const FileContents& contents);

/// Returns the contents of the image. Throws NewerFormat, and DamagedTable for anything that to_hdf5 does not write:
/// links that are not hard, values outside the image, layouts, filters and types of other kinds, and extents larger
/// than the image allows. Data are read only after these checks.
FileContents from_hdf5(std::span<const unsigned char> image);

}  // namespace contactd
