#include "geometry/section/mesh_outline.hpp"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "section_cases.hpp"

using namespace contactd;
using namespace contactd::geometry;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;

namespace {

bool has_vertex(const OutlineLoop& loop, double s, double near) {
    return std::any_of(loop.begin(), loop.end(), [&](const OutlineEdge& edge) {
        return std::abs(edge.begin - s) < near || std::abs(edge.end - s) < near;
    });
}

}  // namespace

TEST_CASE("Edges of an outline follow each other all round", "[section]") {
    const SectionCase test = GENERATE(ready_made());
    CAPTURE(test.name);
    const SectionGeometry section = test.geometry();
    const auto loops = mesh_outline(section, {});
    REQUIRE(loops.size() == section.curves().size());
    for (std::size_t i = 0; i < loops.size(); ++i) {
        CHECK(loops[i].front().begin == 0);
        CHECK(loops[i].back().end == section.curves()[i].length());
        for (std::size_t k = 0; k < loops[i].size(); ++k) {
            const OutlineEdge& edge = loops[i][k];
            CHECK(edge.end > edge.begin);
            if (k > 0) CHECK(edge.begin == loops[i][k - 1].end);
            const OutlinePlace place = section.curves()[i].place(edge.begin);
            CHECK(place.at == edge.at);
        }
        CHECK(loops[i].size() < 3000);
    }
}

TEST_CASE("Columns end and have their midpoints at vertices, joints and held parts too", "[section]") {
    const SectionCase test = GENERATE(ready_made());
    CAPTURE(test.name);
    const SectionGeometry section = test.geometry();
    const auto loops = mesh_outline(section, {});
    const OutlineLoop& loop = loops[section.carrier_index()];
    const double near = 1e-6 * test.ds;
    for (int half = 0; half <= 2 * test.columns; ++half)
        CHECK(has_vertex(loop, section.carrier().reduced(section.begin_of(0) + half * test.ds / 2), near));
    for (int column = 0; column < test.columns; ++column) {
        double length = 0;
        for (const OutlineEdge& edge : loop)
            if (edge.column == column) length += edge.end - edge.begin;
        CHECK_THAT(length, WithinAbs(test.ds, 3 * near));
    }
    for (std::size_t i = 0; i < loops.size(); ++i) {
        const ClosedCurve& curve = section.curves()[i];
        double held = 0, held_edges = 0;
        for (std::size_t k = 0; k < curve.pieces().size(); ++k) {
            CHECK(has_vertex(loops[i], curve.begin_of(k), near));
            if (curve.pieces()[k].held()) held += curve.pieces()[k].length();
        }
        for (const OutlineEdge& edge : loops[i])
            if (edge.held) held_edges += edge.end - edge.begin;
        CHECK_THAT(held_edges, WithinAbs(held, 1e-9 * curve.length()));
    }
}

TEST_CASE("Edges are as long as wanted, and neighbours alike", "[section]") {
    const SectionCase test = GENERATE(ready_made());
    CAPTURE(test.name);
    const SectionGeometry section = test.geometry();
    const MeshSizes sizes;
    const EdgeLengths lengths(section, sizes);
    const auto loops = mesh_outline(section, sizes);
    for (std::size_t i = 0; i < loops.size(); ++i)
        for (const OutlineEdge& edge : loops[i]) {
            const OutlinePlace middle = section.curves()[i].place((edge.begin + edge.end) / 2);
            CHECK(edge.end - edge.begin < 1.3 * lengths.at(middle.at));
            CHECK((edge.end - edge.begin) * std::abs(middle.curvature) < 1.3 * sizes.most_turn);
        }
}

TEST_CASE("Edges are short beside columns and at re-entrant corners, and long elsewhere", "[section]") {
    const SectionGeometry section({RailSection{0, RailSupport::cut, 2}}, 80, 0.5);
    const EdgeLengths lengths(section, {});
    CHECK_THAT(lengths.at(section.carrier().place(section.begin_of(10)).at), WithinAbs(0.125, 1e-12));
    const OutlinePlace cut = section.carrier().place(0);
    CHECK(lengths.at(cut.at) < 0.05);
    CHECK(lengths.at({0, -30}) > 5);
}
