// CONTACT's text and the bytes of an IC file.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <random>
#include <sstream>

#include "contact/contact_cases.hpp"
#include "contactd/error.hpp"
#include "contactd/ic_exchange.hpp"
#include "contactd/observer.hpp"
#include "contactd/solve_contact.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
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

/// Dissimilar bodies: all nine components are there.
GivenIcs coupled_pair(int nx = 4, int ny = 3) {
    const double dx = 0.06, dy = 0.11;
    return {pair_of(body_table({200, 0.42}, nx, ny, dx, dy), body_table({800, 0.1}, nx, ny, dx, dy)), dx, dy};
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

std::string text_of(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

std::vector<double> numbers_of(const std::string& line) {
    std::istringstream stream(line);
    std::vector<double> numbers;
    for (double value; stream >> value;) numbers.push_back(value);
    return numbers;
}

/// Puts another number into a line of coefficients.
void set(std::string& line, std::size_t n, double value) {
    std::vector<double> row = numbers_of(line);
    row[n] = value;
    std::ostringstream text;
    text.precision(17);
    for (const double number : row) text << number << ' ';
    line = text.str();
}

/// Line of the coefficients of (k, l), counting from 0.
std::size_t line_of(const GivenIcs& ics, int k, int l) {
    return static_cast<std::size_t>(4 + (l + ics.table.ny - 1) * (ics.table.nx + 2) + 2 + k);
}

std::string refusal_of(const std::string& text, std::optional<double> G = std::nullopt) {
    try {
        from_contact_text(text, G);
    } catch (const InvalidArgument& error) {
        return error.what();
    }
    return "taken";
}

double largest_difference(const IcTable& a, const IcTable& b) {
    double difference = 0, scale = 0;
    for (std::size_t n = 0; n < a.values.size(); ++n) {
        difference = std::max(difference, std::abs(a.values[n] - b.values[n]));
        scale = std::max(scale, std::abs(b.values[n]));
    }
    return difference / scale;
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
    // less that of the lower one, times G/4, and makes Czx = K / (pi x) far along x.
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

TEST_CASE("a text read back is the table it was made of", "[exchange]") {
    const int nx = GENERATE(1, 2, 7), ny = GENERATE(1, 3);
    const GivenIcs ics = coupled_pair(nx, ny);
    const std::string text = to_contact_text(ics, 320);
    const GivenIcs read = from_contact_text(text, std::nullopt);
    CHECK(read.dx == ics.dx);
    CHECK(read.dy == ics.dy);
    CHECK(read.table.nx == nx);
    CHECK(read.table.ny == ny);
    CHECK(largest_difference(read.table, ics.table) < 1e-15);
    CHECK(to_contact_text(read, 320).size() == text.size());
}

TEST_CASE("the modulus of the caller wins over that of the comments", "[exchange]") {
    const GivenIcs ics = coupled_pair();
    const GivenIcs read = from_contact_text(to_contact_text(ics, 320), 160.0);
    CHECK_THAT(read.table(z, z, 0, 0), WithinRel(2 * ics.table(z, z, 0, 0), 1e-14));
}

TEST_CASE("a table that went through the text solves to the same forces", "[exchange]") {
    const ContactProblem problem = cattaneo_problem(20);
    const GivenIcs ics{half_space_pair(problem.grid, problem.bodies.upper.material), problem.grid.dx, problem.grid.dy};
    const GivenIcs read = from_contact_text(to_contact_text(ics, 200), std::nullopt);
    Observer observer;
    const auto expected = solve_contact(problem, make_influence(problem, ics.table), observer);
    ContactProblem given = problem;
    given.bodies = {};
    given.bodies.pair = read;
    const auto solution = solve_contact(given, make_influence(given, read.table), observer);
    CHECK_THAT(solution.Fn, WithinRel(expected.Fn, 1e-12));
    CHECK_THAT(solution.Fx, WithinRel(expected.Fx, 1e-12));
    CHECK(solution.elements.slip == expected.elements.slip);
}

TEST_CASE("texts of others are read: words, comments, Fortran's numbers, ends of line", "[exchange]") {
    const GivenIcs ics = coupled_pair();
    auto lines = lines_of(to_contact_text(ics, 320));
    SECTION("the first line consists of words") {
        lines[0] = "nmatrix iaconvex";
    }
    SECTION("header lines go on") {
        lines[0] = "   1    0   0 0 0 0 0 0 % nmatrix, iaconvex: number of tables, body number of the convex body";
        lines[1] += " % lquasid, xyzordr";
        lines[2] += " 0 0 0";
        lines[3] += " 0 0 % mx, my, dx, dy";
    }
    SECTION("comments and empty lines stand before the header") {
        lines.insert(lines.begin(), {"% made by hand", ""});
    }
    SECTION("exponents of Fortran and of nobody") {
        for (std::size_t n = 4; n < lines.size(); ++n)
            if (lines[n][0] != '%') std::replace(lines[n].begin(), lines[n].end(), 'e', n % 2 == 0 ? 'D' : 'd');
        lines[line_of(ics, 0, 0)].replace(lines[line_of(ics, 0, 0)].rfind("0.0"), 3, " 0.0");
    }
    SECTION("lines end as on Windows, and more empty ones follow") {
        for (std::string& line : lines) line += "\r";
        lines.push_back("");
    }
    SECTION("the comments say nothing of G") {
        for (std::string& line : lines)
            if (line.starts_with("% offset")) line = "";
    }
    CHECK(largest_difference(from_contact_text(text_of(lines), 320.0).table, ics.table) < 1e-15);
}

TEST_CASE("three-digit exponents without a letter are read", "[exchange]") {
    auto lines = lines_of(to_contact_text(coupled_pair(1, 1), 320));
    lines[6] = "0 0.0 1.5 1.0-120 0 0 2.5+000 0 0 0 .5D+1";
    const IcTable table = from_contact_text(text_of(lines), 1.0).table;
    CHECK(table(z, z, 0, 0) == 1.5);
    CHECK(table(x, x, 0, 0) == 2.5);
    CHECK(table(y, y, 0, 0) == 5);
}

TEST_CASE("few digits leave a symmetric table", "[exchange]") {
    const GivenIcs ics = coupled_pair();
    auto lines = lines_of(to_contact_text(ics, 320));
    const auto row = numbers_of(lines[line_of(ics, 2, -1)]);
    for (std::size_t n = 2; n < row.size(); ++n) set(lines[line_of(ics, 2, -1)], n, row[n] + 1e-9);
    set(lines[line_of(ics, 2, 0)], 8, 1e-9);
    const IcTable table = from_contact_text(text_of(lines), std::nullopt).table;
    CHECK_THAT(320 * table(y, z, 2, 1), WithinAbs(-row[8], 1e-9));
    CHECK(table(y, z, 2, 0) == 0);
}

TEST_CASE("a broken line is named with what would be right", "[exchange]") {
    const GivenIcs ics = coupled_pair();
    auto lines = lines_of(to_contact_text(ics, 320));
    struct Case {
        std::size_t line;
        const char* text;
        const char* says;
    };
    const std::size_t row = line_of(ics, 1, 0);
    const auto c =
        GENERATE_COPY(Case{0, "3 1", "line 1 announces 3 tables"}, Case{0, "1", "line 1 holds too few numbers"},
                      Case{0, "1 5", "line 1 names the convex body 5"}, Case{0, "1.5 1", "line 1 holds \"1.5\""},
                      Case{1, "1 312", "line 2 holds 1 where the column definition (0 312) must have 0"},
                      Case{1, "0 123", "line 2 holds 123"}, Case{1, "zero 312", "line 2 holds \"zero\""},
                      Case{2, "1 1", "line 3 holds 1 where the symmetry (1 0) must have 0"},
                      Case{2, "0 0", "line 3 holds 0"}, Case{3, "4 3 0.06", "line 4 holds too few numbers"},
                      Case{3, "4 3 0.06 -1", "line 4 holds \"-1\""}, Case{3, "0 3 1 1", "line 4 announces 0 x 3"},
                      Case{3, "2000000000 2000000000 1 1", "line 4 announces 2000000000 x 2000000000"},
                      Case{3, "2000 2000 1 1", "lines must follow"}, Case{3, "4 4 0.06 0.11", "lines must follow"},
                      Case{3, "4 2 0.06 0.11", "line 5 announces the y offset -2; by the extent"},
                      Case{3, "4 3 0.0601 0.11", "line 8 has x 0.06; it must be ix dx, 0.0601"},
                      Case{3, "4 3 0.06 0.1101", "line 5 has y -0.22; by the element size"},
                      Case{10, "% offset iy = -1, y = -0.11; times G = 3200", "line 11 tells the modulus 3200"},
                      Case{row, "1 0.06 1 2 3", "holds 5 numbers; it must hold eleven"},
                      Case{row, "1 0.06 1 2 3 4 5 6 7 8 9 10", "holds 12 numbers"},
                      Case{row, "1 0.06 1 2 3 4 5 6 7 8 nine", "holds \"nine\"; it must be a finite number"},
                      Case{row, "1 0.06 1 2 3 4 5 6 7 8 NaN", "holds \"NaN\""},
                      Case{row, "1 0.06 1 2 3 4 5 6 7 8 Infinity", "holds \"Infinity\""},
                      Case{row, "1 0.06 1 2 3 4 5 6 7 8 1e999", "holds \"1e999\""},
                      Case{row, "1 0.06 1 2 3 4 5 6 7 8 ******", "holds \"******\""},
                      Case{row, "2 0.06 1 2 3 4 5 6 7 8 9", "has ix 2; it must be that of the offset (1, 0)"},
                      Case{row, "1 0.12 1 2 3 4 5 6 7 8 9", "has x 0.12"},
                      Case{row, "1 0.06 1 2 9 4 5 6 7 8 9", "must vanish at the y offset 0"});
    lines[c.line] = c.text;
    const std::string refusal = refusal_of(text_of(lines));
    CHECK_THAT(refusal, ContainsSubstring(c.says));
    if (c.line == row) CHECK_THAT(refusal, ContainsSubstring("line " + std::to_string(row + 1) + " "));
}

TEST_CASE("what follows the last offset is no table", "[exchange]") {
    const std::string text = to_contact_text(coupled_pair(), 320);
    CHECK_THAT(refusal_of(text + lines_of(text).back() + "\n"), ContainsSubstring("behind the last y offset"));
}

TEST_CASE("coordinates of few digits are those of the header", "[exchange]") {
    const GivenIcs ics = coupled_pair();
    auto lines = lines_of(to_contact_text(ics, 320));
    std::string& line = lines[line_of(ics, 1, 0)];
    const std::size_t x = line.find("5.99"), end = line.find(' ', x);
    REQUIRE(x != std::string::npos);
    line.replace(x, end - x, GENERATE("0.1", "0.06", "6e-2", "0.06000001", ".6D-1"));
    CHECK(largest_difference(from_contact_text(text_of(lines), std::nullopt).table, ics.table) < 1e-15);
}

TEST_CASE("coefficients come back to the rounding of their product with the modulus", "[exchange]") {
    const GivenIcs ics = coupled_pair(7, 5);
    for (const double G : {1.0, 256.0})
        CHECK(from_contact_text(to_contact_text(ics, G), {}).table.values == ics.table.values);
    const IcTable read = from_contact_text(to_contact_text(ics, 8.2e4 / 3), {}).table;
    for (std::size_t n = 0; n < read.values.size(); ++n)
        CHECK_THAT(read.values[n], WithinRel(ics.table.values[n], std::numeric_limits<double>::epsilon()));
}

TEST_CASE("a text that contradicts the symmetry of tables is refused", "[exchange]") {
    const GivenIcs ics = coupled_pair();
    auto lines = lines_of(to_contact_text(ics, 320));
    SECTION("an odd component does not change its sign") {
        lines[line_of(ics, 2, -1)] = lines[line_of(ics, 2, 1)];
        CHECK_THAT(refusal_of(text_of(lines)), ContainsSubstring("for Czy; it must be minus what line"));
    }
    SECTION("an even component differs") {
        std::string& line = lines[line_of(ics, 2, -1)];
        set(line, 2, numbers_of(line)[2] * 1.001);
        CHECK_THAT(refusal_of(text_of(lines)), ContainsSubstring("for Czz; it must be what line"));
        CHECK_NOTHROW(from_contact_text(text_of(lines), std::nullopt, 0.01));
    }
    SECTION("something odd in x does not vanish at ix = 0") {
        set(lines[line_of(ics, 0, 1)], 3, 0.001);
        CHECK_THAT(refusal_of(text_of(lines)), ContainsSubstring("for Czx; it must vanish at ix = 0"));
    }
}

TEST_CASE("a text that ends too soon, or is none, is refused", "[exchange]") {
    const std::string text = to_contact_text(coupled_pair(), 320);
    CHECK_THAT(refusal_of(""), ContainsSubstring("line 1 is missing"));
    CHECK_THAT(refusal_of("1 1\n0 312\n"), ContainsSubstring("line 3 is missing"));
    CHECK_THAT(refusal_of(text.substr(0, text.size() - 2000)), ContainsSubstring("lines must follow"));
    CHECK_THAT(refusal_of(std::string(5000, '\x01')), ContainsSubstring("line 2 is missing"));
}

TEST_CASE("damaged texts are read or refused", "[exchange]") {
    const std::string whole = to_contact_text(coupled_pair(3, 2), 320);
    std::mt19937 generator(20240229);
    const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(generator); };
    const std::string letters = "0123456789.eED+-% ,\n\r\t*\xff";
    int refused = 0;
    for (int n = 0; n < 5000; ++n) {
        std::string text = whole;
        for (std::size_t times = 1 + below(3); times > 0; --times) {
            const std::size_t at = below(below(2) == 0 ? text.size() : 40);
            if (below(2) == 0) {
                text.erase(at, 1 + below(30));
            } else {
                text.insert(at, 1, letters[below(letters.size())]);
            }
        }
        try {
            const GivenIcs read = from_contact_text(text, std::nullopt);
            CHECK(read.table.values.size() == 9 * read.table.component_size());
        } catch (const InvalidArgument&) {
            ++refused;
        }
    }
    CHECK(refused > 3000);
}

TEST_CASE("without a modulus anywhere the values mean nothing", "[exchange]") {
    auto lines = lines_of(to_contact_text(coupled_pair(), 320));
    for (std::string& line : lines)
        if (line.starts_with("% offset")) line = "%";
    CHECK_THAT(refusal_of(text_of(lines)), ContainsSubstring("G is missing"));
    CHECK_THAT(refusal_of(text_of(lines), -1.0), ContainsSubstring("G is -1"));
}

TEST_CASE("a file that leaves the store has dimensions", "[exchange]") {
    IcSpec spec;
    spec.material = {82000, 0.28};
    spec.dx = 0.8;
    spec.dy = 0.4;
    spec.nx = 3;
    spec.ny = 2;
    const IcRecord record{spec, half_space_table(spec), {}, {}};
    const auto bytes = to_ic_file(record);
    const auto path = std::filesystem::temp_directory_path() / ("contactd-exported-" + ic_key({record.table, 1, 1}));
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    const IcRecord read = read_ic_file(path);
    std::filesystem::remove(path);
    CHECK(read.spec == spec);
    CHECK(read.table.values == record.table.values);
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
