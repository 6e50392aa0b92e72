// The simplified theory and pressures from the overlap of surfaces, by the flags that ask for them.
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <vector>

#include "client/cntc/calls.hpp"
#include "client/cntc/rail_calls.hpp"

using contactd::Side;
using namespace contactd::cntc::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

void simplified(Case& contact, int method, double k0 = 1, double alpha = 1, double beta = 1) {
    int count = 7;
    std::array values{0.28, 0.28, 82000.0, 82000.0, k0, alpha, beta};
    cntc_setmaterialparameters(contact.ire(), contact.icp(), &method, &count, values.data());
}

Case published() {
    Case contact(1);
    contact.coulomb(0.3);
    contact.hertz(-3, {44, 44, 8, 4, 1.1});
    contact.normal_force(82000);
    contact.creepages(0, -0.000625, 0.000625);
    return contact;
}

constexpr double load = 80000;

/// A wheel by KPEC with FASTSIM under its load, on elements of half a millimetre.
RailCase wheel_by_kpec(int ire) {
    RailCase rail = manchester_wheel(ire, Side::right);
    rail.whole.potential(-1, {0.5, 0.5, 1.5707963267948966, 8, 4, 12});
    rail.whole.flag(1971, 5);
    rail.whole.flag(1979, 3);
    rail.vertical_force(load);
    return rail;
}

void roll(RailCase& rail, double y) {
    rail.position(2, {0, y, 0, 0, 1e-3 * y, 0});
    rail.velocity(2, {20000, 0, 0, 0, 0, -43.48});
}

/// Forces and moments of the wheel on the track, after a solve.
Values solved(RailCase& rail) {
    REQUIRE(rail.whole.calculate() == 0);
    return rail.global_forces();
}

/// The largest difference of the forces, over the load.
double difference(const Values& a, const Values& b) {
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most / load;
}

}  // namespace

TEST_CASE("a wheel by KPEC finds after other places what it finds as the first one") {
    RailCase hunting = wheel_by_kpec(20);
    for (const double y : {0.0, 0.2, 0.4, -3.0, 4.0, 7.0, -6.0}) {
        CAPTURE(y);
        roll(hunting, y);
        const Values found = solved(hunting);
        RailCase alone = wheel_by_kpec(21);
        roll(alone, y);
        CHECK(difference(found, solved(alone)) < 1e-5);
        CHECK(std::abs(hunting.wheelset_position()[2] - alone.wheelset_position()[2]) < 1e-6);
    }
}

TEST_CASE("a wheel by KPEC sees what was set since the last case") {
    using Set = void (*)(RailCase&);
    const Set set = GENERATE(
        Set([](RailCase& rail) { rail.vertical_force(40000); }), Set([](RailCase& rail) { rail.whole.coulomb(0.1); }),
        Set([](RailCase& rail) { rail.whole.material(0.28, 0.28, 41000, 41000); }),
        Set([](RailCase& rail) { rail.whole.flag(1971, 6); }),
        Set([](RailCase& rail) { rail.wheelset(3, {1363, -70, 460}); }), Set([](RailCase& rail) {
            Values lifted = rail_60e1();
            for (std::size_t i = 1; i < lifted.size(); i += 2) lifted[i] -= 0.5;
            rail.profile(false, lifted);
        }),
        Set([](RailCase& rail) { rail.whole.potential(-1, {1, 1, 1.5707963267948966, 8, 4, 12}); }),
        Set([](RailCase& rail) { rail.velocity(2, {20000, 100, 0, 0, 0, -43.48}); }));
    RailCase rail = wheel_by_kpec(20), other = wheel_by_kpec(21);
    roll(rail, 2);
    const Values before = solved(rail);
    const double z = rail.wheelset_position()[2];
    set(rail);
    roll(other, 2);
    set(other);
    const Values after = solved(rail);
    CHECK(difference(after, solved(other)) < 1e-5);
    CHECK(std::max(difference(after, before), std::abs(rail.wheelset_position()[2] - z)) > 1e-4);
}

TEST_CASE("the simplified theory has the forces that are printed of it") {
    struct Row {
        int method, bound;
        double share, mz;
    };
    const Row row = GENERATE(Row{3, 3, -0.6118, -39000}, Row{3, 2, -0.6016, -48290}, Row{5, 2, -0.6435, -48160});
    Case contact = published();
    simplified(contact, row.method);
    contact.flag(1971, row.bound);
    CHECK(contact.get_flag(1979) == row.method);
    REQUIRE(contact.calculate() == 0);
    CHECK_THAT(contact.forces().fy / (0.3 * 82000), WithinAbs(row.share, 5e-5));
    CHECK_THAT(contact.forces().mz, WithinAbs(row.mz, 5));
}

TEST_CASE("a reduced slope makes forces smaller, and elastic bodies take it back") {
    Case contact = wheel(1);
    contact.creepages(1e-6, 0, 0);
    simplified(contact, 3);
    contact.flag(1971, 3);
    REQUIRE(contact.calculate() == 0);
    const double all = contact.forces().fx;
    simplified(contact, 3, 0.5, 0.1, 0.1);
    REQUIRE(contact.calculate() == 0);
    CHECK_THAT(contact.forces().fx, WithinRel(0.5 * all, 0.01));
    contact.material(0.28, 0.28, 82000, 82000);
    contact.flag(1971, 0);
    CHECK(contact.get_flag(1979) == 0);
    REQUIRE(contact.calculate() == 0);
    CHECK_THAT(contact.forces().fx, WithinRel(all, 0.1));
}

TEST_CASE("the simplified theory tells the one coefficient of falling friction, by which its tractions are bounded") {
    Case contact = published();
    simplified(contact, GENERATE(3, 5));
    contact.flag(1971, 2);
    contact.friction(4, {0.1, 0.2, 20, 0, 0, 0, 0});
    contact.velocity(20000);
    contact.creepages(0.004, 0, 0);
    REQUIRE(contact.calculate() == 0);
    const double fallen = 0.1 + 0.2 * std::pow(2, -0.004 * 20000 / 20);
    const Values mu = contact.field(2);
    const std::vector<int> division = contact.division();
    for (std::size_t i = 0; i < mu.size(); ++i) CHECK_THAT(mu[i], WithinRel(division[i] == 0 ? 0.3 : fallen, 1e-12));
    CHECK_THAT(contact.forces().fx, WithinRel(-fallen * 82000, 0.01));
}

TEST_CASE("KPEC and ANALYN have pressures near those of the full theory") {
    Case contact = wheel(1);
    contact.flag(1971, GENERATE(5, 6));
    REQUIRE(contact.calculate() == 0);
    CHECK_THAT(contact.forces().fn, WithinRel(50000.0, 1e-6));
    CHECK_THAT(contact.max_pressure(), WithinRel(1.5 * 50000 / (3.14159265 * 24), 0.02));
}

TEST_CASE("pressures of the ellipse or the parabola of Hertz bound the full theory, too") {
    Case contact = published();
    const int bound = GENERATE(2, 3);
    contact.material(0.28, 0.28, 82000, 82000);
    contact.flag(1971, bound);
    REQUIRE(contact.calculate() == 0);
    CHECK_THAT(contact.max_pressure(), WithinRel((bound == 2 ? 1.5 : 2) * 82000 / (3.14159265 * 32), 2e-3));
    CHECK_THAT(contact.forces().fn, WithinRel(82000.0, 2e-3));
    const double prescribed = contact.forces().fy;
    contact.flag(1971, 0);
    REQUIRE(contact.calculate() == 0);
    CHECK_THAT(prescribed, WithinRel(contact.forces().fy, bound == 2 ? 0.01 : 0.2));
}

TEST_CASE("reductions of the slope that are none are refused") {
    Case contact = wheel(1);
    simplified(contact, 3, 0.0);
    CHECK(last_code() == -39);
}
