#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <limits>
#include <string>
#include <utility>

#include "contactd/error.hpp"
#include "contactd/strip_frames.hpp"
#include "geometry/section/section_geometry.hpp"

using namespace contactd;
using namespace contactd::geometry;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using Catch::Matchers::StartsWith;

namespace {

void refuses(const Section& section, const std::string& field, const std::string& sentence, int strips = 4,
             double ds = 0.5) {
    CHECK_THROWS_MATCHES(SectionGeometry(section, strips, ds), InvalidArgument,
                         MessageMatches(StartsWith(field + " ") && ContainsSubstring(sentence)));
}

OutlinePart line(double y, double z, bool clamped = false) {
    return {LineTo{{y, z}}, clamped};
}

// |y| <= 10, -20 <= z <= 0, strips from -5 on.
OutlineSection block() {
    return {.outside = {{-10, 0}, {line(10, 0), line(10, -20), line(-10, -20, true), line(-10, 0)}}, .from = 5};
}

Outline square_hole(double y, double z, double size) {
    return {{y, z}, {line(y, z - size), line(y + size, z - size), line(y + size, z), line(y, z)}};
}

}  // namespace

TEST_CASE("A sound outline with holes passes", "[section]") {
    OutlineSection section = block();
    section.holes = {square_hole(-8, -5, 3), square_hole(2, -5, 3)};
    CHECK_NOTHROW(SectionGeometry({section}, 10, 1));
    section.carrier = 2;
    section.part = 1;
    section.from = 1;
    CHECK(SectionGeometry({section}, 4, 0.25).frames()[0] == StripFrame{3.125, -8, 0});
}

TEST_CASE("Outlines that enclose no body are refused with coordinates", "[section]") {
    OutlineSection section = block();
    section.outside.parts.pop_back();
    refuses({section}, "section.outline.outside",
            "is not closed: it ends at (y, z) = (-10, -20), 20 mm from its start");
    section = block();
    section.outside.parts[1] = line(3, 0);
    refuses({section}, "section.outline.outside", "turns back on itself at (y, z) = (10, 0)");
    section.outside.parts[0] = line(10, -20);
    section.outside.parts[1] = line(10, 0);
    refuses({section}, "section.outline.outside", "crosses or touches itself at (y, z) = (0, -10)");
    section = block();
    section.outside.parts.insert(section.outside.parts.begin() + 1, line(10, 0));
    refuses({section}, "section.outline.outside.parts[1]", "has no length: it begins and ends at (y, z) = (10, 0)");
    section = block();
    section.outside.parts = {line(-10, -20), line(10, -20, true), line(10, 0), line(-10, 0)};
    refuses({section}, "section.outline.outside", "runs anticlockwise from (y, z) = (-10, 0)");
    section = block();
    section.outside.parts[1] = {ArcTo{{10, -20}, 9}};
    refuses({section}, "section.outline.outside.parts[1].arc.radius", "is 9, too small for an arc from");
    section.outside.parts[1] = {SplineTo{{{10, -10}, {10, -10}, {10, -20}}}};
    refuses({section}, "section.outline.outside.parts[1].spline", "points[2] equals the previous point");
}

TEST_CASE("Holes that do not lie in the body are refused with coordinates", "[section]") {
    OutlineSection section = block();
    section.holes = {square_hole(-8, -5, 3), square_hole(-7, -4, 3)};
    refuses({section}, "section.outline.holes[1]", "crosses or touches section.outline.holes[0] at (y, z) = (-");
    section.holes = {square_hole(-8, -5, 5), square_hole(-7, -6, 2)};
    refuses({section}, "section.outline.holes[1]", "overlaps section.outline.holes[0]");
    section.holes = {square_hole(-7, -6, 2), square_hole(-8, -5, 5)};
    refuses({section}, "section.outline.holes[1]", "overlaps section.outline.holes[0]");
    section.holes = {square_hole(20, -5, 5)};
    refuses({section}, "section.outline.holes[0]", "lies outside the body, at (y, z) = (20, -5)");
    section.holes = {square_hole(-2, -2e-5, 3)};
    refuses({section}, "section.outline.holes[0]",
            "leaves less than 4e-05 mm of the body between it and section.outline.outside at (y, z) = (");
    section.holes = {square_hole(8, -5, 5)};
    refuses({section}, "section.outline.holes[0]", "crosses or touches section.outline.outside at (y, z) = (10, ");
    section.holes = {square_hole(-8, -5, 2)};
    std::swap(section.holes[0].parts[0], section.holes[0].parts[2]);
    section.holes[0].parts = {line(-6, -5), line(-6, -7), line(-8, -7), line(-8, -5)};
    refuses({section}, "section.outline.holes[0]", "runs clockwise from (y, z) = (-8, -5)");
}

TEST_CASE("Strips that do not lie on a smooth free part are refused with coordinates", "[section]") {
    OutlineSection section = block();
    refuses({section}, "section", "has a corner of 90 degrees at (y, z) = (10, 0) in strip 30 of 40", 40);
    section.from = -1;
    refuses({section}, "section", "has a corner of 90 degrees at (y, z) = (-10, 0) in strip 2 of 4");
    section.part = 2;
    section.from = 3;
    refuses({section}, "section", "is clamped at (y, z) = (7, -20) in its strip 0 of 4");
    refuses({EdgeBlock{100, 50, 1}}, "section", "has a corner of 90 degrees at (y, z) = (-100, 0)", 10, 10);
    refuses({Groove{10, 10, 120, 70}}, "section", "has a corner of 90 degrees at (y, z) = (-10, 0) in strip 4 of 41",
            41, 1);
    refuses({Disc{10, 1}}, "section", "together 63 mm; their curve, which begins at (y, z) = (-10, 0), is only 62.8 mm",
            63, 1);
    refuses({RailSection{0, RailSupport::cut, 30}}, "section", "has a corner of", 100);
    CHECK_NOTHROW(SectionGeometry({EdgeBlock{100, 50, 0}}, 20, 0.5));
    CHECK_NOTHROW(SectionGeometry({EdgeBlock{100, 50, 0}}, 200, 0.5));
}

TEST_CASE("Strips that begin on another side of the body than `from` is counted on are refused", "[section]") {
    const std::string across = "crosses the clamped part at (y, z) = (";
    for (const double from : {200.0, 150.0, -150.0, -200.0})
        refuses({RailSection{0, RailSupport::cut, from}}, "section.rail_60e1.from", across);
    refuses({RailSection{0, RailSupport::foot, 550}}, "section.rail_60e1.from", "is 550; it crosses");
    refuses({RailSection{0, RailSupport::cut, 1000}}, "section.rail_60e1.from", "exceeds the length of the curve");
    OutlineSection section = block();
    section.from = 65;
    refuses({section}, "section.outline.from", across + "10, -20)");
    section.from = -45;
    refuses({section}, "section.outline.from", across);
    section.from = -15;
    CHECK_NOTHROW(SectionGeometry({section}, 4, 0.5));
    const ProfileSpec arc{ProfileKind::rail, ArcProfile{300, 0, -30, 30}};
    for (const double from : {31.0, -31.0, 500.0})
        refuses({ProfileSection{arc, 40, from}}, "section.profile_section.from", "reaches from -30.1 to 30.1 mm");
    CHECK_NOTHROW(SectionGeometry({ProfileSection{arc, 40, 20}}, 4, 0.5));
    for (const double from : {-100.0, 200.0})
        refuses({WheelRimSection{.from = from}}, "section.rim_s1002.from", "must begin on the profile");
    // Round bodies have no opposite side.
    OutlineSection disc{.outside = {{-10, 0}, {{ArcTo{{10, 0}, 10}}, {ArcTo{{-10, 0}, 10}}}}, .from = -5};
    disc.holes = {{{1, 0}, {{ArcTo{{-1, 0}, -1}, true}, {ArcTo{{1, 0}, -1}, true}}}};
    CHECK_NOTHROW(SectionGeometry({disc}, 4, 0.5));
}

TEST_CASE("A body ends with its strips at convex corners", "[section]") {
    const auto ends = [](const Section& section, int strips, double ds) {
        const StripEnds found = strip_ends(section, strips, ds);
        return std::pair(found.first, found.last);
    };
    CHECK(ends({EdgeBlock{100, 50, 0}}, 20, 0.5) == std::pair(false, true));
    CHECK(ends({EdgeBlock{100, 50, 0}}, 200, 0.5) == std::pair(true, true));
    CHECK(ends({EdgeBlock{100, 50, 1e-3}}, 20, 0.5) == std::pair(false, false));
    CHECK(ends({.shape = EdgeBlock{100, 50, 0}, .size = 0.7, .turn = 2}, 20, 0.35) == std::pair(false, true));
    CHECK(ends({RailSection{0, RailSupport::cut, 2}}, 20, 0.5) == std::pair(false, false));
    OutlineSection section = block();
    section.from = 0;
    CHECK(ends({section}, 3, 0.1) == std::pair(true, false));
    section.outside = {{-10, 0},
                       {line(10, 0), line(10, 5), line(20, 5), line(20, -20), line(-10, -20, true), line(-10, 0)}};
    CHECK(ends({section}, 200, 0.1) == std::pair(true, false));  // a hollow corner
}

TEST_CASE("Strips wider than the curvature allows are refused with coordinates", "[section]") {
    refuses({Groove{1, 1, 12, 7}}, "section", "too wide for the radius of 1 mm at (y, z) = (", 3, 0.6);
    refuses({Disc{1, 0.1}}, "section", "use strips of at most 0.5 mm there", 3, 0.6);
    refuses({RailSection{0, RailSupport::cut, 12}}, "section", "too wide for the radius of 13 mm", 3, 8);
}

TEST_CASE("Numbers of strips that can not be are refused", "[section]") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    refuses({EdgeBlock{100, 50, 0}}, "section", "has 0 strips", 0);
    refuses({EdgeBlock{100, 50, 0}}, "section", "has 1001 strips", 1001);
    refuses({EdgeBlock{100, 50, 0}}, "section", "has strips of the width nan", 4, nan);
    refuses({EdgeBlock{100, 50, 0}}, "section", "has strips of the width -1", 4, -1);
    refuses({Disc{10, 0}}, "section", "has no clamped part");
}

TEST_CASE("Profiles that do not fit their section are refused", "[section]") {
    refuses({ProfileSection{{ProfileKind::rail, ArcProfile{50, 0, -30, 30}}, 9, 0}}, "section.profile_section.depth",
            "is 9, but the profile reaches (y, z) = (-30, -10)");
    refuses({ProfileSection{{ProfileKind::wheel, S1002{}}, 2, 0}}, "section.profile_section.depth",
            "is 2, but the profile");
    ProfilePoints crossing;
    crossing.points = {{-20, 0}, {20, 0}, {20, -10}, {0, 10}, {-5, 20}};
    refuses({ProfileSection{{ProfileKind::rail, crossing}, 40, 0}}, "section.profile_section.profile.points", "cross");
    refuses({ProfileSection{{ProfileKind::rail, ArcProfile{100, 0, 5, 40}}, 9, 0}}, "section.profile_section.profile",
            "reaches from y = ");
}
