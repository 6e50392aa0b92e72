// Tests lines and words of input files of CONTACT, rule by rule.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "contact_file_cases.hpp"
#include "contactd/error.hpp"
#include "read/input_lines.hpp"

using namespace contactd;
using namespace contactd::contact_files;

namespace {

std::vector<std::string> words_of(const std::string& text) {
    InputLines lines(text, "case.inp");
    std::vector<std::string> found;
    while (lines.next())
        for (const Word& word : lines.words()) found.push_back(word.text);
    return found;
}

}  // namespace

TEST_CASE("reals are written as in Fortran", "[contact_files]") {
    CHECK(real_in("1") == 1.0);
    CHECK(real_in(".5") == 0.5);
    CHECK(real_in("-1.") == -1.0);
    CHECK(real_in("+2.5") == 2.5);
    CHECK(real_in("1e-3") == 1e-3);
    CHECK(real_in("1D+3") == 1e3);
    CHECK(real_in("1.0d-3") == 1e-3);
    CHECK(real_in(".1-07") == 1e-8);
    CHECK(real_in(".8200E+05") == 82000.0);
    CHECK(real_in("2+3") == 2000.0);
    for (const char* none : {"", "-", ".", "3*0.", "1e", "1e+", "e5", "1.2.3", "abc", "1/2", "nan", "inf", "0x10",
                             "180.d", "1e999", "--1", "+-1", "1-", "1 "})
        CHECK_FALSE(real_in(none));
}

TEST_CASE("angles are degrees with a d behind them, else radians", "[contact_files]") {
    using Catch::Matchers::WithinULP;
    CHECK_THAT(*angle_in("180.d"), WithinULP(std::numbers::pi, 1));
    CHECK_THAT(*angle_in("-10.00D"), WithinULP(-std::numbers::pi / 18, 1));
    CHECK(angle_in("-0.0997r") == -0.0997);
    CHECK(angle_in("3.1416") == 3.1416);
    CHECK(angle_in("90d0") == 90.0);
    CHECK(angle_in("1d-3d") == 1e-3 * std::numbers::pi / 180);
    for (const char* none : {"", "d", "90dd", "90 d", "90g", "degrees"}) CHECK_FALSE(angle_in(none));
}

TEST_CASE("integers may have a point and zeros behind them", "[contact_files]") {
    CHECK(integer_in("12") == 12);
    CHECK(integer_in("-3") == -3);
    CHECK(integer_in("+1.0") == 1);
    CHECK(integer_in("7.") == 7);
    for (const char* none : {"", "1.5", "1e2", "2147483648", "x", "-", ".0", "1.0x"}) CHECK_FALSE(integer_in(none));
}

TEST_CASE("blanks, tabs, commas and equality signs separate words", "[contact_files]") {
    CHECK(words_of("a, b=c\td ,,= e\r\n") == std::vector<std::string>{"a", "b", "c", "d", "e"});
    CHECK(words_of("'a file, of mine.prr' 1 'x=y'") == std::vector<std::string>{"a file  of mine.prr", "1", "x=y"});
}

TEST_CASE("what follows a percent sign is a comment", "[contact_files]") {
    CHECK(words_of("% all\n\n  \t\n 1 % one\n 'a%b' 2 % two\n") == std::vector<std::string>{"1", "a%b", "2"});
    CHECK(words_of("   % 'quoted' in a comment\n1\n") == std::vector<std::string>{"1"});
}

TEST_CASE("a line ends after 256 characters", "[contact_files]") {
    const std::string line = std::string(252, ' ') + "1234567";
    CHECK(words_of(line) == std::vector<std::string>{"1234"});
    InputLines lines(line, "case.inp");
    REQUIRE(lines.next());
    CHECK(std::string(lines.what_is_cut()) == "has more than 256 characters");
}

TEST_CASE("words know their lines and columns", "[contact_files]") {
    InputLines lines("\xef\xbb\xbf% head\n\n  12 'ab' c", "case.inp");
    REQUIRE(lines.next());
    CHECK(lines.number() == 3);
    REQUIRE(lines.words().size() == 3);
    CHECK(lines.words()[0].column == 3);
    CHECK(lines.words()[1].column == 6);
    CHECK(lines.words()[1].is_quoted);
    CHECK(lines.words()[2].column == 11);
    CHECK_FALSE(lines.next());
}

TEST_CASE("a text that is none is refused by the name of its file", "[contact_files]") {
    CHECK_THROWS_AS(InputLines(std::string_view("a\0b", 3), "case.inp"), InvalidArgument);
    CHECK_THROWS_AS(InputLines(std::string(most_contact_file_bytes + 1, ' '), "case.inp"), InvalidArgument);
}

TEST_CASE("A long text without a word ends when its observer says so") {
    class Impatient final : public Observer {
       public:
        bool cancelled() const override { return ++asked > 3; }
        mutable int asked = 0;
    } observer;
    const std::string comments = [] {
        std::string text;
        for (int i = 0; i < 100'000; ++i) text += "% nothing\n";
        return text;
    }();
    InputLines lines(comments, "case.inp", &observer);
    CHECK_THROWS_AS(lines.next(), Cancelled);
    CHECK(lines.number() < 10'000);
}
