// Values of elements of simplified theories and of layers.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "client/cntc/rail_calls.hpp"

using namespace contactd::cntc::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

void material(Case& contact, int method, Values values) {
    int count = static_cast<int>(values.size());
    cntc_setmaterialparameters(contact.ire(), contact.icp(), &method, &count, values.data());
}

constexpr double tau_c0 = 120, k_tau = 9000;

/// Bodies with a layer that yields and hardens, in metres where `m` is 1000.
void layered(Case& contact, double nu, double m = 1) {
    material(contact, 4,
             {nu, nu, 82000 * m * m, 82000 * m * m, 8200 * m * m, 0.164 / m, tau_c0 * m * m, k_tau * m * m * m});
}

/// In a plastic element the traction has the yield stress, which the plastic slip of its particle has raised. Returns
/// the number of such elements. Tractions are those on the body of the units.
int check_hardening(Case& contact, double m, double body) {
    const Values tau = contact.field(11), x = contact.field(12), y = contact.field(13);
    const Values px = contact.field(3), py = contact.field(4);
    const std::vector<int> division = contact.division();
    int plastic = 0;
    for (std::size_t i = 0; i < division.size(); ++i) {
        CHECK_THAT(tau[i] / (m * m), WithinRel(tau_c0 + k_tau * m * std::hypot(x[i], y[i]), 1e-6));
        if (division[i] != 3) continue;
        ++plastic;
        CHECK_THAT(std::hypot(px[i], py[i]), WithinRel(tau[i], 1e-6));
        CHECK(body * (x[i] * px[i] + y[i] * py[i]) > 0);  // the layer is sheared as the tractions on body 1 pull
    }
    return plastic;
}

}  // namespace

TEST_CASE("FASTSIM with a parabolic bound has the pressures of the parabola and the areas of its elements") {
    constexpr double a = 8, b = 4, Fn = 82000;
    const double p0 = 2 * Fn / (std::numbers::pi * a * b);
    Case contact(1);
    contact.coulomb(0.3);
    contact.hertz(-3, {45, 45, a, b, 1.1});
    contact.normal_force(Fn);
    contact.creepages(0.0005, -0.000625, 0.000625);
    material(contact, 3, {0.28, 0.28, 82000, 82000, 1, 1, 0});
    contact.flag(1971, 3);
    REQUIRE(contact.calculate() == 0);

    const auto [pn, px, py] = contact.tractions();
    const auto [dx, dy] = contact.element_size();
    const std::vector<int> division = contact.division();
    std::array<int, 4> counts{};
    for (std::size_t i = 0; i < pn.size(); ++i) {
        const double x = (static_cast<double>(i % 45) - 22) * dx / a, y = (static_cast<double>(i / 45) - 22) * dy / b;
        CHECK_THAT(pn[i], WithinAbs(std::max(0.0, p0 * (1 - x * x - y * y)), 1e-9 * p0));
        const double t = std::hypot(px[i], py[i]);
        CHECK(t <= 0.3 * pn[i] * (1 + 1e-9));
        if (division[i] == 2) CHECK_THAT(t, WithinRel(0.3 * pn[i], 1e-9));
        ++counts[static_cast<std::size_t>(division[i])];
    }
    CHECK_THAT(contact.max_pressure(), WithinRel(p0, 1e-9));
    CHECK(contact.forces().fn == Fn);
    const PatchAreas areas = contact.areas();
    CHECK_THAT(areas.adhesion, WithinRel(counts[1] * dx * dy, 1e-12));
    CHECK_THAT(areas.slip, WithinRel(counts[2] * dx * dy, 1e-12));
    CHECK_THAT(areas.contact, WithinRel((counts[1] + counts[2]) * dx * dy, 1e-12));
    CHECK(counts[1] > 100);
    CHECK(counts[2] > 100);
}

TEST_CASE("FASTSIM and FaStrip with an elliptic bound have Hertz's pressures and the areas of their elements") {
    Case contact = wheel(1);
    material(contact, GENERATE(3, 5), {0.28, 0.28, 82000, 82000, 1, 1, 0});
    contact.flag(1971, 2);
    REQUIRE(contact.calculate() == 0);
    const auto [dx, dy] = contact.element_size();
    const std::vector<int> division = contact.division();
    const auto count = [&](int state) { return static_cast<double>(std::ranges::count(division, state)); };
    CHECK_THAT(contact.max_pressure(), WithinRel(1.5 * 50000 / (std::numbers::pi * 24), 1e-9));
    CHECK_THAT(contact.areas().contact, WithinRel((625 - count(0)) * dx * dy, 1e-12));
    CHECK_THAT(contact.areas().slip, WithinRel(count(2) * dx * dy, 1e-12));
}

TEST_CASE("pressures that are prescribed stay so without friction") {
    Case contact = wheel(1);
    material(contact, 3, {0.28, 0.28, 82000, 82000, 1, 1, 0});
    contact.flag(1972, 0);
    contact.flag(1971, 3);
    REQUIRE(contact.calculate() == 0);
    CHECK_THAT(contact.max_pressure(), WithinRel(2 * 50000 / (std::numbers::pi * 24), 1e-9));
}

TEST_CASE("a layer's yield stress has risen with the plastic slip that its particles have accumulated") {
    const int tangential = GENERATE(1, 2, 3);
    const double m = GENERATE(1.0, 1000.0);
    CAPTURE(tangential, m);
    Case contact(1);
    contact.flag(1933, m == 1 ? 1934 : 1935);
    contact.flag(1972, tangential);
    layered(contact, 0, m);  // where a force along x makes no traction along y
    contact.coulomb(0.35);
    contact.potential(1, {25, 21, -8.125 / m, -6.3 / m, 0.65 / m, 0.6 / m});
    contact.distance(1, {m / 920, 0, m / 600, 0, 0, 0});
    contact.normal_force(30000);
    contact.rolling_step(0, 0.65 / m);
    contact.tolerance(1e-10);
    // One direction all along, so that lengths of plastic slip add up as its components do.
    contact.creepages(tangential == 1 ? 0.006 / m : tangential == 2 ? 0.012 : 0.0015, 0, 0);
    int plastic = 0;
    for (int k = 0; k < 3; ++k) {
        REQUIRE(contact.calculate() == 0);
        plastic += check_hardening(contact, m, m == 1 ? 1 : -1);
        contact.flag(1970, 0);  // the second step goes on
    }
    CHECK(plastic > 100);
}

TEST_CASE("plastic slip goes back when a shift does, and the yield stress rises all the same") {
    Case contact(1);
    contact.flag(1972, 1);
    material(contact, 4, {0.28, 0.28, 82000, 82000, 1e5, 1, 150, 20000});
    contact.coulomb(0.5);
    contact.potential(1, {21, 21, -1.575, -1.575, 0.15, 0.15});
    contact.distance(1, {0.01, 0, 0.01, 0, 0, 0});
    contact.normal_force(1500);
    contact.tolerance(1e-10);
    const auto shifted = [&](double x) {
        contact.creepages(x, 0, 0);
        REQUIRE(contact.calculate() == 0);
        contact.flag(1970, 0);
        const Values tau = contact.field(11), slip = contact.field(12);
        return std::pair(*std::ranges::max_element(tau), *std::ranges::min_element(slip));
    };
    const auto [first, there] = shifted(0.006);
    REQUIRE(first > 150);
    REQUIRE(there < 0);  // tractions on body 1 are opposite to its shift
    const auto [second, back] = shifted(-0.012);
    CHECK(second > first);
    CHECK(back > there);
    const Values expected = contact.field(12);

    contact.flag(1970, 3);  // takes the second step back, and repeats it
    const auto [again, back_again] = shifted(-0.012);
    CHECK_THAT(again, WithinRel(second, 1e-9));
    CHECK_THAT(back_again, WithinRel(back, 1e-9));
    const Values repeated = contact.field(12);
    for (std::size_t i = 0; i < repeated.size(); ++i) CHECK_THAT(repeated[i], WithinAbs(expected[i], 1e-9));
}

TEST_CASE("a layer that never yields, and none, have no yield stress and no plastic slip") {
    Case contact = wheel(1);
    material(contact, 4, {0.28, 0.28, 82000, 82000, 8200, 0.2, 0, 0});
    REQUIRE(contact.calculate() == 0);
    for (const int code : {11, 12, 13}) CHECK(contact.field(code) == Values(625, 0.0));
}

TEST_CASE("a layer on a rail has its yield stress and plastic slip in the patches of both sides") {
    const auto side = GENERATE(contactd::Side::left, contactd::Side::right);
    const auto& known =
        *std::ranges::find(contactd::test::manchester_cases, side, &contactd::test::ManchesterCase::side);
    RailCase rail = manchester_wheel(1, side);
    place(rail, known);
    layered(rail.whole, 0.28);
    rail.whole.coulomb(0.5);
    rail.velocity(2, {2000, 0, 0, 0, 0, known.pitch_rate * 1.003});
    rail.whole.tolerance(1e-9);
    REQUIRE(rail.whole.calculate() == 0);
    Case patch = rail.patch(1);
    const Values tau = patch.field(11), x = patch.field(12), y = patch.field(13);
    const Values px = patch.field(3), py = patch.field(4);
    const std::vector<int> division = patch.division();
    int plastic = 0;
    for (std::size_t i = 0; i < tau.size(); ++i) {
        CHECK(tau[i] >= tau_c0 * (1 - 1e-12));
        if (division[i] != 3) continue;
        ++plastic;
        CHECK_THAT(std::hypot(px[i], py[i]), WithinRel(tau[i], 1e-6));
        CHECK(x[i] * px[i] + y[i] * py[i] > 0);
    }
    CHECK(plastic > 5);
}
