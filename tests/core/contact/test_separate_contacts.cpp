// Separate contacts of rough surfaces, compared with those found element by element.
#include "contact/warnings/separate_contacts.hpp"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cstdlib>
#include <random>
#include <vector>

using namespace contactd;

namespace {

/// Returns the numbers of elements of all contacts, in ascending order.
std::vector<std::size_t> sizes_by_element(const Grid& grid, const std::vector<double>& pressure) {
    std::vector<int> of_contact(pressure.size(), -1);
    std::vector<std::size_t> sizes;
    for (std::size_t first = 0; first < pressure.size(); ++first) {
        if (of_contact[first] >= 0 || pressure[first] == 0) continue;
        std::vector<std::size_t> open{first};
        of_contact[first] = 0;
        for (std::size_t at = 0; at < open.size(); ++at)
            for (std::size_t i = 0; i < pressure.size(); ++i) {
                const int x = static_cast<int>(i) % grid.nx - static_cast<int>(open[at]) % grid.nx;
                const int y = static_cast<int>(i) / grid.nx - static_cast<int>(open[at]) / grid.nx;
                if (std::abs(x) > 1 || std::abs(y) > 1 || of_contact[i] >= 0 || pressure[i] == 0) continue;
                of_contact[i] = 0;
                open.push_back(i);
            }
        sizes.push_back(open.size());
    }
    std::ranges::sort(sizes);
    return sizes;
}

}  // namespace

TEST_CASE("separate contacts are those of a search from element to element", "[contact]") {
    std::mt19937 random(1);
    for (const double share : {0.0, 0.1, 0.3, 0.5, 0.9, 1.0})
        for (const auto& [nx, ny] : {std::pair{1, 1}, {1, 9}, {9, 1}, {7, 5}, {12, 17}}) {
            const Grid grid{nx, ny, 1, 1};
            std::vector<double> pressure(grid.size());
            for (double& p : pressure) p = std::bernoulli_distribution(share)(random) ? 1 : 0;
            const std::vector<std::size_t> sizes = sizes_by_element(grid, pressure);
            const SeparateContacts found = separate_contacts(grid, pressure);
            CAPTURE(share, nx, ny);
            CHECK(found.count == sizes.size());
            CHECK(found.typical == (sizes.empty() ? 0 : sizes[sizes.size() / 2]));
        }
}

TEST_CASE("a spiral is one contact", "[contact]") {
    const std::vector<double> pressure{1, 1, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 1, 0, 1, 1, 0, 0, 0, 1, 1, 1, 1, 1, 1};
    const SeparateContacts found = separate_contacts({5, 5, 1, 1}, pressure);
    CHECK(found.count == 1);
    CHECK(found.typical == 17);
}
