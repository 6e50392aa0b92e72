// Tests influence coefficients from files in CONTACT's format.
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <string>

#include "given/coefficients_file.hpp"
#include "given/not_covered.hpp"

using namespace contactd;
using namespace contactd::cases;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinRel;

namespace {

constexpr std::array order{Axis::z, Axis::x, Axis::y};

/// Returns symmetric coefficients, times G: any even or odd function of the offsets.
double coefficient(Axis i, Axis j, int k, int l) {
    const Parity signs = parity(i, j);
    const double along = signs.along_x > 0 ? 1.0 / (1 + k * k) : k, across = signs.along_y > 0 ? 2.0 / (2 + l * l) : l;
    return (i == j ? 1 : 0.01) * along * across;
}

/// Creates a file of 3 x 2 offsets of elements of 0.5 x 0.25 mm.
std::string text_of_file() {
    std::string text = "1 1\n0 312\n1 0\n3 2 0.5 0.25  % mx my dx dy\n";
    for (int l = -1; l <= 1; ++l) {
        text += "% a block\n%  ix  x  coefficients\n";
        for (int k = 0; k < 3; ++k) {
            text += std::to_string(k) + " " + std::to_string(0.5 * k);
            for (const Axis i : order)
                for (const Axis j : order) text += " " + std::to_string(coefficient(i, j, k, l));
            text += "\n";
        }
    }
    return text;
}

std::string refusal_of(const std::string& text) {
    try {
        read_coefficients(text, "ic.txt", 100);
    } catch (const NotCovered& refused) {
        return refused.what();
    }
    return {};
}

}  // namespace

TEST_CASE("coefficients of a file are divided by the modulus, in the order of their columns") {
    const GivenIcs found = read_coefficients(text_of_file(), "ic.txt", 100);
    CHECK(found.dx == 0.5);
    CHECK(found.dy == 0.25);
    REQUIRE(found.table.nx == 3);
    REQUIRE(found.table.ny == 2);
    for (const Axis i : order)
        for (const Axis j : order)
            for (int l = 0; l < 2; ++l)
                for (int k = 0; k < 3; ++k)
                    CHECK(std::abs(found.table(i, j, k, l) - coefficient(i, j, k, l) / 100) < 1e-8);
}

TEST_CASE("offsets beyond those of a file have no influence") {
    const GivenIcs found = with_offsets(read_coefficients(text_of_file(), "ic.txt", 100), {4, 3, 0.5, 0.25, 0, 0});
    REQUIRE(found.table.nx == 4);
    REQUIRE(found.table.ny == 3);
    CHECK_THAT(found.table(Axis::x, Axis::x, 2, 1), WithinRel(coefficient(Axis::x, Axis::x, 2, 1) / 100, 1e-4));
    CHECK(found.table(Axis::x, Axis::x, 3, 0) == 0);
    CHECK(found.table(Axis::z, Axis::z, 0, 2) == 0);
}

TEST_CASE("files that hold something else are refused by their lines") {
    const std::string text = text_of_file();
    const auto changed = [&](const std::string& from, const std::string& to) {
        std::string other = text;
        return other.replace(other.find(from), from.size(), to);
    };
    CHECK(refusal_of(text).empty());
    CHECK_THAT(refusal_of(changed("1 1", "7 1")), ContainsSubstring("line 1 ") && ContainsSubstring("each row"));
    CHECK_THAT(refusal_of(changed("0 312", "0 123")), ContainsSubstring("line 2 "));
    CHECK_THAT(refusal_of(changed("1 0\n", "0 0\n")), ContainsSubstring("line 3 "));
    CHECK_THAT(refusal_of(changed("3 2 0.5", "3 2 -0.5")), ContainsSubstring("line 4 "));
    CHECK_THAT(refusal_of(changed("0 0.000000 ", "1 0.000000 ")), ContainsSubstring("line 7 "));
    CHECK_THAT(refusal_of(text.substr(0, text.size() / 2)), ContainsSubstring("ic.txt"));
    CHECK_THAT(refusal_of(changed("% a block", "% a block\n% another")), ContainsSubstring("ic.txt"));
}

TEST_CASE("coefficients of bodies that are not symmetric are refused") {
    std::string text = text_of_file();
    const std::size_t last = text.rfind(" ", text.size() - 2);  // Cyy of the last offset
    text.replace(last, text.size() - last, " 0.5\n");
    CHECK_THAT(refusal_of(text), ContainsSubstring("symmetric"));
}
