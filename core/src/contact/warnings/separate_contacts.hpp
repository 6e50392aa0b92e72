// Finds separate contacts of rough surfaces.
#pragma once

#include <cstddef>
#include <span>

#include "contactd/grid.hpp"

namespace contactd {

struct SeparateContacts {
    std::size_t count = 0;
    std::size_t typical = 0;  ///< median of their numbers of elements
};

/// Counts the contacts. Elements with pressure that share a side or a corner belong to the same contact.
SeparateContacts separate_contacts(const Grid& grid, std::span<const double> pressure);

}  // namespace contactd
