#include "separate_contacts.hpp"

#include <algorithm>
#include <vector>

namespace contactd {
namespace {

/// Adjacent elements of a row that are in contact: [from, to).
struct Run {
    std::size_t from, to, parent;
};

/// Returns the first run of the contact to which a run belongs.
std::size_t root_of(std::vector<Run>& runs, std::size_t run) {
    while (runs[run].parent != run) run = runs[run].parent = runs[runs[run].parent].parent;
    return run;
}

/// Joins the runs of a row, from `row` on, with those of the previous row, from `above` on, that they touch.
void join(std::vector<Run>& runs, std::size_t above, std::size_t row) {
    for (std::size_t upper = above, lower = row; upper < row && lower < runs.size();) {
        if (runs[upper].from <= runs[lower].to && runs[lower].from <= runs[upper].to) {
            const std::size_t one = root_of(runs, upper), other = root_of(runs, lower);
            runs[std::max(one, other)].parent = std::min(one, other);
        }
        ++(runs[upper].to < runs[lower].to ? upper : lower);
    }
}

}  // namespace

SeparateContacts separate_contacts(const Grid& grid, std::span<const double> pressure) {
    const auto nx = static_cast<std::size_t>(grid.nx), ny = static_cast<std::size_t>(grid.ny);
    std::vector<Run> runs;
    std::size_t above = 0;
    for (std::size_t y = 0; y < ny; ++y) {
        const std::size_t row = runs.size();
        const std::span<const double> line = pressure.subspan(y * nx, nx);
        for (std::size_t x = 0; x < nx; ++x) {
            if (!(line[x] > 0)) continue;
            const std::size_t from = x;
            while (x < nx && line[x] > 0) ++x;
            runs.push_back({from, x, runs.size()});
        }
        join(runs, above, row);
        above = row;
    }
    if (runs.empty()) return {};
    std::vector<std::size_t> sizes(runs.size());
    for (std::size_t run = 0; run < runs.size(); ++run) sizes[root_of(runs, run)] += runs[run].to - runs[run].from;
    std::erase(sizes, 0u);
    const auto median = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::ranges::nth_element(sizes, median);
    return {sizes.size(), *median};
}

}  // namespace contactd
