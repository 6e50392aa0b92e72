// Laws of friction, and damping, which there is none of.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "client/cntc/rail_calls.hpp"

using namespace contactd::cntc::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinRel;

namespace {

void material(Case& contact, int method, Values values) {
    int count = static_cast<int>(values.size());
    cntc_setmaterialparameters(contact.ire(), contact.icp(), &method, &count, values.data());
}

Values friction_back(Case& contact) {
    int task = 3, length = 7;
    Values values(7);
    cntc_getparameters(contact.ire(), contact.icp(), &task, &length, values.data());
    return values;
}

/// Wheel and rail of steel at 20 degrees, with the share of a layer's plastic work, which the program takes, too.
void heat(RailCase& rail) {
    int given = 3, count = 9, all = -1;
    Values bodies{20, 450, 0.05, 7.85e-6, 20, 450, 0.05, 7.85e-6, 1};
    cntc_settemperaturedata(rail.ire(), &all, &given, &count, bodies.data());
    CHECK(last_code() == 0);
}

/// mu 0.4, A 0.4, B 0.0006 s/mm as the exponential law.
Values exponential_of_polach() {
    return {0.16, 0.24, std::numbers::ln2 / 6e-4, 0, 10000, 1e-3, 10};
}

}  // namespace

TEST_CASE("Polach's law is the exponential law with the program's own memory, in all units") {
    const int units = GENERATE(1934, 1936);
    const double m = units == 1934 ? 1 : 1000;
    const auto rolling = [&](int ire) {
        Case contact(ire);
        contact.flag(1933, units);
        contact.material(0.28, 0.28, 82000 * m * m, 82000 * m * m);
        contact.hertz(-3, {25, 25, 6 / m, 4 / m, 1.1});
        contact.normal_force(50000);
        contact.velocity(20000 / m);
        return contact;
    };
    Case polach = rolling(1), exponential = rolling(2);
    polach.friction(5, {0.4, 0.4, 6e-4 * m});
    const Values same = exponential_of_polach();
    exponential.friction(4, {same[0], same[1], same[2] / m, 0, same[4] / m, same[5] / m, same[6] / m});
    CHECK(polach.get_flag(1976) == 4);
    const Values found = friction_back(polach), expected = friction_back(exponential);
    for (std::size_t i : {0, 1, 2, 4, 5, 6}) CHECK_THAT(found[i], WithinRel(expected[i], 1e-12));

    for (const double xi : {0.001, 0.05}) {
        for (Case* contact : {&polach, &exponential}) {
            contact->creepages(xi, 0, 0);
            REQUIRE(contact->calculate() == 0);
        }
        CHECK_THAT(polach.forces().fx, WithinRel(exponential.forces().fx, 1e-9));
    }
    // All of it slips, at the velocity of the creepage, over far more than the memory.
    const double mu = 0.4 * (0.4 + 0.6 * std::exp(-6e-4 * 0.05 * 20000));
    CHECK_THAT(polach.forces().fx, WithinRel(-mu * 50000, 0.01));
}

TEST_CASE("Polach's law that does not fall is Coulomb's, and one that makes no sense is refused") {
    Case coulomb = wheel(1), flat = wheel(2);
    flat.friction(5, GENERATE(Values{0.3, 1, 0.001}, Values{0.3, 0.4, 0}));
    CHECK(last_code() == 0);
    REQUIRE(coulomb.calculate() == 0);
    REQUIRE(flat.calculate() == 0);
    CHECK(flat.forces() == coulomb.forces());
    for (const Values& wrong : {Values{0.3, 1.1, 0.001}, Values{0.3, -0.1, 0.001}, Values{0.3, 0.4, -1}}) {
        flat.friction(5, wrong);
        CHECK(last_code() == -33);
        CHECK_THAT(last_sentence(), ContainsSubstring("polach_"));
        CHECK(flat.calculate() == -33);
    }
}

TEST_CASE("friction that is kept is that of before, whatever is said of places") {
    Case contact = wheel(1);
    REQUIRE(contact.calculate() == 0);
    const ContactForces expected = contact.forces();
    contact.friction(GENERATE(1, 11, 21), {});
    CHECK(last_code() == 0);
    REQUIRE(contact.calculate() == 0);
    CHECK(contact.forces() == expected);
    Case none(2);
    none.friction(11, {});
    CHECK(last_code() == -33);
}

TEST_CASE("the size of the velocity is that of rolling, whatever its sign") {
    Case forwards = wheel(1), backwards = wheel(2);
    forwards.velocity(20000);
    backwards.velocity(-20000);
    CHECK(last_code() == 0);
    for (Case* contact : {&forwards, &backwards}) {
        contact->friction(4, {0.16, 0.24, 1000, 0, 1, 0, 0});
        REQUIRE(contact->calculate() == 0);
    }
    CHECK(forwards.forces() == backwards.forces());
}

TEST_CASE("Polach's law varies over a rail as the exponential law does") {
    const auto& known = contactd::test::manchester_cases[0];
    const int varies = GENERATE(10, 20);
    const auto solved = [&](int ire, int law, const Values& one) {
        RailCase rail = manchester_wheel(ire, known.side);
        place(rail, known);
        Values all{2};
        for (const double place : {-1.0, 1.0}) {
            all.push_back(place);
            all.insert(all.end(), one.begin(), one.end());
        }
        rail.whole.friction(varies + law, all);
        CHECK(last_sentence().empty());
        CHECK(rail.whole.get_flag(1976) == 4);
        REQUIRE(rail.whole.calculate() == 0);
        return rail.patch(1).forces();
    };
    const ContactForces polach = solved(3, 5, {0.4, 0.4, 6e-4}), exponential = solved(4, 4, exponential_of_polach());
    CHECK_THAT(polach.fy, WithinRel(exponential.fy, 1e-9));
}

TEST_CASE("friction by temperature that varies over a rail without a change is that which does not vary", "[heat]") {
    const auto side = GENERATE(contactd::Side::left, contactd::Side::right);
    const bool is_curved = GENERATE(false, true);
    const int varies = GENERATE(10, 20);
    CAPTURE(side, is_curved, varies);
    const auto& known =
        *std::ranges::find(contactd::test::manchester_cases, side, &contactd::test::ManchesterCase::side);
    const auto solved = [&](int ire, int method, const Values& friction) {
        RailCase rail = manchester_wheel(ire, side);
        place(rail, known);
        rail.velocity(2, {20000, 0, 0, 0, 0, 10 * known.pitch_rate * 1.01});
        if (is_curved) rail.whole.flag(1977, 4);
        rail.whole.friction(method, friction);
        CHECK(last_sentence().empty());
        heat(rail);
        REQUIRE(rail.whole.calculate() == 0);
        Case patch = rail.patch(1);
        return std::pair(patch.forces(), patch.field(2));
    };
    const double memory = GENERATE(0, 0.01);
    CAPTURE(memory);
    const Values law{0.4, 20, -0.2, 100, memory, 1};
    Values twice{2};
    for (const double place : {-1.0, 1.0}) {
        twice.push_back(place);
        twice.insert(twice.end(), law.begin(), law.end());
    }
    const auto [forces, mu] = solved(7, 6, law);
    const auto [by_place, mu_by_place] = solved(8, varies + 6, twice);
    CHECK_THAT(by_place.fx, WithinRel(forces.fx, 1e-9));
    REQUIRE(mu.size() == mu_by_place.size());
    double least = 1;
    for (std::size_t i = 0; i < mu.size(); ++i) {
        CHECK_THAT(mu_by_place[i], WithinRel(mu[i], 1e-9));
        least = std::min(least, mu[i]);
    }
    CHECK(least < 0.39);  // somewhere it is warm
}

TEST_CASE("between two places along the track each number of a law is interpolated, and constant beyond", "[heat]") {
    struct Laws {
        int law;
        Values one, other, mean;
    };
    const Laws laws = GENERATE(
        Laws{0, {0.2, 0.2}, {0.4, 0.4}, {0.3, 0.3}},
        Laws{4,
             {0.1, 0.2, 100, 0.1, 3000, 0.002, 1},
             {0.2, 0.1, 300, 0.05, 1000, 0.004, 3},
             {0.15, 0.15, 200, 0.075, 2000, 0.003, 2}},
        // A law that does not fall, without slip velocities, beside one with two terms.
        Laws{2,
             {0.3, 0, 0, 0, 0, 0, 1},
             {0.1, 0.2, 400, 0.1, 2000, 0, 1},
             {0.2, 0.1, 200.00005, 0.05, 1000.00005, 0, 1}},
        // Different terms that fall.
        Laws{3, {0.2, 0.1, 200, 0, 1, 0, 1}, {0.2, 0, 1, 0.1, 200, 0, 1}, {0.2, 0.05, 100.5, 0.05, 100.5, 0, 1}},
        Laws{6, {0.4, 20, -0.2, 100, 0.002, 1}, {0.3, 40, -0.1, 300, 0.004, 3}, {0.35, 30, -0.15, 200, 0.003, 2}});
    CAPTURE(laws.law);
    const auto& known = contactd::test::manchester_cases[0];
    const auto solved = [&](int ire, int method, const Values& friction, double along) {
        RailCase rail = manchester_wheel(ire, known.side);
        place(rail, known);
        rail.position(2, {along, known.y, 0, known.roll, known.yaw, 0});
        rail.velocity(2, {20000, 0, 0, 0, 0, 10 * known.pitch_rate * 1.01});
        rail.whole.friction(method, friction);
        CHECK(last_sentence().empty());
        if (laws.law == 6) heat(rail);
        REQUIRE(rail.whole.calculate() == 0);
        CHECK(last_sentence().empty());
        return rail.patch(1).forces().fx;
    };
    Values both{2};
    for (const auto& [at, law] : {std::pair(-1000.0, laws.one), std::pair(1000.0, laws.other)}) {
        both.push_back(at);
        both.insert(both.end(), law.begin(), law.end());
    }
    const int varies = 20 + laws.law;
    CHECK_THAT(solved(5, varies, both, 0), WithinRel(solved(6, laws.law, laws.mean, 0), 1e-6));
    for (const double at : {-2000.0, -1000.0}) CHECK(solved(5, varies, both, at) == solved(6, laws.law, laws.one, at));
    for (const double at : {1000.0, 5000.0}) CHECK(solved(5, varies, both, at) == solved(6, laws.law, laws.other, at));
}

TEST_CASE("friction along the track that is given too far apart is warned of once a solve needs it") {
    const auto& known = contactd::test::manchester_cases[0];
    RailCase rail = manchester_wheel(5, known.side);
    const auto sentence_at = [&](double along) {
        place(rail, known);
        rail.position(2, {along, known.y, 0, known.roll, known.yaw, 0});
        REQUIRE(rail.whole.calculate() == 0);
        CHECK(last_code() == 0);
        return last_sentence();
    };
    rail.whole.friction(20, {3, 0, 0.2, 0.2, 20000, 0.5, 0.5, 21000, 0.2, 0.2});
    CHECK_THAT(sentence_at(5000), ContainsSubstring("Warning:") &&
                                      ContainsSubstring("0 and 20000 mm along the track") &&
                                      ContainsSubstring("differ by 0.3"));
    CHECK(sentence_at(20500).empty());
    CHECK(sentence_at(0).empty());
    CHECK(sentence_at(-5000).empty());
}

TEST_CASE("a wrong number of friction positions is refused") {
    RailCase rail = manchester_wheel(10, contactd::Side::right);
    rail.whole.friction(20, {0});
    CHECK(last_code() == -33);
    CHECK_THAT(last_sentence(), ContainsSubstring("The number of friction positions is 0"));
    rail.whole.friction(20, {2, 0, 0.2, 0.2});
    CHECK(last_code() == -33);
    CHECK_THAT(last_sentence(),
               ContainsSubstring("Friction at 2 positions requires 1 + 2 x 3 values, but nparam is 4"));
}

TEST_CASE("memory of friction by temperature that differs between angles is refused", "[heat]") {
    RailCase rail = manchester_wheel(9, contactd::Side::right);
    const auto varying = [](double first, double second) {
        return Values{2, -1, 0.4, 20, -0.2, 100, first, 1, 1, 0.4, 20, -0.1, 100, second, 1};
    };
    rail.whole.friction(16, varying(0.01, 0.01));
    CHECK(last_code() == 0);
    for (const double second : {0.0, 0.02}) {
        rail.whole.friction(16, varying(0.01, second));
        CHECK(last_code() == -33);
        CHECK_THAT(last_sentence(), ContainsSubstring("MEMDST or MEM_S0 differs between angles"));
    }
}

TEST_CASE("simplified theories go on without the memory of friction, and say so") {
    const int method = GENERATE(3, 5);
    Case contact = wheel(1), without = wheel(2);
    for (Case* one : {&contact, &without}) {
        material(*one, method, {0.28, 0.28, 82000, 82000, 1, 1, 0});
        one->flag(1971, 2);
        one->velocity(20000);
    }
    without.friction(4, {0.16, 0.24, 1000, 0, 1, 0, 0});
    REQUIRE(without.calculate() == 0);
    CHECK(last_sentence().empty());

    contact.friction(4, {0.16, 0.24, 1000, 0, 1, 0.003, 1});
    REQUIRE(contact.calculate() == 0);

    CHECK(last_code() == 0);
    CHECK_THAT(last_sentence(), ContainsSubstring("MEMDST = 0.003 mm has no effect"));
    CHECK(contact.forces() == without.forces());
    contact.friction(5, {0.4, 0.4, 6e-4});
    REQUIRE(contact.calculate() == 0);
    CHECK_THAT(last_sentence(), ContainsSubstring("MEMDST = 0.001 mm has no effect"));
    contact.forces();
    CHECK(last_sentence().empty());
}

TEST_CASE("simplified theories on a rail go on without the memory of friction, and say so") {
    const auto& known = contactd::test::manchester_cases[0];
    const auto solved = [&](int ire, double memory) {
        RailCase rail = manchester_wheel(ire, known.side);
        place(rail, known);
        material(rail.whole, 3, {0.28, 0.28, 82000, 82000, 1, 1, 0});
        rail.whole.flag(1971, 5);
        rail.whole.friction(4, {0.16, 0.24, 1000, 0, 1, memory, 1});
        REQUIRE(rail.whole.calculate() == 0);
        CHECK(last_sentence().empty() == (memory == 0));
        return rail.patch(1).forces();
    };
    CHECK(solved(5, 0.003) == solved(6, 0));
}

TEST_CASE("no damping, and that which is kept or zero, are accepted, and other damping is refused") {
    Case contact = wheel(1);
    material(contact, 10, {});
    CHECK(last_code() == 0);
    material(contact, 11, {});
    CHECK(last_code() == 0);
    material(contact, 12, {0, 0, 100, 100});
    CHECK(last_code() == 0);
    CHECK(contact.get_flag(1979) == 0);
    REQUIRE(contact.calculate() == 0);

    material(contact, 12, {0, 0.01, 100, 100});
    CHECK(last_code() == -39);
    CHECK_THAT(last_sentence(), ContainsSubstring("CDAMPN and CDAMPT"));
    CHECK(contact.calculate() == -39);
    material(contact, 11, {});  // keeps it
    CHECK(contact.calculate() == -39);
    contact.material(0.28, 0.28, 82000, 82000);  // says nothing of it
    CHECK(contact.calculate() == -39);
    material(contact, 10, {});
    CHECK(contact.calculate() == 0);
}
