#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "contactd/contact.hpp"
#include "contactd/error.hpp"
#include "contactd/half_space.hpp"
#include "contactd/ic_spec.hpp"
#include "contactd/ic_table.hpp"

using namespace contactd;

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

IcSpec good_spec() {
    IcSpec spec;
    spec.material = {82000, 0.28};
    spec.dx = spec.dy = 0.8;
    spec.nx = spec.ny = 10;
    spec.source = IcSource::fem;
    return spec;
}

ContactProblem good_problem() {
    ContactProblem problem;
    problem.grid = Grid::of_elements(4, 3, 0.5, 0.5);
    problem.bodies = {{200, 0.42}, {200, 0.42}};
    problem.gap = Paraboloid{50, 50};
    problem.approach = 0.02;
    return problem;
}

/// Returns the field that `check` refuses, or "" if it refuses none.
std::string field_refused(const std::function<void()>& check) {
    try {
        check();
    } catch (const InvalidArgument& error) {
        return error.field();
    }
    return "";
}

std::string refused(const std::function<void(IcSpec&)>& change) {
    IcSpec spec = good_spec();
    change(spec);
    return field_refused([&] { validate(spec); });
}

std::string refused_problem(const std::function<void(ContactProblem&)>& change) {
    ContactProblem problem = good_problem();
    change(problem);
    return field_refused([&] { validate(problem); });
}

}  // namespace

TEST_CASE("A spec that can be built is accepted") {
    CHECK(refused([](IcSpec&) {}).empty());
    CHECK(refused([](IcSpec& s) { s.material.nu = 0; }).empty());
    CHECK(refused([](IcSpec& s) {
              s.source = IcSource::analytic;
              s.material.nu = 0.5;
          }).empty());
    CHECK(refused([](IcSpec& s) { s.dy = 0.2; }).empty());
    for (const char* name : {"paper-test1", "paper-test2", "paper-test3"})
        CHECK(refused([&](IcSpec& s) { s.fem = fem_preset(name).value(); }).empty());
}

TEST_CASE("A spec that cannot be built names its field") {
    CHECK(refused([](IcSpec& s) { s.material.G = 0; }) == "material.G");
    CHECK(refused([](IcSpec& s) { s.material.G = infinity; }) == "material.G");
    CHECK(refused([](IcSpec& s) { s.material.nu = -0.1; }) == "material.nu");
    CHECK(refused([](IcSpec& s) { s.material.nu = no_number; }) == "material.nu");
    CHECK(refused([](IcSpec& s) { s.material.nu = 0.51; }) == "material.nu");
    CHECK(refused([](IcSpec& s) { s.material.nu = 0.5; }) == "material.nu");
    CHECK(refused([](IcSpec& s) { s.nx = 0; }) == "grid.nx");
    CHECK(refused([](IcSpec& s) { s.ny = -3; }) == "grid.ny");
    CHECK(refused([](IcSpec& s) { s.nx = s.ny = 1'000'000; }) == "grid.nx");
    CHECK(refused([](IcSpec& s) { s.dx = 0; }) == "grid.dx");
    CHECK(refused([](IcSpec& s) { s.dy = no_number; }) == "grid.dy");
    CHECK(refused([](IcSpec& s) { s.fem.order = 7; }) == "ics.order");
    CHECK(refused([](IcSpec& s) { s.fem.h_over_hs = 3; }) == "ics.h_over_hs");
    CHECK(refused([](IcSpec& s) { s.fem.h_over_hs = 4.5; }) == "ics.h_over_hs");
    CHECK(refused([](IcSpec& s) { s.fem.l_over_h = 1.1; }) == "ics.l_over_h");
    CHECK(refused([](IcSpec& s) { s.fem.l_over_h = 0.25; }) == "ics.l_over_h");
    CHECK(refused([](IcSpec& s) { s.fem.l_over_h = 1000; }) == "ics.l_over_h");
    CHECK(refused([](IcSpec& s) { s.fem.f = 0.9; }) == "ics.f");
    CHECK(refused([](IcSpec& s) { s.fem.f = no_number; }) == "ics.f");
    CHECK(refused([](IcSpec& s) { s.fem.L_over_h = 0.5; }) == "ics.L_over_h");
    CHECK(refused([](IcSpec& s) {  // a million elements
              s.fem.h_over_hs = 64;
              s.fem.f = 1.01;
          }) == "ics");
    CHECK(refused([](IcSpec& s) { s.fem.L_over_h = 9; }) == "ics.L_over_h");  // the offsets reach 9 h
    CHECK(refused([](IcSpec& s) {                                             // every nu has its own mesh
              s.fem.mesh = MeshKind::adaptive;
              s.any_nu = true;
          }) == "ics.any_nu");
    CHECK(refused([](IcSpec& s) { s.fem.tolerance = 0; }) == "ics.tolerance");
    CHECK(refused([](IcSpec& s) { s.fem.max_iterations = 0; }) == "ics.max_iterations");
    CHECK(refused([](IcSpec& s) { s.fem.strength_threshold = 1; }) == "ics.strength_threshold");
}

TEST_CASE("Equal ratios make equal dimensionless specs, whatever the lengths") {
    IcSpec other = good_spec();
    other.material.G = 1;
    other.dx = 0.1 + 0.2;
    other.dy = 0.3;

    CHECK(dimensionless(other) == dimensionless(good_spec()));
}

TEST_CASE("A table gives offsets of either sign by the parity of its component") {
    IcTable table(3, 2);
    for (std::size_t n = 0; n < table.values.size(); ++n) table.values[n] = 1 + double(n);
    const auto value = [&](Axis i, Axis j) { return table(i, j, 2, 1); };

    CHECK(table.at(Axis::z, Axis::z, -2, -1) == value(Axis::z, Axis::z));
    CHECK(table.at(Axis::x, Axis::y, -2, 1) == -value(Axis::x, Axis::y));
    CHECK(table.at(Axis::y, Axis::x, -2, -1) == value(Axis::y, Axis::x));
    CHECK(table.at(Axis::x, Axis::z, -2, 1) == -value(Axis::x, Axis::z));
    CHECK(table.at(Axis::z, Axis::x, 2, -1) == value(Axis::z, Axis::x));
    CHECK(table.at(Axis::y, Axis::z, 2, -1) == -value(Axis::y, Axis::z));
}

TEST_CASE("A pair adds the even components and cancels normal-tangential coupling of equal bodies") {
    IcTable body(2, 2);
    for (std::size_t n = 0; n < body.values.size(); ++n) body.values[n] = 1 + double(n);

    const IcTable pair = pair_of(body, body);

    CHECK(pair(Axis::z, Axis::z, 1, 1) == 2 * body(Axis::z, Axis::z, 1, 1));
    CHECK(pair(Axis::y, Axis::x, 1, 0) == 2 * body(Axis::y, Axis::x, 1, 0));
    CHECK(pair(Axis::x, Axis::z, 1, 0) == 0);
    CHECK(pair(Axis::z, Axis::y, 0, 1) == 0);
    CHECK_THROWS_AS(pair_of(body, IcTable(3, 2)), InvalidArgument);
}

TEST_CASE("Cropping keeps the offsets it keeps") {
    IcTable table(4, 3);
    for (std::size_t n = 0; n < table.values.size(); ++n) table.values[n] = double(n);

    const IcTable part = cropped(table, 2, 3);

    CHECK(part.nx == 2);
    CHECK(part(Axis::y, Axis::z, 1, 2) == table(Axis::y, Axis::z, 1, 2));
    CHECK_THROWS_AS(cropped(table, 5, 1), InvalidArgument);
}

TEST_CASE("Quasi-identical bodies are those with equal (1 - 2 nu)/G") {
    CHECK(MaterialPair{{200, 0.42}, {200, 0.42}}.quasi_identical());
    CHECK(MaterialPair{{1, 0.5}, {9, 0.5}}.quasi_identical());
    CHECK(MaterialPair{{2, 0.0}, {1, 0.25}}.quasi_identical());
    CHECK_FALSE(MaterialPair{{82000, 0.28}, {200, 0.28}}.quasi_identical());
}

TEST_CASE("A contact problem that cannot be solved names its field") {
    CHECK(refused_problem([](ContactProblem&) {}).empty());
    CHECK(refused_problem([](ContactProblem& p) { p.grid.dx = -1; }) == "grid.dx");
    CHECK(refused_problem([](ContactProblem& p) { p.grid.x0 = no_number; }) == "grid.x0");
    CHECK(refused_problem([](ContactProblem& p) { p.bodies.lower.material.nu = 0.6; }) == "bodies.lower.nu");
    CHECK(refused_problem([](ContactProblem& p) { p.gap = std::vector<double>(3); }) == "gap.array");
    CHECK(refused_problem([](ContactProblem& p) { p.gap = std::vector<double>(p.grid.size(), infinity); }) ==
          "gap.array");
    CHECK(refused_problem([](ContactProblem& p) { p.approach = no_number; }) == "approach");
    CHECK(refused_problem([](ContactProblem& p) { p.friction = FrictionLaw{{-0.1}}, p.motion = Shift{{0, 0}}; }) ==
          "friction.mu");
    CHECK(refused_problem([](ContactProblem& p) {
              p.friction = FrictionLaw{{0.1}}, p.motion = Shift{{no_number, 0}};
          }) == "friction.rigid_shift");
    CHECK(refused_problem([](ContactProblem& p) { p.friction = FrictionLaw{{0.1}}, p.motion = Rolling{.dq = 1e9}; }) ==
          "friction.rolling.dq");
    CHECK(refused_problem([](ContactProblem& p) { p.friction = FrictionLaw{{0.1}}, p.motion = Rolling{.steps = 0}; }) ==
          "friction.rolling.steps");
    CHECK(refused_problem([](ContactProblem& p) {
              p.friction = FrictionLaw{{0.1}}, p.motion = Shift{.force = {.Fx = infinity}};
          }) == "friction.force");
    CHECK(refused_problem([](ContactProblem& p) { p.friction = FrictionLaw{{0.1, 0.2}}; }) == "friction.mu");
    CHECK(refused_problem([](ContactProblem& p) { p.approach.reset(), p.Fn = -1; }) == "Fn");
    CHECK(refused_problem([](ContactProblem& p) { p.approach.reset(), p.Fn = no_number; }) == "Fn");
    CHECK(refused_problem([](ContactProblem& p) { p.approach.reset(), p.Fn = 5e-324; }) == "Fn");
    CHECK(refused_problem([](ContactProblem& p) { p.approach.reset(); }) == "approach");
    CHECK(refused_problem([](ContactProblem& p) { p.Fn = 1; }) == "Fn");
    CHECK(refused_problem([](ContactProblem& p) { p.approach.reset(), p.gap = SemiAxes{1, 1}; }) == "approach");
    CHECK(refused_problem([](ContactProblem& p) { p.gap = SemiAxes{1, -1}; }) == "gap.semi_axes.b");
    CHECK(refused_problem([](ContactProblem& p) { p.bodies = {{Material::rigid()}, {Material::rigid()}}; }) ==
          "bodies.lower");
    CHECK(refused_problem([](ContactProblem& p) { p.gap.reset(); }) == "gap");
    CHECK(refused_problem([](ContactProblem& p) {
              std::get<Ics>(p.bodies.lower.ics).load_shape = LoadShape::bilinear;
          }) == "bodies.lower.ics.load_shape");
    CHECK(refused_problem([](ContactProblem& p) { p.bodies.upper.ics = GivenIcs{IcTable(1, 1), p.grid.dx, 7}; }) ==
          "bodies.upper.ics.dy");
    CHECK(refused_problem([](ContactProblem& p) { p.friction.emplace(), p.rigid_slip.x = {1.0}; }) ==
          "friction.rigid_slip.x");
    CHECK(refused_problem([](ContactProblem& p) { p.previous.pressure = {1.0}; }) == "previous.pressure");
    CHECK(refused_problem([](ContactProblem& p) { p.settings.normal.tolerance = 0; }) == "settings.normal.tolerance");
    CHECK(refused_problem([](ContactProblem& p) { p.settings.tangential.max_iterations = 0; }) ==
          "settings.tangential.max_iterations");
    CHECK(refused_problem([](ContactProblem& p) { p.initial.traction_y = {1.0}; }) == "initial.traction_y");
}

TEST_CASE("A line contact beside a given table is refused where it stands", "[body]") {
    ContactProblem problem = good_problem();
    const Grid& grid = problem.grid;
    IcSpec spec;
    spec.material = problem.bodies.upper.material;
    spec.dx = grid.dx;
    spec.dy = grid.dy;
    spec.nx = grid.nx;
    spec.ny = grid.ny;
    const GivenIcs given{half_space_table(spec), grid.dx, grid.dy};
    Ics line;
    line.line_contact = LineContactSpec{10};
    const Bodies& bodies = problem.bodies;
    const Bodies above{{bodies.upper.material, line}, {bodies.lower.material, given}};
    const Bodies below{{bodies.upper.material, given}, {bodies.lower.material, line}};
    CHECK(field_refused([&] { validate(above, grid); }) == "bodies.upper.ics.line_contact");
    CHECK(field_refused([&] { validate(below, grid); }) == "bodies.lower.ics.line_contact");
    const Bodies plain{{bodies.upper.material, given}, {bodies.lower.material}};
    CHECK(field_refused([&] { validate(plain, grid); }).empty());
}

TEST_CASE("A material is given by its shear modulus or by Young's") {
    constexpr Material steel = Material::from_E(210000, 0.28);
    CHECK(steel == Material{210000 / 2.56, 0.28});
    CHECK(steel.E() == 2 * steel.G * 1.28);
    CHECK(refused_problem([](ContactProblem& p) { p.bodies.upper.material = Material::from_E(-1, 0.3); }) ==
          "bodies.upper.G");
}

TEST_CASE("What opens a session may leave gap and load to its steps") {
    ContactProblem opening;
    opening.grid = Grid::of_elements(2, 2, 1, 1);
    opening.bodies = {{1, 0}, {1, 0}};
    CHECK_NOTHROW(validate_opening(opening));
    CHECK_THROWS_AS(validate(opening), InvalidArgument);
    opening.approach = opening.Fn = 1;
    CHECK_THROWS_AS(validate_opening(opening), InvalidArgument);
}

TEST_CASE("layers of which no table can be made are refused by name, value and remedy", "[types]") {
    const Layers good{{{2, 1, 0.5}, {1, 40, 0.2}}, {8, 0.3}};
    const auto sentence = [&](auto change) {
        Layers body = good;
        change(body);
        try {
            validate(body, 0.1, "bodies.lower.ics");
        } catch (const InvalidArgument& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
    CHECK(sentence([](Layers&) {}).empty());
    CHECK(sentence([](Layers& b) { b.layers.clear(); }).starts_with("bodies.lower.ics.layers is empty; give"));
    CHECK(sentence([](Layers& b) { b.layers.resize(21, b.layers[0]); }).find("has 21 layers, but at most 20") !=
          std::string::npos);
    for (const double thickness : {0.0, -1.0, nan, infinite})
        CHECK(sentence([&](Layers& b) {
                  b.layers[1].thickness = thickness;
              }).starts_with("bodies.lower.ics.layers[1].thickness is "));
    CHECK(sentence([](Layers& b) { b.layers[0].thickness = 1e-9; }).find("omit a thinner layer") != std::string::npos);
    CHECK(sentence([](Layers& b) { b.layers[0].thickness = 1e9; }).find("use a half-space for a thicker") !=
          std::string::npos);
    for (const double nu : {-0.1, 0.500001, nan})
        CHECK(sentence([&](Layers& b) { b.layers[1].nu = nu; }).starts_with("bodies.lower.ics.layers[1].nu is "));
    for (const double G : {0.0, -1.0, nan, infinite})
        CHECK(sentence([&](Layers& b) { b.layers[0].G = G; }).starts_with("bodies.lower.ics.layers[0].G is "));
    CHECK(sentence([](Layers& b) { b.base.nu = 0.7; }).starts_with("bodies.lower.ics.base.nu is 0.7"));
    CHECK(sentence([](Layers& b) { b.base = {}; }).starts_with("bodies.lower.ics.base.G is 0"));
    CHECK(sentence([](Layers& b) { b.base.G = 1e12; }).find("use a rigid base") != std::string::npos);
}
