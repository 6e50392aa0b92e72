// The contents of an IC file as an HDF5 image in memory. HDF5 itself never touches the disk, so that a file can be
// checked before HDF5 parses it and written in one go.
#pragma once

#include <span>
#include <vector>

#include "contactd/file_contents.hpp"

namespace contactd {

/// Throws StoreError.
std::vector<unsigned char> to_hdf5(const FileContents& contents);

/// Everything that the image holds. Throws NewerFormat, and DamagedTable for whatever to_hdf5 does not write: links
/// that are not hard, values outside the image, layouts, filters and types of other kinds, extents that the image has
/// no room for. No data is read before all of that is known of it.
FileContents from_hdf5(std::span<const unsigned char> image);

}  // namespace contactd
