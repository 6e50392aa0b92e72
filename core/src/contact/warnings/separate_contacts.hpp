// Contacts of rough surfaces, which have many of them.
#pragma once

#include <cstddef>
#include <span>

#include "contactd/grid.hpp"

namespace contactd {

struct SeparateContacts {
    std::size_t count = 0;
    std::size_t typical = 0;  ///< elements of the median one
};

/// Counts the contacts: elements with pressure that have a side or a corner in common are of one.
SeparateContacts separate_contacts(const Grid& grid, std::span<const double> pressure);

}  // namespace contactd
