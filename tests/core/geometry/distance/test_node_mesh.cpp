// Tests surfaces between nodes: straight, and by cubics.
#include "geometry/distance/node_mesh.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

using Catch::Matchers::WithinAbs;
using namespace contactd::geometry;

namespace {

/// Creates inclined, irregular nodes about 1 mm apart, with the heights of a function.
template <class Height>
NodeMesh mesh_of(const Height& height, NodeMesh::Between between, double lean = 0.1) {
    std::vector<Vector3> nodes;
    for (int j = 0; j < 9; ++j)
        for (int i = 0; i < 7; ++i) {
            const double x = i + lean * j, y = j - lean * i + 0.02 * lean * i * j;
            nodes.push_back({x, y, height(x, y)});
        }
    return {7, nodes, between};
}

}  // namespace

TEST_CASE("Between nodes a plane is a plane, wherever the nodes are") {
    const auto plane = [](double x, double y) { return 3 + 0.2 * x - 0.7 * y; };
    const auto between = GENERATE(NodeMesh::Between::straight, NodeMesh::Between::cubic);
    const double lean = between == NodeMesh::Between::straight ? 0.1 : 0.0;
    NodeMesh mesh = mesh_of(plane, between, lean);
    for (const double x : {1.0, 2.37, 5.2, 1.7})
        for (const double y : {4.4, 1.0, 6.9}) CHECK_THAT(mesh.height(x, y), WithinAbs(plane(x, y), 1e-12));
}

TEST_CASE("At nodes a surface has their heights, and half-way between two of them its kind decides") {
    const auto bowl = [](double x, double y) { return 0.1 * x * x + 0.3 * y * y; };
    NodeMesh straight = mesh_of(bowl, NodeMesh::Between::straight, 0),
             cubic = mesh_of(bowl, NodeMesh::Between::cubic, 0);
    CHECK_THAT(straight.height(3, 4), WithinAbs(bowl(3, 4), 1e-12));
    CHECK_THAT(cubic.height(3, 4), WithinAbs(bowl(3, 4), 1e-12));
    // Chords of a parabola lie an eighth of its second difference above it, and cubics are exact.
    CHECK_THAT(straight.height(3.5, 4), WithinAbs(bowl(3.5, 4) + 0.1 / 4, 1e-12));
    CHECK_THAT(cubic.height(3.5, 4.25), WithinAbs(bowl(3.5, 4.25), 1e-12));
    // At the border, only the slope of the last side is available.
    CHECK_THAT(cubic.height(0.5, 4), WithinAbs(bowl(0.5, 4) + 0.1 / 8, 1e-12));
}

TEST_CASE("Beside the nodes there is no height, and behind that heights are found again") {
    NodeMesh mesh = mesh_of([](double x, double) { return x; }, NodeMesh::Between::straight, 0);
    for (const double x : {-0.1, 6.1, 400.0}) {
        CHECK(std::isnan(mesh.height(x, 4)));
        CHECK_THAT(mesh.height(2.5, 4), WithinAbs(2.5, 1e-12));
    }
    CHECK(std::isnan(mesh.height(3, -0.5)));
    CHECK(std::isnan(mesh.height(3, 8.5)));
    CHECK_THAT(mesh.height(6, 8), WithinAbs(6, 1e-12));
    CHECK_THAT(mesh.height(0, 0), WithinAbs(0, 1e-12));
}
