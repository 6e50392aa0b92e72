#include <catch2/catch_test_macros.hpp>

#include "random_sections.hpp"

using namespace contactd;
using namespace contactd::test;

namespace {

void check_sections(std::uint64_t first, std::uint64_t count) {
    std::uint64_t refused = 0;
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        CAPTURE(seed);
        const SectionContact contact = random_section_contact(seed);
        if (!contact.refused.empty()) {
            ++refused;
            continue;
        }
        CHECK(section_faults(contact, solve(contact)) == "");
    }
    CHECK(refused < count / 3);
}

}  // namespace

TEST_CASE("Contacts of random sections meet all contact conditions", "[section][random]") {
    check_sections(1, 12);
}

// Slow: twelve sections.
TEST_CASE("So do more of them", "[section][random][slow]") {
    check_sections(13, 24);
}

// Long: 36 sections.
TEST_CASE("So do many of them", "[section][random][long]") {
    check_sections(25, 60);
}
