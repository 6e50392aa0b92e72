#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include "contactd/contact_influence.hpp"
#include "contactd/half_space.hpp"
#include "contactd/rotated_strips.hpp"

using namespace contactd;

namespace {

const Material steel{82000, 0.28};

Body uniform_body() {
    Ics ics;
    ics.body = BodyShape::longitudinally_uniform;
    ics.section = Section{Slab{100, 100}};
    return {steel, ics};
}

BodyTable table_of(const Body& body, const Grid& grid) {
    if (body.section() != nullptr) return rotated_strips(*body.section(), grid, steel, LoadShape::constant);
    IcSpec spec;
    spec.material = steel;
    spec.dx = grid.dx;
    spec.dy = grid.dy;
    spec.nx = grid.nx;
    spec.ny = grid.ny;
    return half_space_table(spec);
}

}  // namespace

TEST_CASE("what operators are expected to take is what they say, or more", "[strips]") {
    ContactProblem problem;
    problem.grid = Grid::of_elements(20, 15, 0.5, 0.4);
    problem.friction = FrictionLaw{{0.3}};
    problem.motion = Rolling{.xi = 1e-3, .dq = GENERATE(0.0, 0.5, 0.2)};
    const Body upper = GENERATE(Body{Material::rigid()}, Body{steel}, uniform_body());
    const Body lower = GENERATE(Body{steel}, uniform_body());
    problem.bodies = {upper, lower};
    if (problem.bodies.upper.material.is_rigid()) problem.bodies.upper.ics = lower.ics;
    const BodyTable below = table_of(lower, problem.grid);
    const BodyTable above = upper.material.is_rigid() ? below : table_of(upper, problem.grid);
    const std::size_t taken = make_influence(problem, above, below).bytes();
    const std::size_t expected = influence_bytes(problem.grid, problem.bodies);
    CHECK(taken <= expected);
    CHECK(expected < 8 * taken);
}

TEST_CASE("a longitudinally uniform body takes memory by its strips squared", "[strips]") {
    const Bodies uniform{{Material::rigid()}, uniform_body()}, flat{{Material::rigid()}, {steel}};
    const auto bytes = [&](int ny, const Bodies& bodies) {
        return influence_bytes(Grid::of_elements(100, ny, 0.5, 0.4), bodies);
    };
    CHECK(bytes(80, uniform) > 20 * bytes(80, flat));
    CHECK(2 * bytes(80, uniform) > 7 * bytes(40, uniform));
}
