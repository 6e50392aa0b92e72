// Tests errors in files: line, column, expected value, and consequences.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <string>

#include "contact_file_cases.hpp"

using namespace contactd;
using namespace contactd::contact_file_cases;
using Catch::Matchers::ContainsSubstring;

namespace {

/// Returns the only error in the first case of a file.
std::string error_of(const std::string& text) {
    const ContactFile file = read_all(text);
    if (file.cases.empty() || file.cases[0].errors.empty()) return {};
    return file.cases[0].errors[0];
}

const std::string next = "3 MODULE\n001100\n100000\n101001\n900. 0.005 0. 0.\n";

}  // namespace

TEST_CASE("a word that does not fit is told by line, column and name", "[contact_files]") {
    BasicCase text;
    text.load = " 1000. force 0. 0.\n";
    CHECK_THAT(error_of(text.text()), ContainsSubstring("line 6, column 8, has \"force\" where CKSI, a number"));
    text.load = "1000. 0.004 0. 0.\n";
    text.grid = "1\n4.5 3 -1. -.75 .5 .5\n";
    CHECK_THAT(error_of(text.text()), ContainsSubstring("line 10, column 1, has \"4.5\" where MX, an integer"));
    text.grid = "1\n3*4 3 -1. -.75 .5 .5\n";
    CHECK_THAT(error_of(text.text()), ContainsSubstring("has \"3*4\" where MX"));
    RailCase rail;
    rail.rail = "rail.prr 0 1. 0.\n";
    CHECK_THAT(error_of(rail.text()),
               ContainsSubstring("has \"rail.prr\" where RFNAME, a name in single quotation marks,"));
    rail.rail = "'rail.prr 0 1. 0.\n";
    CHECK_THAT(error_of(rail.text()), ContainsSubstring("a quotation mark is missing"));
}

TEST_CASE("digits that have no meaning are told with those that have one", "[contact_files]") {
    BasicCase text;
    text.digits = "201100\n522020\n000001\n";
    CHECK_THAT(
        error_of(text.text()),
        ContainsSubstring("line 3, column 1, has the digit L = 5; in module 3 it must be one of 0, 1, 2, 3, 4, 6"));
    text.digits = "201100\n022020 L\n123456789\n";
    CHECK_THAT(error_of(text.text()), ContainsSubstring("has 9 digits"));
    text.digits = "-201100\n022020\n000001\n";
    CHECK_THAT(error_of(text.text()), ContainsSubstring("where the control digits P B T N F S are expected"));
}

TEST_CASE("a case that is cut off says what is missing", "[contact_files]") {
    BasicCase text;
    const std::string whole = text.text();
    for (std::size_t cut = whole.find('\n') + 1; cut < whole.rfind(".001"); cut = whole.find('\n', cut) + 1) {
        const ContactFile file = read_all(whole.substr(0, cut));
        const std::string reported = file.cases.empty() ? file.errors.at(0) : file.cases[0].errors.at(0);
        CHECK_THAT(reported, ContainsSubstring("is the end of the file"));
    }
    text.gap = "";
    CHECK_THAT(error_of(text.text() + next), ContainsSubstring("a case before this line may be truncated"));
}

TEST_CASE("after a case that was given up the next line of a module begins one", "[contact_files]") {
    BasicCase wrong;
    wrong.load = "1000. wrong 0. 0.\n";
    const ContactFile file = read_all(wrong.text() + next + BasicCase{}.text() + next + RailCase{}.text() + end);
    REQUIRE(file.cases.size() == 5);
    CHECK_THAT(file.cases[1].errors.at(0), ContainsSubstring("keeps data of case 1"));
    CHECK(file.cases[2].errors.empty());
    CHECK(file.cases[3].errors.empty());
    CHECK(file.cases[4].errors.empty());
}

TEST_CASE("a case that goes on from one with errors says so", "[contact_files]") {
    BasicCase wrong;
    wrong.load = "-1000. 0.004 0. 0.\n";
    const ContactFile file = read_all(wrong.text() + next + next + BasicCase{}.text() + next + end);
    REQUIRE(file.cases.size() == 5);
    CHECK_THAT(file.cases[0].errors.at(0), ContainsSubstring("FN = -1000"));
    CHECK_THAT(file.cases[1].errors.at(0), ContainsSubstring("has P = 0, which continues case 1"));
    CHECK_THAT(file.cases[2].errors.at(0), ContainsSubstring("continues case 2"));
    CHECK(file.cases[4].errors.empty());
}

TEST_CASE("a first case cannot keep what there is not", "[contact_files]") {
    const auto digits = [](const std::string& words) {
        BasicCase text;
        text.digits = words;
        if (words[7] == '1') text.friction = "";
        return error_of(text.text());
    };
    CHECK_THAT(digits("201100\n122020\n000001\n"), ContainsSubstring("has L = 1"));
    CHECK_THAT(
        error_of("3 MODULE\n201100\n002020\n000001\n100 30 5 1 1e-6\n1000. 0. 0. 0.\n.3 .3\n.3 .3 1. 1.\n1 1\n" + end),
        ContainsSubstring("has D = 0"));
    BasicCase points;
    points.digits = "201101\n022020\n000001\n";
    CHECK_THAT(error_of(points.text()), ContainsSubstring("has S = 1"));
    BasicCase material;
    material.digits = "201100\n020020\n000001\n";
    material.material = "";
    CHECK_THAT(error_of(material.text()), ContainsSubstring("C = 0, which requires POISS1"));
}

TEST_CASE("digits that do not go with each other are told", "[contact_files]") {
    BasicCase heat;
    heat.digits = "201100\n022020\n3000001\n";
    heat.more = "0. 450. 50e-3 7.85e-6\n0. 450. 50e-3 7.85e-6\n";
    CHECK_THAT(error_of(heat.text()), ContainsSubstring("has H = 3"));
    RailCase force;
    force.digits = "1203010\n0022033\n0000001\n";
    CHECK_THAT(error_of(force.text()), ContainsSubstring("has F = 1 with N = 0"));
    BasicCase both;
    both.friction = "0.3 0.2\n";
    CHECK_THAT(error_of(both.text()), ContainsSubstring("has different FSTAT and FKIN"));
    RailCase angles;
    angles.digits = "1203100\n1022033\n0000001\n";
    angles.friction = "2\n-10d .3 .3\n-20d .3 .3\n";
    CHECK_THAT(error_of(angles.text()), ContainsSubstring("they must increase"));
}

TEST_CASE("what a case may not change is told", "[contact_files]") {
    const std::string rail = RailCase{}.text() + "1 MODULE\n1203000\n0101000\n0100001\n" + end;
    CHECK_THAT(read_all(rail).cases.at(1).errors.at(0),
               ContainsSubstring("has N = 0, different from the previous case"));
    const std::string roll = BasicCase{}.text() + "3 MODULE\n203100\n100000\n100001\n900. 0. 0. 0.\n" + end;
    CHECK_THAT(read_all(roll).cases.at(1).errors.at(0), ContainsSubstring("has C = 0 between a shift and rolling"));
}

TEST_CASE("another program's file is refused at its first word", "[contact_files]") {
    const ContactFile file = read_all("header.begin\n version = 1\nheader.end\n");
    CHECK(file.cases.empty());
    CHECK_THAT(file.errors.at(0),
               ContainsSubstring("line 1, column 1, has \"header.begin\" where the number of a MODULE is expected"));
}

TEST_CASE("a file without its end, and one with more behind it, are warned of", "[contact_files]") {
    CHECK_THAT(read_all(BasicCase{}.text()).warnings.at(0), ContainsSubstring("the file may be truncated"));
    CHECK_THAT(read_all(BasicCase{}.text() + end + "more\n").warnings.at(0),
               ContainsSubstring("line 14 and all that follow are ignored"));
    BasicCase open;
    open.digits = "201100\n022020\n000000\n";
    CHECK_THAT(read_all(open.text()).errors.at(0), ContainsSubstring("R = 0 or 2"));
    CHECK_THAT(read_all("% nothing\n\n").errors.at(0), ContainsSubstring("there is no case"));
}

TEST_CASE("a number too many on a line is warned of by its column", "[contact_files]") {
    BasicCase text;
    text.grid = "1\n4 3 7.5 -1. -.75 .5 .5  MX, MY, XL, YL, DX, DY\n";
    const ContactCase one = read_all(text.text()).cases.at(0);
    CHECK(one.errors.empty());
    CHECK_THAT(one.warnings.at(0), ContainsSubstring("has the number \".5\" in column 21 after the last value"));
    text.grid = "1\n4 3 -1. -.75 .5 .5 (6 values) % 5 6\n";
    CHECK(read_all(text.text()).cases.at(0).warnings.empty());
}

TEST_CASE("values beyond the end of a line are warned of", "[contact_files]") {
    BasicCase text;
    std::string row;
    for (int i = 0; i < 60; ++i) row += "1 ";
    text.grid = "1\n60 1 -1. -.75 .5 .5\n";
    text.gap = "9 1\n" + row + "\n" + "2 2 2 2 2 2 2 2 2 2\n";
    const ContactCase read = last_of(text.text());
    CHECK(numbers(read, "GAP").back() == 2);
    CHECK_THAT(read.warnings.at(0), ContainsSubstring("has more than 50 words"));
}

TEST_CASE("result elements have bounds", "[contact_files]") {
    CHECK_THAT(read_all("3 1000 MODULE\n").errors.at(0), ContainsSubstring("REID"));
    CHECK_THAT(read_all("3 1 10 MODULE\n").errors.at(0), ContainsSubstring("CPID"));
}
