// Tests the values that cases read, and those that they keep from previous cases.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <numbers>
#include <string>

#include "contact_file_cases.hpp"

using namespace contactd;
using namespace contactd::contact_file_cases;
using Catch::Matchers::WithinRel;

TEST_CASE("a case of module 3 has its values by the names of CONTACT", "[contact_files]") {
    const ContactCase read = last_of(BasicCase{}.text());
    CHECK(read.module_number == 3);
    CHECK(read.number == 1);
    CHECK(read.line == 2);
    CHECK_FALSE(read.reid);
    CHECK(read.digits == ByName<int>{{"P", 2}, {"B", 0}, {"T", 1}, {"N", 1}, {"F", 0}, {"S", 0},  {"V", 0},  {"L", 0},
                                     {"D", 2}, {"C", 2}, {"M", 0}, {"Z", 2}, {"E", 0}, {"M2", 1}, {"W2", 0}, {"X", 0},
                                     {"H", 0}, {"G", 0}, {"I", 0}, {"A", 0}, {"O", 0}, {"W", 0},  {"R", 1}});
    CHECK(real(read, "FN") == 1000);
    CHECK(real(read, "CKSI") == 0.004);
    CHECK(real(read, "SPINXO") == 0);
    CHECK(integer(read, "MAXGS") == 100);
    CHECK(real(read, "EPS") == 1e-6);
    CHECK(real(read, "GG2") == 82000);
    CHECK(integer(read, "MX") == 4);
    CHECK(real(read, "YL") == -0.75);
    CHECK(real(read, "B3") == 0.002);
    CHECK_FALSE(read.values.contains("PEN"));
    CHECK(*read.friction == ContactFrictionSets{{{"FSTAT", 0.3}, {"FKIN", 0.3}}});
    CHECK(integer(read, "FRCLAW") == 0);
    CHECK(read.warnings.empty());
}

TEST_CASE("values of a group may stand on several lines, and what follows them is a remark", "[contact_files]") {
    BasicCase text;
    text.load = "% the force\n1000.\n 0.004 % creepage\n\n 0., 0. this is no number 7\n";
    CHECK(real(last_of(text.text()), "CKSI") == 0.004);
}

TEST_CASE("digits decide which load is read", "[contact_files]") {
    BasicCase text;
    text.digits = "201020\n022020\n000001\n";
    text.load = "0.01 0.5 -0.25 0.001 1.5 2.5 spin's centre\n";
    const ContactCase read = last_of(text.text());
    CHECK(real(read, "PEN") == 0.01);
    CHECK(real(read, "FX") == 0.5);
    CHECK(real(read, "FY") == -0.25);
    CHECK(real(read, "SPINYO") == 2.5);
    text.load = "0.01 0.5 -0.25 0.001 1.5 centre\n";
    const ContactCase alone = last_of(text.text());
    CHECK(real(alone, "SPINXO") == 0);
    CHECK(alone.warnings.size() == 1);
}

TEST_CASE("rolling has its direction, step and speed, with the place of spin by default", "[contact_files]") {
    BasicCase text;
    text.digits = "203100\n022020\n000001\n";
    text.rolling = "180.d 0.5 30000.\n";
    const ContactCase read = last_of(text.text());
    CHECK_THAT(real(read, "CHI"), WithinRel(std::numbers::pi, 1e-15));
    CHECK(real(read, "FACPHI") == 1.0 / 6);
}

TEST_CASE("shifts leave direction, step and speed of their own", "[contact_files]") {
    const ContactCase read = last_of(BasicCase{}.text());
    CHECK(real(read, "CHI") == 0);
    CHECK(real(read, "DQ") == 1);
    CHECK(real(read, "VELOC") == 1);
}

TEST_CASE("a case keeps what it does not read", "[contact_files]") {
    const std::string next = "3 MODULE\n001100\n100000\n101001\n900. 0.005 0. 0.\n";
    const ContactCase read = last_of(BasicCase{}.text() + next);
    CHECK(read.number == 2);
    CHECK(read.digits.at("P") == 0);
    CHECK(real(read, "FN") == 900);
    CHECK(integer(read, "MX") == 4);
    CHECK(real(read, "B3") == 0.002);
    CHECK(integer(read, "GAUSEI") == 0);
    CHECK(integer(read, "FRCLAW") == 0);
    CHECK(read.friction->size() == 1);
    CHECK(read.read == std::vector<std::string>{"CETA", "CKSI", "CPHI", "FN", "SPINXO", "SPINYO"});
}

TEST_CASE("without a line of a module the next case follows", "[contact_files]") {
    BasicCase first;
    first.digits = "201100\n022020\n000000\n";
    const ContactFile file = read_all(first.text() + "001100\n100000\n101001\n900. 0.005 0. 0.\n" + end);
    REQUIRE(file.cases.size() == 2);
    CHECK(file.cases[1].errors.empty());
    CHECK(file.cases[1].line == 13);
    CHECK(file.warnings.empty());
}

TEST_CASE("result elements have memories and counters of their own", "[contact_files]") {
    BasicCase one, two, third;
    one.module = "3 7 MODULE\n";
    two.module = "3 7 2 MODULE\n";
    two.grid = "1\n8 8 -1. -1. .25 .25\n";
    const std::string next = "3 7 MODULE\n001100\n100000\n101001\n900. 0.005 0. 0.\n";
    const ContactFile file = read_all(one.text() + two.text() + next + third.text() + RailCase{}.text() + end);
    REQUIRE(file.cases.size() == 5);
    CHECK(file.cases[0].reid == 7);
    CHECK(file.cases[0].cpid == 1);
    CHECK(file.cases[1].cpid == 2);
    CHECK(file.cases[2].number == 3);
    CHECK(file.cases[2].errors.empty());
    CHECK(integer(file.cases[2], "MX") == 4);
    CHECK(file.cases[3].number == 1);
    CHECK(file.cases[4].number == 2);
    CHECK(file.cases[4].errors.empty());
}

TEST_CASE("the first case of a history begins from nothing", "[contact_files]") {
    BasicCase text;
    text.digits = "001100\n022020\n010001\n";
    const ContactFile file = read_all(text.text() + end);
    CHECK(file.cases[0].digits.at("P") == 2);
    CHECK(file.cases[0].digits.at("I") == 0);
    CHECK(file.cases[0].warnings.size() == 2);
    CHECK(file.cases[0].errors.empty());
}

TEST_CASE("bodies alike set the bound of outer iterations to one, which stays", "[contact_files]") {
    BasicCase first;
    first.solver = "100 30 5 20 1e-6\n";
    CHECK(integer(last_of(first.text()), "MAXOUT") == 1);
    first.material = ".28 .28 82000. 8200.\n";
    CHECK(integer(last_of(first.text()), "MAXOUT") == 20);
}

TEST_CASE("a wheel on its rail has its values by the names of CONTACT", "[contact_files]") {
    const ContactCase read = last_of(RailCase{}.text());
    CHECK(read.digits.at("C1") == 1);
    CHECK(integer(read, "NPOT_MAX") == 20000);
    CHECK(real(read, "DS") == 0.25);
    CHECK_THAT(real(read, "A_SEP"), WithinRel(std::numbers::pi / 2, 1e-15));
    CHECK(real(read, "D_TURN") == 12);
    CHECK(real(read, "G_MISS") == -1);
    CHECK(real(read, "GAUGWD") == 1435);
    CHECK(real(read, "CANT") == 0.025);
    CHECK(real(read, "CURV") == 0);
    CHECK(std::get<std::string>(read.values.at("RFNAME")) == "rail.prr");
    CHECK(integer(read, "RAIL_MIRRORZ") == 0);
    CHECK(integer(read, "WHEEL_MIRRORZ") == -1);
    CHECK(real(read, "WHEEL_SMOOTH") == 10);
    CHECK_THAT(real(read, "RAIL_KINKHIGH"), WithinRel(std::numbers::pi / 6, 1e-15));
    CHECK_THAT(real(read, "DROLLR"), WithinRel(std::numbers::pi / 120, 1e-15));
    CHECK(real(read, "FZ") == 10000);
    CHECK(real(read, "VPITCH") == -4.348);
    CHECK_FALSE(read.values.contains("YTAPE"));
}

TEST_CASE("a track without gauge has the rail's origin", "[contact_files]") {
    RailCase text;
    text.track = "-1. 750. 0.5 0. 1e-6\n";
    const ContactCase read = last_of(text.text());
    CHECK(real(read, "RAILY0") == 750);
    CHECK(real(read, "RAILZ0") == 0.5);
    CHECK(real(read, "CURV") == 1e-6);
    CHECK_FALSE(read.values.contains("GAUGWD"));
}

TEST_CASE("a roller has its radius, and the wheel no place along it", "[contact_files]") {
    RailCase text;
    text.digits = "5203100\n0022033\n0000001\n";
    text.track = "-1. 0. 0. 500.\n";
    const ContactCase read = last_of(text.text());
    CHECK(real(read, "NOMRADR") == 500);
    CHECK(real(read, "RPITCH") == 2000);
    CHECK(read.values.contains("X_WS"));
    CHECK_FALSE(read.values.contains("CANT"));
}

TEST_CASE("the cant of a rail stays in force on the roller of a later case", "[contact_files]") {
    RailCase roller;
    roller.digits = "5203100\n0022033\n0000001\n";
    roller.track = "-1. 0. 0. 500.\n";
    const ContactCase read = last_of(RailCase{}.text() + roller.text());
    CHECK(real(read, "NOMRADR") == 500);
    CHECK(real(read, "CANT") == 0.025);
}

TEST_CASE("profiles have more options where PRFOPT says so", "[contact_files]") {
    RailCase text;
    text.rail = "'rail.slcs' 1 1000. 5. 1 2\n1 100d 20d 4d 1.5\n-2 0.25\n";
    const ContactCase read = last_of(text.text());
    CHECK(integer(read, "RAIL_ISMOOTH") == 1);
    CHECK_THAT(real(read, "RAIL_ZIGTHRS"), WithinRel(std::numbers::pi / 1.8, 1e-15));
    CHECK(real(read, "RAIL_KINKWID") == 1.5);
    CHECK(integer(read, "RAIL_ERRHND") == -2);
    CHECK(real(read, "RAIL_MAXOMIT") == 0.25);
    CHECK(integer(read, "WHEEL_ISMOOTH") == 0);
}

TEST_CASE("springs and forces of the wheelset are read by F", "[contact_files]") {
    RailCase springs;
    springs.digits = "1203130\n0022033\n0000001\n";
    springs.deviation += "100. -5. 200. -1e4 0.5\n";
    CHECK(real(last_of(springs.text()), "DYSTEP0") == 0.5);
    RailCase force;
    force.digits = "1203110\n0022033\n0000001\n";
    const ContactCase read = last_of(force.text());
    CHECK(real(read, "FX") == -4.348);
    CHECK_FALSE(read.values.contains("VPITCH"));
}

TEST_CASE("flexible wheelsets bend at every later case", "[contact_files]") {
    RailCase first;
    first.digits = "1203100\n0022035\n0000001\n";
    first.rest = "0. 0.5 0. 1d 0. 0.\n0. 0. 0. 0. 0. 0.\n";
    const ContactCase read = last_of(first.text() + "1 MODULE\n1203100\n0101001\n0100001\n0. 2. 9000. 0. 0. 0.\n");
    CHECK(real(read, "DYWHL") == 0.5);
    CHECK(real(read, "VS") == 2000);
    CHECK(real(read, "FZ") == 9000);
}

TEST_CASE("a line of debug digits is read where X says so", "[contact_files]") {
    RailCase text;
    text.digits = "1203100\n0022033\n10000001\n 1010000\n";
    const ContactCase read = last_of(text.text());
    CHECK(read.digits.at("X") == 1);
    CHECK(real(read, "VS") == 2000);
}

TEST_CASE("damping stands behind the second control word", "[contact_files]") {
    BasicCase text;
    text.digits = "201100\n022020 12 L-D-C-M-Z-E M2\n000001\n";
    text.more = "0.1 0.2 300. 400.\n";
    const ContactCase read = last_of(text.text());
    CHECK(read.digits.at("M2") == 2);
    CHECK(read.digits.at("W2") == 1);
    CHECK(real(read, "DFTMAX") == 400);
}
