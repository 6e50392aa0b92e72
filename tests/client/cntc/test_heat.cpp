// Temperatures, and friction by them.
#include <algorithm>
#include <cmath>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "client/cntc/calls.hpp"

using namespace contactd::cntc::test;
using Catch::Matchers::WithinRel;

namespace {

/// Properties of both bodies; lengths in `length` mm. They are as warm at a creepage of `xi` as bodies of an effusivity
/// of 13.29 N/(mm s^0.5 K) would be that both pass at the rolling velocity, which the values below are of.
void heat(Case& contact, double xi, double length = 1, Values share = {}) {
    constexpr double capacity = 450, density = 7.85e-6;
    const double effusivity = 13.29 * 2 / (std::sqrt(1 - xi / 2) + std::sqrt(1 + xi / 2));
    const double conductivity = effusivity * effusivity / (density * capacity) * 1e-6;
    Values values;
    for (int body = 0; body < 2; ++body)
        values.insert(values.end(), {0.0, capacity, conductivity * length, density * length * length * length});
    values.insert(values.end(), share.begin(), share.end());
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
        heat(contact, 0.01, length);
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
    heat(contact, 0.02);
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
    heat(contact, 0.01);
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
    contact.friction(6, {0.35, 20, -0.2, 150, -1e-3, 1});
    CHECK(last_sentence().find("MEMDST") != std::string::npos);
}

TEST_CASE("friction by temperature has memory", "[heat]") {
    Case contact = rolling(204, 0.02);
    heat(contact, 0.02);
    const auto force = [&](double distance) {
        contact.friction(6, {0.35, 20, -0.2, 150, distance, 1});
        REQUIRE(contact.calculate() >= 0);
        return contact.forces().fx;
    };
    CHECK_THAT(force(1e-9), WithinRel(-12368.5752, 1e-5));  // none
    const double between = force(0.1), lasting = force(1e9);
    contact.coulomb(0.35);
    REQUIRE(contact.calculate() >= 0);
    CHECK_THAT(lasting, WithinRel(contact.forces().fx, 1e-6));  // as of surfaces that are never warm
    CHECK(between < -12368.6);
    CHECK(between > lasting);
}

TEST_CASE("the largest temperatures are those of each body, over all elements", "[heat]") {
    Case contact = rolling(205, 0);
    Values values{0.0, 450, 50e-3, 7.85e-6, 150, 450, 50e-3, 7.85e-6};
    int method = 3, count = 8;
    cntc_settemperaturedata(contact.ire(), contact.icp(), &method, &count, values.data());
    REQUIRE(contact.calculate() >= 0);
    double upper = no_number, lower = no_number;
    cntc_getmaximumtemperature(contact.ire(), contact.icp(), &upper, &lower);
    CHECK_THAT(upper, WithinRel(75, 1e-9));  // where they touch
    CHECK_THAT(lower, WithinRel(150, 1e-9));
}

TEST_CASE("a ninth number is the share of plastic work that becomes heat", "[heat]") {
    Case contact = rolling(206, 0.01);
    Values layered{0.28, 0.28, 82000, 82000, 8000, 0.08, 100, 0};
    int material = 4, numbers = 8;
    cntc_setmaterialparameters(contact.ire(), contact.icp(), &material, &numbers, layered.data());
    const auto warmth = [&](const Values& share) {
        heat(contact, 0.01, 1, share);
        REQUIRE(contact.calculate() >= 0);
        return contact.field(20)[8 * 21 + 5];
    };
    const double all = warmth({}), without = warmth({0});
    CHECK_THAT(warmth({1}), WithinRel(all, 1e-12));
    CHECK_THAT(warmth({0.5}), WithinRel((all + without) / 2, 1e-6));
    CHECK(without < 0.5 * all);
}
