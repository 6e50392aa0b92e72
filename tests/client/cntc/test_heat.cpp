// Temperatures, and friction by them.
#include <algorithm>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "client/cntc/calls.hpp"

using namespace contactd::cntc::test;
using Catch::Matchers::WithinRel;

namespace {

/// Properties of both bodies, of an effusivity of 13.29 N/(mm s^0.5 K); lengths in `length` mm.
void heat(Case& contact, double length = 1) {
    constexpr double capacity = 450, density = 7.85e-6, effusivity = 13.29;
    const double conductivity = effusivity * effusivity / (density * capacity) * 1e-6;
    Values values;
    for (int body = 0; body < 2; ++body)
        values.insert(values.end(), {0.0, capacity, conductivity * length, density * length * length * length});
    int method = 3, count = static_cast<int>(values.size());
    cntc_settemperaturedata(contact.ire(), contact.icp(), &method, &count, values.data());
}

/// A wheel of 460 mm that slides on a rail of 300 mm under 40 kN at 20 m/s.
Case rolling(int ire, double xi, double length = 1) {
    Case contact(ire);
    const double l = 1 / length;
    contact.flag(1933, length == 1 ? 1934 : 1936);
    contact.flag(1972, 3);
    contact.material(0.28, 0.28, 82000 * length * length, 82000 * length * length);
    contact.coulomb(0.3);
    contact.potential(1, {21, 17, -6.3 * l, -5.1 * l, 0.6 * l, 0.6 * l});
    contact.distance(1, {length / 920, 0, length / 600, 0, 0, 0});
    contact.normal_force(40000);
    contact.creepages(xi, 0, 0);
    contact.rolling_step(0, 0.6 * l);
    contact.velocity(20000 * l);
    return contact;
}

double largest(Case& contact) {
    double upper = no_number, lower = no_number;
    cntc_getmaximumtemperature(contact.ire(), contact.icp(), &upper, &lower);
    CHECK(upper == lower);
    return upper;
}

}  // namespace

TEST_CASE("temperatures are as known otherwise in all units", "[heat]") {
    for (const double length : {1.0, 1000.0}) {
        Case contact = rolling(201, 0.01, length);
        heat(contact, length);
        CHECK(contact.get_flag(1982) == 3);
        REQUIRE(contact.calculate() >= 0);
        CHECK_THAT(largest(contact), WithinRel(42.443075, 1e-6));
        const Values upper = contact.field(20), lower = contact.field(21);
        CHECK(upper == lower);
        CHECK_THAT(upper[8 * 21 + 2], WithinRel(41.1217431, 1e-6));
    }
}

TEST_CASE("friction by temperature is as known otherwise", "[heat]") {
    Case contact = rolling(202, 0.02);
    heat(contact);
    contact.friction(6, {0.35, 20, -0.2, 150, 0, 1});
    REQUIRE(contact.calculate() >= 0);
    CHECK_THAT(contact.forces().fx, WithinRel(-12368.5752, 1e-5));
    CHECK_THAT(largest(contact), WithinRel(80.5106825, 1e-5));
    const Values mu = contact.field(2);
    CHECK_THAT(*std::min_element(mu.begin(), mu.end()), WithinRel(0.26931909, 1e-5));
}

TEST_CASE("temperatures that nobody knows are refused", "[heat]") {
    Case contact = rolling(203, 0.01);
    contact.friction(6, {0.35, 20, -0.2, 150, 0, 1});
    CHECK(contact.calculate() < 0);  // no heat
    heat(contact);
    CHECK(contact.calculate() >= 0);
    contact.flag(1972, 1);
    CHECK(contact.calculate() < 0);
    contact.flag(1982, 0);
    contact.coulomb(0.3);
    CHECK(contact.calculate() >= 0);
    contact.flag(1972, 3);
    int method = 1, none = 0;
    cntc_settemperaturedata(contact.ire(), contact.icp(), &method, &none, nullptr);
    CHECK(contact.get_flag(1982) == 1);
    CHECK(contact.calculate() >= 0);
    CHECK(largest(contact) > 42);
    contact.friction(6, {0.35, 20, -0.2, 150, 1e-3, 1});
    CHECK(last_sentence().find("memdst") != std::string::npos);
}
