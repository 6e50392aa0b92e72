#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <limits>
#include <string>

#include "contactd/error.hpp"
#include "contactd/section.hpp"

using namespace contactd;
using Catch::Matchers::MessageMatches;
using Catch::Matchers::StartsWith;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

OutlineSection square() {
    return {.outside = {{-5, 0}, {{LineTo{{5, 0}}}, {LineTo{{5, -9}}}, {LineTo{{-5, -9}}, true}, {LineTo{{-5, 0}}}}}};
}

void refuses(const SectionShape& shape, const std::string& beginning) {
    CHECK_THROWS_MATCHES(validate(Section{shape}, "section"), InvalidArgument, MessageMatches(StartsWith(beginning)));
}

}  // namespace

TEST_CASE("Sections with numbers that can be used pass", "[section]") {
    const SectionShape shape = GENERATE(
        SectionShape{square()}, SectionShape{RailSection{1.0 / 40, RailSupport::foot, -3}},
        SectionShape{WheelRimSection{}}, SectionShape{EdgeBlock{100, 50, 0}}, SectionShape{Groove{10, 10, 120, 70}},
        SectionShape{RoundEnd{9.7, 60}}, SectionShape{Disc{10, 0.05}}, SectionShape{PlateHole{10, 500}},
        SectionShape{Slab{0.5, 60}}, SectionShape{ProfileSection{{ProfileKind::rail, ArcProfile{300}}, 40, 0}});
    CHECK_NOTHROW(validate(Section{shape}, "section"));
}

TEST_CASE("Numbers that no section can have are refused by their names", "[section]") {
    const double bad = GENERATE(nan, infinity, -infinity, -1.0, 0.0);
    refuses(EdgeBlock{bad, 50, 0}, "section.edge_block.width is ");
    refuses(EdgeBlock{100, bad, 0}, "section.edge_block.height is ");
    refuses(Groove{bad, 10, 120, 70}, "section.groove.radius is ");
    refuses(Groove{10, bad, 120, 70}, "section.groove.depth is ");
    refuses(RoundEnd{bad, 60}, "section.round_end.radius is ");
    refuses(RoundEnd{9.7, bad}, "section.round_end.length is ");
    refuses(Disc{bad, 0.1}, "section.disc.radius is ");
    refuses(PlateHole{10, bad}, "section.plate_hole.plate_radius is ");
    refuses(Slab{bad, 60}, "section.slab.thickness is ");
    refuses(WheelRimSection{bad, 0}, "section.rim_s1002.thickness is ");
    refuses(ProfileSection{{ProfileKind::rail, ArcProfile{300}}, bad, 0}, "section.profile_section.depth is ");
}

TEST_CASE("Numbers of a section that contradict each other are refused", "[section]") {
    refuses(EdgeBlock{100, 50, -0.1}, "section.edge_block.edge_distance is -0.1");
    refuses(EdgeBlock{100, 50, 100}, "section.edge_block.edge_distance is 100");
    refuses(EdgeBlock{100, 50, nan}, "section.edge_block.edge_distance is nan");
    refuses(Groove{10, 11, 120, 70}, "section.groove.depth is 11; it must not exceed the radius, 10");
    refuses(Groove{10, 10, 120, 10}, "section.groove.depth is 10; it must be less than the height");
    refuses(Groove{10, 10, 20, 70}, "section.groove.width is 20");
    refuses(Disc{10, 10}, "section.disc.core is 10");
    refuses(PlateHole{10, 10}, "section.plate_hole.radius is 10");
    refuses(RailSection{0.3}, "section.rail_60e1.inclination is 0.3");
    refuses(RailSection{0, RailSupport::cut, nan}, "section.rail_60e1.from is nan");
}

TEST_CASE("What is wrong with a profile is named below its section", "[section]") {
    refuses(ProfileSection{{ProfileKind::rail, ArcProfile{0}}, 40, 0},
            "section.profile_section.profile.arc.radius is 0");
}

TEST_CASE("Outlines are refused where their numbers stand", "[section]") {
    OutlineSection section = square();
    section.outside.start.z = nan;
    refuses(section, "section.outline.outside.start.z is nan");
    section = square();
    section.outside.parts[1].curve = ArcTo{{5, -9}, 0};
    refuses(section, "section.outline.outside.parts[1].arc.radius is 0");
    section.outside.parts[1].curve = SplineTo{{{5, -3}, {infinity, -9}}};
    refuses(section, "section.outline.outside.parts[1].spline.through[1].y is inf");
    section.outside.parts[1].curve = SplineTo{};
    refuses(section, "section.outline.outside.parts[1].spline.through is empty");
    section.outside.parts.resize(1);
    refuses(section, "section.outline.outside.parts has 1");
    section = square();
    section.holes = {{{0, 0}, {}}};
    refuses(section, "section.outline.holes[0].parts has 0");
    section = square();
    section.carrier = 1;
    refuses(section, "section.outline.carrier is 1, with 0 holes");
    section.carrier = 0;
    section.part = 4;
    refuses(section, "section.outline.part is 4; the curve has the parts 0 to 3");
    section.part = 3;
    section.outside.parts.insert(section.outside.parts.begin(), most_outline_parts, OutlinePart{LineTo{{0, 0}}});
    refuses(section, "section.outline.outside.parts[2000] exceeds the limit of 2000");
}

TEST_CASE("An unconstrained section must be declared free", "[section]") {
    refuses(Disc{10, 0}, "section has no clamped part");
    OutlineSection section = square();
    section.outside.parts[2].clamped = false;
    refuses(section, "section has no clamped part");
    CHECK_NOTHROW(validate(Section{Disc{10, 0}, 1, 0, true}, "section"));
    CHECK_THROWS_MATCHES(validate(Section{Disc{10, 1}, 1, 0, true}, "section"), InvalidArgument,
                         MessageMatches(StartsWith("section.free is true, but a part is clamped")));
}

TEST_CASE("Equal bodies in other units are equal sections", "[section]") {
    const double third = 1.0 / 3;
    CHECK(scaled({EdgeBlock{100, 50, 0.25}}, third) == scaled({EdgeBlock{200, 100, 0.5}, 0.5}, third));
    CHECK(scaled({RailSection{0, RailSupport::cut, 2}}, 2) == Section{RailSection{0, RailSupport::cut, 2}, 2});
    const auto twice = std::get<OutlineSection>(scaled({square()}, 2).shape);
    CHECK(twice.outside.start == SectionPoint{-10, 0});
    CHECK(std::get<LineTo>(twice.outside.parts[1].curve).to == SectionPoint{10, -18});
    CHECK(twice.outside.parts[2].clamped);
}
