#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "support/closed_forms.hpp"

using namespace contactd;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

TEST_CASE("Hertz and Cattaneo give the paper's values", "[reference]") {
    const MaterialPair bodies{{200, 0.42}, {200, 0.42}};
    const auto hertz = reference::hertz(bodies, 50, 0.02);
    CHECK_THAT(hertz.radius, WithinRel(1.0, 1e-12));
    CHECK_THAT(hertz.Fn, WithinAbs(9.195402, 1e-6));
    CHECK_THAT(hertz.pmax, WithinAbs(4.3905, 5e-5));

    const auto cattaneo = reference::cattaneo(bodies, hertz, 0.4, 7.0 / 8 * 0.4 * hertz.Fn);
    CHECK_THAT(cattaneo.adhesion_radius, WithinRel(0.5, 1e-12));
    CHECK_THAT(cattaneo.rigid_shift, WithinAbs(0.00817, 5e-6));
}

TEST_CASE("a rigid partner doubles the stiffness", "[reference]") {
    const Material steel{82000, 0.28}, rigid{1e30, 0.28};
    const auto equal = reference::hertz({steel, steel}, 10, 0.01);
    const auto on_rigid = reference::hertz({steel, rigid}, 10, 0.01);
    CHECK_THAT(on_rigid.Fn, WithinRel(2 * equal.Fn, 1e-12));
}

TEST_CASE("no approach, no Hertzian contact", "[reference]") {
    const auto hertz = reference::hertz({{1, 0.3}, {1, 0.3}}, 10, -0.01);
    CHECK(hertz.Fn == 0);
    CHECK(hertz.radius == 0);
    CHECK(hertz.pmax == 0);
}
