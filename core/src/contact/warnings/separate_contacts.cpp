#include "separate_contacts.hpp"

#include <algorithm>
#include <vector>

namespace contactd {

SeparateContacts separate_contacts(const Grid& grid, std::span<const double> pressure) {
    const auto nx = static_cast<std::size_t>(grid.nx), ny = static_cast<std::size_t>(grid.ny);
    std::vector<char> seen(pressure.size());
    std::vector<std::size_t> sizes, open;
    for (std::size_t first = 0; first < pressure.size(); ++first) {
        if (seen[first] || !(pressure[first] > 0)) continue;
        sizes.push_back(0);
        seen[first] = 1;
        open.push_back(first);
        while (!open.empty()) {
            const std::size_t here = open.back(), x = here % nx, y = here / nx;
            open.pop_back();
            ++sizes.back();
            for (std::size_t row = y > 0 ? y - 1 : 0; row < std::min(y + 2, ny); ++row)
                for (std::size_t column = x > 0 ? x - 1 : 0; column < std::min(x + 2, nx); ++column) {
                    const std::size_t next = row * nx + column;
                    if (seen[next] || !(pressure[next] > 0)) continue;
                    seen[next] = 1;
                    open.push_back(next);
                }
        }
    }
    if (sizes.empty()) return {};
    const auto median = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::ranges::nth_element(sizes, median);
    return {sizes.size(), *median};
}

}  // namespace contactd
