#include "geometry/section/section_geometry.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

#include "contactd/error.hpp"
#include "contactd/strip_frames.hpp"
#include "section_cases.hpp"

using namespace contactd;
using namespace contactd::geometry;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using std::numbers::pi;

TEST_CASE("Curves of sections are measured by their arc length, with exact normals", "[section]") {
    const SectionCase test = GENERATE(ready_made());
    CAPTURE(test.name);
    const SectionGeometry section = test.geometry();
    for (const ClosedCurve& curve : section.curves()) {
        const double h = 1e-5 * curve.length() / static_cast<double>(curve.pieces().size());
        for (std::size_t i = 0; i < curve.pieces().size(); ++i)
            for (const double share : {0.1, 0.37, 0.62, 0.9}) {
                const OutlinePiece& piece = curve.pieces()[i];
                const double s = share * piece.length(), step = std::min(h, 1e-4 * piece.length());
                const OutlinePlace here = piece.place(s), before = piece.place(s - step),
                                   behind = piece.place(s + step);
                const double y = (behind.at.y - before.at.y) / (2 * step), z = (behind.at.z - before.at.z) / (2 * step);
                CHECK_THAT(y, WithinAbs(here.tangent().y, 1e-6));
                CHECK_THAT(z, WithinAbs(here.tangent().z, 1e-6));
                CHECK_THAT(here.normal().y, WithinAbs(-here.tangent().z, 1e-15));
                CHECK_THAT(principal(behind.angle - before.angle) / (2 * step),
                           WithinAbs(here.curvature, 1e-6 + 1e-3 * std::abs(here.curvature)));
                const OutlinePlace same = curve.place(curve.begin_of(i) + s - curve.length());
                CHECK_THAT(same.at.y, WithinAbs(here.at.y, 1e-9 * curve.length()));
            }
    }
}

TEST_CASE("Strips lie side by side, their frames at the midpoints of their arcs", "[section]") {
    const SectionCase test = GENERATE(ready_made());
    CAPTURE(test.name);
    const SectionGeometry section = test.geometry();
    const auto frames = section.frames();
    REQUIRE(frames.size() == static_cast<std::size_t>(test.strips));
    for (std::size_t i = 1; i < frames.size(); ++i) {
        const StripFrame &a = frames[i - 1], &b = frames[i];
        const double turn = b.angle - a.angle, middle = (a.angle + b.angle) / 2;
        const double chord = std::hypot(b.y - a.y, b.z - a.z);
        CHECK(std::abs(turn) < most_strip_turn);
        CHECK(chord <= test.ds * (1 + 1e-9));
        CHECK(chord >= test.ds * (1 - turn * turn));
        CHECK_THAT((b.y - a.y) / chord, WithinAbs(std::cos(middle), 0.1 * std::abs(turn) + 1e-3));
        CHECK_THAT((b.z - a.z) / chord, WithinAbs(-std::sin(middle), 0.1 * std::abs(turn) + 1e-3));
    }
}

TEST_CASE("The last strip of an edge block ends beside the edge", "[section]") {
    const auto frames = SectionGeometry({EdgeBlock{100, 50, 0.25}}, 20, 0.5).frames();
    CHECK_THAT(frames.back().y, WithinAbs(-0.5, 1e-12));
    CHECK_THAT(frames.front().y, WithinAbs(-10, 1e-12));
    for (const StripFrame& frame : frames) {
        CHECK(frame.z == 0);
        CHECK_THAT(frame.angle, WithinAbs(0, 1e-15));
    }
}

TEST_CASE("Strips of round bodies lie about the top, of hollow ones about the bottom", "[section]") {
    const auto check = [](const Section& section, double radius, double middle) {
        const auto frames = SectionGeometry(section, 41, 0.5).frames();
        for (int i = 0; i < 41; ++i) {
            const double angle = middle + (i - 20) * 0.5 / radius;
            const StripFrame& frame = frames[static_cast<std::size_t>(i)];
            CHECK_THAT(principal(frame.angle - angle), WithinAbs(0, 1e-12));
            CHECK_THAT(frame.y, WithinAbs(radius * std::sin(angle), 1e-11));
            CHECK_THAT(frame.z, WithinAbs(radius * std::cos(angle), 1e-11));
        }
    };
    check({Disc{10, 0.05}}, 10, 0);
    check({Disc{10, 0.05}, 1, pi}, 10, pi);
    check({RoundEnd{9.7, 60}}, 9.7, 0);
    check({RoundEnd{9.7, 60}, 1, pi}, 9.7, pi);
    check({PlateHole{10, 500}}, -10, 0);
    check({Groove{10, 10, 120, 70}}, -10, 0);
    check({Groove{5, 5, 60, 35}, 2}, -10, 0);
    check({Groove{10, 10, 120, 70}, 1, -0.3}, -10, -0.3);
}

TEST_CASE("The rail's arcs touch each other, and its gauge side follows from the crown", "[section]") {
    const SectionGeometry section({RailSection{0, RailSupport::cut, 2}}, 120, 0.5);
    const auto frames = section.frames();
    CHECK_THAT(frames[0].angle, WithinAbs(2.25 / 300, 1e-12));  // R300, from the top
    CHECK_THAT(frames[0].y, WithinAbs(300 * std::sin(2.25 / 300), 1e-10));
    CHECK_THAT(frames[40].angle - frames[39].angle, WithinAbs(0.5 / 80, 1e-12));
    CHECK_THAT(frames[60].angle - frames[59].angle, WithinAbs(0.5 / 13, 1e-12));
    CHECK_THAT(frames[119].angle, WithinAbs(pi / 2 - std::atan(0.05), 1e-12));
    double lowest = 0, widest = 0;
    for (const SectionPoint& point : section.carrier().points()) {
        lowest = std::min(lowest, point.z);
        widest = std::max(widest, std::abs(point.y));
    }
    CHECK_THAT(lowest, WithinAbs(-60, 1e-12));
    CHECK_THAT(widest, WithinAbs(37.15, 0.2));  // half of the head's width in EN 13674-1
}

TEST_CASE("An inclined rail is the same one, rotated towards the gauge", "[section]") {
    const auto upright = SectionGeometry({RailSection{0, RailSupport::cut, 2}}, 60, 0.5).frames();
    const auto inclined = SectionGeometry({RailSection{0.05, RailSupport::cut, 2}}, 60, 0.5).frames();
    for (std::size_t i = 0; i < upright.size(); ++i)
        CHECK_THAT(inclined[i].angle, WithinAbs(upright[i].angle - std::atan(0.05), 1e-12));
}

TEST_CASE("A wheel's rim lies above its tread and runs to the flange", "[section]") {
    const SectionGeometry section({WheelRimSection{60, -20}}, 80, 0.5);
    const auto frames = section.frames();
    CHECK_THAT(std::abs(frames[40].angle), WithinAbs(pi, 0.06));  // 20.25 mm from -20 mm, next to the tape circle
    CHECK_THAT(frames[40].y, WithinAbs(-0.25, 1e-3));
    CHECK_THAT(frames[40].z, WithinAbs(0, 0.02));
    CHECK(frames[0].y > 19);
    CHECK(frames[79].y < -19);
    CHECK(section.carrier().place(section.begin_of(40)).normal().z < -0.99);
}

TEST_CASE("Strips may lie all round a curve", "[section]") {
    const double ds = 20 * pi / 100;
    const SectionGeometry section({Disc{10, 0}, 1, 0, true}, 100, ds);
    CHECK_THAT(section.perimeter(), WithinAbs(20 * pi, 1e-12));
    const auto frames = section.frames();
    CHECK_THAT(frames.back().angle - frames.front().angle, WithinAbs(2 * pi * 0.99, 1e-9));
    CHECK(SectionGeometry({RoundEnd{9.7, 60}}, 20, 0.5).perimeter() == 0);
}

TEST_CASE("Frames follow from a section in one call", "[section]") {
    const Section rail{RailSection{0.025, RailSupport::cut, 2}};
    CHECK(strip_frames(rail, 80, 0.5) == SectionGeometry(rail, 80, 0.5).frames());
    CHECK_THROWS_AS(strip_frames(rail, 0, 0.5), InvalidArgument);
}

TEST_CASE("A profile's section carries strips where its profile lies", "[section]") {
    const auto rail =
        SectionGeometry({ProfileSection{{ProfileKind::rail, ArcProfile{80}}, 40, -2.5}}, 10, 0.5).frames();
    const auto wheel = SectionGeometry({ProfileSection{{ProfileKind::wheel, ArcProfile{-100}}, 60, -2.5}}, 10, 0.5);
    for (int i = 0; i < 10; ++i) {
        const double s = (i - 4.5) * 0.5;
        const auto at = static_cast<std::size_t>(i);
        CHECK_THAT(rail[at].angle, WithinAbs(s / 80, 1e-6));
        CHECK_THAT(rail[at].z, WithinAbs(80 * (std::cos(s / 80) - 1), 1e-6));
        CHECK_THAT(wheel.frames()[at].angle, WithinAbs(pi + s / 100, 1e-6));
        CHECK_THAT(wheel.frames()[at].y, WithinAbs(-100 * std::sin(s / 100), 1e-6));
    }
}
