#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <random>
#include <set>

#include "contactd/fields/ic_spec.hpp"
#include "fem_specs.hpp"
#include "mesh/prism_block.hpp"

using namespace contactd;
using namespace contactd::fem;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

IcSpec uniform_spec(double dx, double dy, Diagonal diagonal = Diagonal::outward) {
    IcSpec spec = coarse_spec(3, 3, dx, dy);
    spec.fem.mesh = MeshKind::prism;
    spec.fem.diagonal = diagonal;
    return spec;
}

double block_size(const IcSpec& spec) {
    return spec.fem.L_over_h * std::max(spec.dx, spec.dy);
}

/// Returns distances from the origin along each axis.
std::array<double, 3> at(mfem::Mesh& mesh, const ElementPoint& place) {
    mfem::Vector position;
    mesh.GetElementTransformation(place.element)->Transform(place.point, position);
    return {-position[0], -position[1], -position[2]};
}

std::array<double, 5> boundary_areas(mfem::Mesh& mesh) {
    std::array<double, 5> areas{};
    for (int i = 0; i < mesh.GetNBE(); ++i) {
        mfem::ElementTransformation& map = *mesh.GetBdrElementTransformation(i);
        map.SetIntPoint(&mfem::Geometries.GetCenter(mesh.GetBdrElementGeometry(i)));
        const double reference = mesh.GetBdrElementGeometry(i) == mfem::Geometry::TRIANGLE ? 0.5 : 1;
        areas[static_cast<std::size_t>(mesh.GetBdrAttribute(i) - 1)] += reference * map.Weight();
    }
    return areas;
}

std::set<int> triangle_of(const mfem::Mesh& mesh, int element) {
    mfem::Array<int> vertices;
    mesh.GetElementVertices(element, vertices);
    return {vertices[0], vertices[1], vertices[2]};
}

double distance(const mfem::Mesh& mesh, int vertex) {
    return std::hypot(mesh.GetVertex(vertex)[1], mesh.GetVertex(vertex)[2]);
}

}  // namespace

TEST_CASE("Prisms are as many as the paper's rule makes", "[fem][mesh][prism]") {
    struct Row {
        const char* preset;
        double L;
        int elements, dofs;
    };
    const Row row = GENERATE(Row{"paper-mesh2-test2", 128, 4080, 54915}, Row{"paper-mesh2-test2", 256, 5168, 69147},
                             Row{"paper-mesh2-test3", 64, 9984, 131811});
    CAPTURE(row.preset, row.L);
    const IcSpec spec = dimensionless(paper_spec(row.preset, row.L));
    BlockMesh block = make_prism_block(spec);
    CHECK(block.mesh.GetNE() == row.elements);
    CHECK(block.mesh.GetNE() == mesh_size(spec).elements);
    mfem::H1_FECollection elements(2, 3);
    CHECK(mfem::FiniteElementSpace(&block.mesh, &elements, 3).GetTrueVSize() == row.dofs);
}

TEST_CASE("Prisms fill the block and none is inverted", "[fem][mesh][prism]") {
    const auto diagonal = GENERATE(Diagonal::outward, Diagonal::across);
    const IcSpec spec = uniform_spec(1, GENERATE(0.25, 1.0, 4.0), diagonal);
    BlockMesh block = make_prism_block(spec);
    double volume = 0, smallest = 1e300;
    for (int i = 0; i < block.mesh.GetNE(); ++i) {
        mfem::ElementTransformation& map = *block.mesh.GetElementTransformation(i);
        map.SetIntPoint(&mfem::Geometries.GetCenter(mfem::Geometry::PRISM));
        const double jacobian = map.Jacobian().Det();
        smallest = std::min(smallest, jacobian);
        volume += jacobian / 2;
    }
    CHECK(smallest > 0);
    CHECK_THAT(volume, WithinRel(std::pow(block_size(spec), 3), 1e-12));
}

TEST_CASE("Faces of the prisms' block have their areas", "[fem][mesh][prism]") {
    IcSpec spec = uniform_spec(1, GENERATE(0.25, 1.0, 4.0), GENERATE(Diagonal::outward, Diagonal::across));
    spec.load_shape = GENERATE(LoadShape::constant, LoadShape::bilinear);
    CAPTURE(spec.dy, name_of(spec.fem.diagonal), name_of(spec.load_shape));
    BlockMesh block = make_prism_block(spec);
    const double face = std::pow(block_size(spec), 2);
    const double load = spec.dx * spec.dy / (spec.load_shape == LoadShape::constant ? 4 : 1);
    const std::array<double, 5> areas = boundary_areas(block.mesh);
    const auto area = [&](BoundaryPart part) { return areas[static_cast<std::size_t>(part) - 1]; };
    CHECK_THAT(area(BoundaryPart::front), WithinRel(face, 1e-12));
    CHECK_THAT(area(BoundaryPart::right), WithinRel(face, 1e-12));
    CHECK_THAT(area(BoundaryPart::loaded), WithinRel(load, 1e-12));
    CHECK_THAT(area(BoundaryPart::free), WithinRel(face - load, 1e-12));
    CHECK_THAT(area(BoundaryPart::far), WithinRel(3 * face, 1e-12));
}

TEST_CASE("Oblong elements stretch the prisms' cube along each axis", "[fem][mesh][prism]") {
    const IcSpec spec = uniform_spec(4, 1);
    const BlockMesh block = make_prism_block(spec);
    mfem::Array<int> vertices;
    block.mesh.GetElementVertices(0, vertices);
    std::array<double, 3> farthest{};
    for (const int vertex : vertices)
        for (std::size_t a = 0; a < 3; ++a) farthest[a] = std::max(farthest[a], -block.mesh.GetVertex(vertex)[a]);
    CHECK(farthest == std::array<double, 3>{4 / 2.0, 1 / 2.0, 2 / 2.0});  // two elements per edge, sqrt(dx dy) deep
}

TEST_CASE("Every quadrilateral is cut by the diagonal asked for", "[fem][mesh][prism]") {
    const auto diagonal = GENERATE(Diagonal::outward, Diagonal::across);
    const IcSpec spec = uniform_spec(1, 1, diagonal);
    const BlockMesh block = make_prism_block(spec);
    const MeshSize size = mesh_size(spec);
    const int section = static_cast<int>(size.elements / (size.elements_per_edge + size.layers));
    for (int i = 0; i < section; i += 2) {
        const std::set<int> one = triangle_of(block.mesh, i), other = triangle_of(block.mesh, i + 1);
        std::vector<int> shared, all;
        std::set_intersection(one.begin(), one.end(), other.begin(), other.end(), std::back_inserter(shared));
        std::set_union(one.begin(), one.end(), other.begin(), other.end(), std::back_inserter(all));
        REQUIRE(shared.size() == 2);
        REQUIRE(all.size() == 4);
        const auto nearer = [&](int a, int b) { return distance(block.mesh, a) < distance(block.mesh, b); };
        const auto [nearest, farthest] = std::minmax_element(all.begin(), all.end(), nearer);
        const bool outward = std::set{*nearest, *farthest} == std::set{shared[0], shared[1]};
        CHECK(outward == (diagonal == Diagonal::outward));
    }
}

TEST_CASE("Prisms are numbered slice by slice from the origin", "[fem][mesh][prism]") {
    BlockMesh block = make_prism_block(uniform_spec(1, 1));
    double last = 0;
    bool ordered = true;
    for (int i = 0; i < block.mesh.GetNE(); ++i) {
        const double X = at(block.mesh, {i, mfem::Geometries.GetCenter(mfem::Geometry::PRISM)})[0];
        ordered = ordered && X >= last * (1 - 1e-12);
        last = X;
    }
    CHECK(ordered);
    CHECK(at(block.mesh, block.locate(0, 0)) == std::array<double, 3>{0, 0, 0});
    CHECK(block.locate(0, 0).element == 0);
}

TEST_CASE("A surface point is found in its prism", "[fem][mesh][prism]") {
    const double dy = GENERATE(1.0, 0.25, 7.0);
    const IcSpec spec = uniform_spec(1, dy, GENERATE(Diagonal::outward, Diagonal::across));
    BlockMesh block = make_prism_block(spec);
    const double L = block_size(spec);
    const auto check = [&](double X, double Y) {
        CAPTURE(X, Y);
        const ElementPoint place = block.locate(X, Y);
        const std::array<double, 3> back = at(block.mesh, place);
        CHECK_THAT(back[0], WithinAbs(X, 1e-14 * L));
        CHECK_THAT(back[1], WithinAbs(Y, 1e-14 * L));
        CHECK(back[2] == 0);
        CHECK(mfem::Geometry::CheckPoint(mfem::Geometry::PRISM, place.point));
    };
    std::mt19937 random(1);
    std::uniform_real_distribution<double> exponent(-8, 0);
    for (int i = 0; i < 500; ++i) check(L * std::exp(exponent(random)), L * std::exp(exponent(random)));
    for (const double X : {0.0, 0.5, 1.0, 2.0, L})
        for (const double Y : {0.0, 0.5 * dy, dy, 2 * dy, L}) check(X, Y);
}

TEST_CASE("A surface point between prisms is in the one towards the origin", "[fem][mesh][prism]") {
    BlockMesh block = make_prism_block(uniform_spec(1, 4));
    constexpr double inside = 1 - 1e-9;
    for (int i = 0; i < block.mesh.GetNV(); ++i) {
        const double* vertex = block.mesh.GetVertex(i);
        const double X = -vertex[0], Y = -vertex[1];
        if (vertex[2] != 0) continue;
        CAPTURE(X, Y);
        CHECK(block.locate(X, Y).element == block.locate(inside * X, inside * Y).element);
    }
}
