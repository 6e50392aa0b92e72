// An IcRecord as an HDF5 file image in memory: HDF5 itself never touches the disk, so that a file can be checked before
// HDF5 parses it and written in one go.
#pragma once

#include <span>
#include <vector>

#include "contactd/ic_store.hpp"

namespace contactd {

std::vector<unsigned char> to_hdf5(const IcRecord& record);

/// Throws DamagedTable when the image is no table of ours.
IcRecord from_hdf5(std::span<const unsigned char> image);

}  // namespace contactd
