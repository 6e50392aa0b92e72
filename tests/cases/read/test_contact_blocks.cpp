// Tests every form of friction, material, gap, extra slip and points below the surface.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <numbers>
#include <string>

#include "contact_file_cases.hpp"

using namespace contactd;
using namespace contactd::contact_file_cases;
using Catch::Matchers::WithinRel;

TEST_CASE("each friction law has its own values, and a memory behind them", "[contact_files]") {
    BasicCase text;
    text.digits = "201100\n422020\n000001\n";
    text.friction = "0.2 0.1 50. 0. 0. falls with slip\n0.01 1.\n";
    const ContactCase read = last_of(text.text());
    CHECK(*read.friction ==
          ContactFrictionSets{{{"FKIN", 0.2}, {"F1", 0.1}, {"SABSH1", 50}, {"F2", 0}, {"SABSH2", 1e-4}}});
    CHECK(real(read, "MEMDST") == 0.01);
    CHECK(integer(read, "FRCLAW") == 4);
    text.digits = "203100\n622020\n3000001\n";
    text.friction = "0.3 0. -0.18 400.\n0. 1.\n";
    text.rolling = "0. 0.5 30000.\n";
    text.more = "0. 450. 50e-3 7.85e-6\n10. 450. 50e-3 7.85e-6\n";
    const ContactCase hot = last_of(text.text());
    CHECK(hot.friction->front().at("DFHEAT") == -0.18);
    CHECK(real(hot, "BKTEMP2") == 10);
}

TEST_CASE("friction varies by angle, along the track, or by rows", "[contact_files]") {
    RailCase rail;
    rail.digits = "1203100\n1022033\n0000001\n";
    rail.friction = "2 NVF\n-20d 0.2 0.2 gauge corner\n-10d 0.3 0.3\n";
    const ContactCase by_angle = last_of(rail.text());
    REQUIRE(by_angle.friction->size() == 2);
    CHECK_THAT(by_angle.friction->front().at("ALPHVF"), WithinRel(-std::numbers::pi / 9, 1e-15));
    rail.digits = "1203100\n2022033\n0000001\n";
    rail.friction = "2 NVF\n-20. 0.2 0.2\n10. 0.3 0.3\n";
    CHECK(last_of(rail.text()).friction->back().at("SVF") == 10);
    BasicCase alone;
    alone.digits = "201100\n3022020\n000001\n";
    alone.friction = "";
    alone.rest = "0.1 0.1\n0.2 0.2\n0.3 0.3\n";
    const ContactCase by_rows = last_of(alone.text());
    REQUIRE(by_rows.friction->size() == 3);
    CHECK(by_rows.friction->at(2) == ByName<double>{{"FSTAT", 0.3}, {"FKIN", 0.3}, {"IY", 3}});
}

TEST_CASE("each kind of material has its own values", "[contact_files]") {
    BasicCase text;
    const auto with = [&](const std::string& digits, const std::string& more) {
        text.digits = digits;
        text.more = more;
        return last_of(text.text());
    };
    CHECK(real(with("211100\n022020\n000001\n", "7e-5\n"), "FLXZ") == 7e-5);
    CHECK(real(with("201100\n022120\n000001\n", "1. 2. 3. 4.\n"), "TC2") == 4);
    CHECK(real(with("201100\n022220\n000001\n", "1. 2. 3. 4.\n"), "FLX") == 1);
    CHECK(real(with("201100\n022320\n000001\n", "1. 2. 3.\n"), "BETA") == 3);
    CHECK(real(with("201100\n022420\n000001\n", "1. 0. 0.5 -0.4\n"), "K_TAU") == -0.4);
    CHECK(real(with("201100\n022520\n000001\n", "1. 2. 3.\n"), "ALFA") == 2);
}

TEST_CASE("half-spaces that turn have angles over y", "[contact_files]") {
    BasicCase text;
    text.digits = "201100\n024020\n000001\n";
    text.material = "1 2 2 IF_METH VARIANT NN\n-1. -10d 1. 0.5r\n" + text.material;
    const ContactCase read = last_of(text.text());
    CHECK(integer(read, "VARIANT") == 2);
    CHECK(numbers(read, "ANGLE_Y") == std::vector<double>{-1, 1});
    CHECK_THAT(numbers(read, "ANGLE")[0], WithinRel(-std::numbers::pi / 18, 1e-15));
}

TEST_CASE("coefficients may come from a file, whose name is text", "[contact_files]") {
    BasicCase text;
    text.digits = "201100\n029020\n000001\n";
    text.material = "'coefficients.txt' of a finite-element program\n" + text.material;
    CHECK(std::get<std::string>(last_of(text.text()).values.at("CFNAME")) == "coefficients.txt");
}

TEST_CASE("each kind of potential contact has its own values", "[contact_files]") {
    const auto with = [](const std::string& grid, bool is_hertzian) {
        BasicCase text;
        text.grid = grid;
        if (is_hertzian) text.gap = "";
        return last_of(text.text());
    };
    CHECK(real(with("-1\n4 3 0.001 0.002 1.2\n", true), "B1") == 0.002);
    CHECK(real(with("-2\n4 3 0.001 0.5 1.2\n", true), "AOB") == 0.5);
    CHECK(real(with("-3\n4 3 1. 2. 1.2\n", true), "BB") == 2);
    CHECK(real(with("-4\n4 3 0.001 2. 1.2\n", true), "A1") == 0.001);
    CHECK(real(with("-5\n4 3 1. 2. 1.2\n", true), "SCALE") == 1.2);
    CHECK(real(with("-6\n4 3 1. 2. 3. 1.2\n", true), "BPOS") == 3);
    CHECK(real(with("2\n4 3\n-1. -.75\n1. .75\n", false), "YH") == 0.75);
    CHECK(real(with("3\n4 3 -1. -.75 .5 .5\n", false), "XC1") == -1);
    CHECK(real(with("4\n4 3 -1. -.75 1. .75\n", false), "YCM") == 0.75);
}

TEST_CASE("a grid takes the place of another kind, and Hertz's of the gap", "[contact_files]") {
    BasicCase first, second;
    second.grid = "-1\n4 3 0.001 0.002 1.2\n";
    second.gap = "";
    const ContactCase read = last_of(first.text() + second.text());
    CHECK_FALSE(read.values.contains("XL"));
    CHECK_FALSE(read.values.contains("IBASE"));
    CHECK_FALSE(read.values.contains("B3"));
    CHECK(real(read, "B1") == 0.002);
    CHECK_FALSE(last_of(second.text() + first.text()).values.contains("SCALE"));
}

TEST_CASE("each form of the undeformed distance is read", "[contact_files]") {
    BasicCase text;
    text.gap = "2 1\n3 0.5 100. -1. 1. NN XM RM Y1 DY1\n0.1 0.\n0.2 heights\n";
    CHECK(numbers(last_of(text.text()), "HEIGHTS") == std::vector<double>{0.1, 0, 0.2});
    text.gap = "3 1\n1 2 3 4 5 6 7 8\n";
    CHECK(real(last_of(text.text()), "B8") == 8);
    text.gap = "9 1\n1 2 3 4\n5 6 7 8\n\n9 10 11 12 the end\n";
    CHECK(numbers(last_of(text.text()), "GAP").size() == 12);
    text.gap = "1 2\n1 2 3 4 5 6\n7 8 9 10 11 12\n";
    CHECK(real(last_of(text.text()), "P6") == 12);
    text.gap = "1 3\n1 2 3 4 5 6\n-1 0 -1 0\n0 1 0 1\n";
    CHECK(real(last_of(text.text()), "YH2") == 1);
    text.gap = "1 4\n1 2 3 4 5 6\n2 patches\n-1 0 -1 0 left\n0 1 0 1 right\n0.5 f12\n";
    const ContactCase patches = last_of(text.text());
    CHECK(numbers(patches, "PATCH_LIMITS") == std::vector<double>{-1, 0, -1, 0, 0, 1, 0, 1});
    CHECK(numbers(patches, "PATCH_FACTORS") == std::vector<double>{0.5});
}

TEST_CASE("extra slip has two values an element", "[contact_files]") {
    BasicCase text;
    text.digits = "201100\n022029\n000001\n";
    for (int i = 0; i < 12; ++i) text.rest += std::to_string(i) + " " + std::to_string(100 + i) + "\n";
    const ContactCase read = last_of(text.text());
    CHECK(numbers(read, "SLIP_X").at(11) == 11);
    CHECK(numbers(read, "SLIP_Y").at(11) == 111);
}

TEST_CASE("points below the surface come in blocks", "[contact_files]") {
    BasicCase text;
    text.digits = "201103\n022020\n000001\n";
    text.rest =
        "2 1 A, O\n1 ISUBS\n3 1e-6 0.5\n2\n1 2 5\n1 1 2\n2 0.1 0.1\n7\n2 1\n3 1\n2\n2\n0.5 0.25\n9\n2 1 3\n0.4 "
        "0.\n0.\n1. -1. 0.2\n0\n";
    const ContactCase read = last_of(text.text());
    CHECK(integer(read, "SUBS_A") == 2);
    REQUIRE(read.subsurface->size() == 4);
    const ContactBlocks& blocks = *read.subsurface;
    CHECK(numbers(blocks[0].at("Z")) == std::vector<double>{1e-6, 0.500001, 1.000001});
    CHECK(numbers(blocks[1].at("IX")) == std::vector<double>{1, 3, 5});
    CHECK(numbers(blocks[2].at("IX")) == std::vector<double>{1, 3});
    CHECK(numbers(blocks[2].at("Z")) == std::vector<double>{0.25, 0.5});
    CHECK(numbers(blocks[3].at("X")) == std::vector<double>{0, 0.4});
    CHECK(numbers(blocks[3].at("Z")) == std::vector<double>{-1, 0.2, 1});
    const ContactCase kept = last_of(text.text() + "3 MODULE\n201101\n100000\n100001\n900. 0. 0. 0.\n");
    REQUIRE(kept.subsurface);
    REQUIRE(kept.subsurface->size() == 4);
    CHECK(numbers(kept.subsurface->at(3).at("X")) == numbers(blocks[3].at("X")));
}

TEST_CASE("values of solvers are read by G", "[contact_files]") {
    BasicCase text;
    text.digits = "201100\n022020\n200001\n";
    text.solver += "0.8 0.8 1.0 0.9\n";
    CHECK(integer(last_of(text.text()), "INISLP") == 1);
    text.digits = "201100\n022020\n400001\n";
    text.solver = "100 30 5 1 1e-6\n-1 0.9\n";
    CHECK(integer(last_of(text.text()), "INISLP") == -1);
    text.digits = "201100\n022020\n500001\n";
    text.solver = "100 30 5 1 1e-6\n1. 2. 3 4. 5. 6. 7. 8.\n";
    CHECK(real(last_of(text.text()), "POW_S") == 8);
}
