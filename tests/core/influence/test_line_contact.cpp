// Tests coefficients of a line contact, and valid inputs of problems in plane strain.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "contactd/contact.hpp"
#include "contactd/error.hpp"
#include "contactd/half_space.hpp"
#include "contactd/ic_store.hpp"
#include "operators/shifted_operator.hpp"

using namespace contactd;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using enum Axis;

namespace {

const Material steel{82000, 0.28};
constexpr double dx = 0.1, datum = 50;

IcSpec line_spec(LoadShape load_shape = LoadShape::constant) {
    IcSpec spec;
    spec.material = steel;
    spec.dx = dx;
    spec.dy = 7;
    spec.nx = 40;
    spec.ny = 1;
    spec.load_shape = load_shape;
    spec.line_contact = LineContactSpec{datum};
    return spec;
}

std::string field_refused(const std::function<void(IcSpec&)>& change) {
    IcSpec spec = line_spec();
    change(spec);
    try {
        validate(spec);
    } catch (const InvalidArgument& error) {
        return error.field();
    }
    return "";
}

ContactProblem rolling_cylinder() {
    ContactProblem problem;
    problem.grid = Grid::of_elements(20, 1, 0.1, 7);
    Ics ics;
    ics.line_contact = LineContactSpec{datum};
    problem.bodies = Bodies::of({steel, steel}, ics);
    problem.gap = Paraboloid{100, std::numeric_limits<double>::infinity()};
    problem.Fn = 1000;
    problem.friction = FrictionLaw{{0.3}};
    problem.motion = Rolling{.xi = 1e-3};
    return problem;
}

std::string field_refused_of(const std::function<void(ContactProblem&)>& change) {
    ContactProblem problem = rolling_cylinder();
    change(problem);
    try {
        validate(problem);
    } catch (const InvalidArgument& error) {
        return error.field();
    }
    return "";
}

}  // namespace

TEST_CASE("a line contact is the limit of rectangles that get longer", "[line]") {
    const IcTable table = half_space_table(line_spec());
    const double length = 1e8;
    const auto rectangle = [&](Axis i, Axis j, int k) {
        return half_space_coefficient(i, j, k * dx, 0, dx, length, steel);
    };
    const double tolerance = 1e-7 * table(z, z, 0, 0);
    for (int k = 0; k < 40; ++k) {
        for (const Axis i : {x, y, z})
            CHECK_THAT(table(i, i, k, 0) - table(i, i, 0, 0),
                       WithinAbs(rectangle(i, i, k) - rectangle(i, i, 0), tolerance));
        CHECK_THAT(table(x, z, k, 0), WithinAbs(rectangle(x, z, k), tolerance));
        CHECK_THAT(table(z, x, k, 0), WithinAbs(rectangle(z, x, k), tolerance));
        for (const auto& [i, j] : {std::pair{x, y}, {y, x}, {y, z}, {z, y}}) CHECK(table(i, j, k, 0) == 0);
    }
}

TEST_CASE("displacements of a line load vanish at the datum", "[line]") {
    IcSpec spec = line_spec();
    const double far = half_space_table(spec)(z, z, 39, 0);
    CHECK_THAT(far, WithinRel((1 - steel.nu) / (std::numbers::pi * steel.G) * dx * std::log(datum / (39 * dx)), 1e-4));
    spec.line_contact->datum = 2 * datum;
    CHECK_THAT(half_space_table(spec)(y, y, 39, 0) - half_space_table(line_spec())(y, y, 39, 0),
               WithinRel(dx * std::numbers::ln2 / (std::numbers::pi * steel.G), 1e-9));
}

TEST_CASE("a hat function along x is a mean of constant loads, near and far", "[line]") {
    const IcTable hat = half_space_table(line_spec(LoadShape::bilinear));
    for (const int k : {0, 1, 2, 7, 8, 9, 30}) {
        // Adds the constant load half an element to both sides, by shifted tables of its pair with a rigid body.
        double zz = 0, xz = 0;
        constexpr int points = 400;
        for (int n = 0; n < points; ++n) {
            const double shift = ((n + 0.5) / points - 0.5) * dx;
            const ShiftedTable shifted =
                shifted_half_spaces({{Material::rigid(), steel}, LoadShape::constant, LineContactSpec{datum}},
                                    Grid::of_elements(40, 1, dx, 7), shift, 0);
            zz += shifted(x, x, k, 0) / points;
            xz += shifted(x, z, k, 0) / points;
        }
        CHECK_THAT(hat(x, x, k, 0), WithinRel(zz, 1e-5));
        CHECK_THAT(hat(x, z, k, 0), WithinAbs(xz, 1e-4 * hat(x, x, 0, 0)));
    }
}

TEST_CASE("the key of a line contact tells datum, not length, and other keys are what they were", "[line]") {
    IcSpec spec = line_spec();
    const std::string key = ic_key(spec);
    spec.dy = 1;
    CHECK(ic_key(spec) == key);
    spec.dx *= 3;
    spec.line_contact->datum *= 3;
    CHECK(ic_key(spec) == key);
    spec.line_contact->datum *= 2;
    CHECK(ic_key(spec) != key);
    spec.line_contact.reset();
    CHECK(ic_key(spec) != key);
}

TEST_CASE("a line contact that cannot be is refused by name", "[line]") {
    CHECK(field_refused([](IcSpec&) {}).empty());
    CHECK(field_refused([](IcSpec& s) { s.line_contact->datum = s.nx * s.dx; }).empty());
    CHECK(field_refused([](IcSpec& s) { s.line_contact->datum = 0.99 * s.nx * s.dx; }) == "ics.line_contact.datum");
    CHECK(field_refused([](IcSpec& s) { s.line_contact->datum = std::nan(""); }) == "ics.line_contact.datum");
    CHECK(field_refused([](IcSpec& s) { s.ny = 2; }) == "grid.ny");
    CHECK(field_refused([](IcSpec& s) { s.dy = 1e6; }).empty());
    CHECK(field_refused([](IcSpec& s) { s.source = IcSource::fem; }) == "ics.line_contact");
    CHECK(field_refused([](IcSpec& s) { s.line_contact.reset(), s.dy = 1e6; }) == "grid.dy");
}

TEST_CASE("a problem that changes along y is no line contact", "[line]") {
    CHECK(field_refused_of([](ContactProblem&) {}).empty());
    CHECK(field_refused_of([](ContactProblem& p) { p.grid = Grid::of_elements(20, 3, 0.1, 7); }) == "grid.ny");
    CHECK(field_refused_of([](ContactProblem& p) { p.gap = Paraboloid{100, 100}; }) == "gap.paraboloid.Ry");
    CHECK(field_refused_of([](ContactProblem& p) { p.gap = SemiAxes{1, 1}; }) == "gap.semi_axes.b");
    CHECK(field_refused_of([](ContactProblem& p) { p.motion = Rolling{.phi = 1e-4}; }) == "friction.rolling.phi");
    CHECK(field_refused_of([](ContactProblem& p) { p.motion = Rolling{.chi = 0.1}; }) == "friction.rolling.chi");
    CHECK(field_refused_of([](ContactProblem& p) { p.motion = Rolling{.chi = std::numbers::pi}; }).empty());
    CHECK(field_refused_of([](ContactProblem& p) { p.motion = Shift{.rotation = 1}; }) == "friction.rotation");
}
