// Tests CONTACT's text and the bytes of an IC file.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

#include "contactd/half_space.hpp"
#include "contactd/ic_exchange.hpp"

using namespace contactd;
using Catch::Matchers::WithinRel;
using enum Axis;

namespace {

IcTable body_table(const Material& material, int nx, int ny, double dx, double dy) {
    IcSpec spec;
    spec.material = material;
    spec.nx = nx;
    spec.ny = ny;
    spec.dx = dx;
    spec.dy = dy;
    return half_space_table(spec);
}

/// Dissimilar bodies have all nine components.
GivenIcs coupled_pair() {
    const int nx = 4, ny = 3;
    const double dx = 0.06, dy = 0.11;
    return {pair_of(body_table({200, 0.42}, nx, ny, dx, dy), body_table({800, 0.1}, nx, ny, dx, dy)), dx, dy};
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

std::vector<double> numbers_of(const std::string& line) {
    std::istringstream stream(line);
    std::vector<double> numbers;
    for (double value; stream >> value;) numbers.push_back(value);
    return numbers;
}

/// Returns the line of the coefficients of (k, l), counting from 0.
std::size_t line_of(const GivenIcs& ics, int k, int l) {
    return static_cast<std::size_t>(4 + (l + ics.table.ny - 1) * (ics.table.nx + 2) + 2 + k);
}

}  // namespace

TEST_CASE("the header says one table, nine columns, symmetry in x, extent and sizes", "[exchange]") {
    const auto lines = lines_of(to_contact_text(coupled_pair(), 320));
    CHECK(numbers_of(lines[0]) == std::vector<double>{1, 1});
    CHECK(lines[1] == "0 312");
    CHECK(lines[2] == "1 0");
    CHECK(numbers_of(lines[3]) == std::vector<double>{4, 3, 0.06, 0.11});
    CHECK(lines.size() == 4 + 5 * (2 + 4));
}

TEST_CASE("a line holds ix, x and the nine columns times G, z first", "[exchange]") {
    const GivenIcs ics = coupled_pair();
    const int k = GENERATE(0, 1, 3), l = GENERATE(-2, -1, 0, 2);
    const auto row = numbers_of(lines_of(to_contact_text(ics, 320))[line_of(ics, k, l)]);
    REQUIRE(row.size() == 11);
    CHECK(row[0] == k);
    CHECK(row[1] == k * ics.dx);
    std::size_t column = 2;
    for (const Axis i : {z, x, y})
        for (const Axis j : {z, x, y}) CHECK(row[column++] == 320 * ics.table.at(i, j, k, l));
}

TEST_CASE("the columns are those of a half-space pair in closed form, signs included", "[exchange]") {
    // Johnson, section 3.2: G u_z = (1 - nu) P / (2 pi rho) for each body; K of CONTACT is (1-2nu)/G of the upper body
    // minus that of the lower one, times G/4, and makes Czx = K / (pi x) far along x.
    const Material upper{200, 0.42}, lower{800, 0.1};
    const double G = combined_modulus({upper, lower});
    const int k = 30;
    const GivenIcs ics{pair_of(body_table(upper, k + 1, 1, 1, 1), body_table(lower, k + 1, 1, 1, 1)), 1, 1};
    const auto row = numbers_of(lines_of(to_contact_text(ics, G))[line_of(ics, k, 0)]);
    const double nu = G / 2 * (upper.nu / upper.G + lower.nu / lower.G);
    const double K = G / 4 * ((1 - 2 * upper.nu) / upper.G - (1 - 2 * lower.nu) / lower.G);
    CHECK_THAT(row[2], WithinRel((1 - nu) / (std::numbers::pi * k), 1e-3));
    CHECK_THAT(row[3], WithinRel(K / (std::numbers::pi * k), 1e-3));
    CHECK_THAT(row[5], WithinRel(-K / (std::numbers::pi * k), 1e-3));
    CHECK_THAT(row[6], WithinRel(1 / (std::numbers::pi * k), 1e-3));
}

TEST_CASE("the combined modulus is the harmonic mean, for equal bodies their own", "[exchange]") {
    CHECK(combined_modulus({{82000, 0.3}, {82000, 0.1}}) == 82000);
    CHECK_THAT(combined_modulus({{200, 0.3}, {800, 0.3}}), WithinRel(320, 1e-15));
}

TEST_CASE("a file that leaves the store has dimensions", "[exchange]") {
    IcSpec spec;
    spec.material = {82000, 0.28};
    spec.dx = 0.8;
    spec.dy = 0.4;
    spec.nx = 3;
    spec.ny = 2;
    const IcRecord record{spec, half_space_table(spec), {}};
    const auto bytes = to_ic_file(record);
    const auto path = std::filesystem::temp_directory_path() / ("contactd-exported-" + ic_key({record.table(), 1, 1}));
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    const IcRecord read = read_ic_file(path);
    std::filesystem::remove(path);
    CHECK(read.spec == spec);
    CHECK(read.table().values == record.table().values);
}

TEST_CASE("the key of a given table tells tables apart", "[exchange]") {
    const GivenIcs ics = coupled_pair();
    GivenIcs other = ics;
    CHECK(ic_key(ics) == ic_key(other));
    other.dx = 0.07;
    CHECK(ic_key(ics) != ic_key(other));
    other = ics;
    other.table(x, y, 1, 1) += 1e-12;
    CHECK(ic_key(ics) != ic_key(other));
    CHECK(ic_key(ics).size() == 64);
}
