// Viscoelastic bodies: the material method 1.
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <string>

#include "client/cntc/calls.hpp"

using namespace contactd::cntc::test;
using Catch::Matchers::WithinRel;

namespace {

void viscoelastic(Case& contact, double f1, double f2, double tau1, double tau2) {
    int method = 1, count = 8;
    std::array values{0.28, 0.28, 82000.0, 82000.0, f1, f2, tau1, tau2};
    cntc_setmaterialparameters(contact.ire(), contact.icp(), &method, &count, values.data());
}

}  // namespace

TEST_CASE("creep makes a contact wider, and that at once is elastic") {
    Case contact = wheel(1);
    contact.hertz(-3, {25, 25, 6, 4, 2});
    contact.creepages(5e-4, 0, 0);
    contact.velocity(1000);
    REQUIRE(contact.calculate() == 0);
    const double stiff = contact.areas().contact;
    viscoelastic(contact, 1, 1, 0, 0);
    CHECK(contact.get_flag(1979) == 1);
    REQUIRE(contact.calculate() == 0);
    const double soft = contact.areas().contact;
    CHECK_THAT(soft, WithinRel(std::cbrt(4.0) * stiff, 0.05));
    viscoelastic(contact, 1, 1, 5e-3, 5e-3);
    REQUIRE(contact.calculate() == 0);
    CHECK(contact.areas().contact > stiff);
    CHECK(contact.areas().contact < soft);
    contact.material(0.28, 0.28, 82000, 82000);
    CHECK(contact.get_flag(1979) == 0);
    REQUIRE(contact.calculate() == 0);
    CHECK_THAT(contact.areas().contact, WithinRel(stiff, 1e-12));
}

TEST_CASE("a flag makes bodies elastic and viscoelastic again") {
    Case contact = wheel(1);
    contact.hertz(-3, {25, 25, 6, 4, 2});
    contact.creepages(5e-4, 0, 0);
    contact.velocity(1000);
    REQUIRE(contact.calculate() == 0);
    const double stiff = contact.areas().contact;
    viscoelastic(contact, 1, 1, 5e-3, 5e-3);
    REQUIRE(contact.calculate() == 0);
    const double creeping = contact.areas().contact;
    REQUIRE(creeping > stiff);
    contact.flag(1979, 0);
    REQUIRE(contact.calculate() == 0);
    CHECK_THAT(contact.areas().contact, WithinRel(stiff, 1e-12));
    contact.flag(1979, 1);
    REQUIRE(contact.calculate() == 0);
    CHECK_THAT(contact.areas().contact, WithinRel(creeping, 1e-12));
}

TEST_CASE("viscoelastic bodies require their creep") {
    Case contact = wheel(1);
    contact.hertz(-3, {25, 25, 6, 4, 2});
    contact.creepages(5e-4, 0, 0);
    contact.velocity(1000);
    contact.flag(1979, 1);
    CHECK(contact.calculate() < 0);
    CHECK(last_sentence().find("requires the creep of both bodies") != std::string::npos);
}

TEST_CASE("what was set of creep is told back") {
    Case contact = wheel(1);
    viscoelastic(contact, 1, 2, 0.01, 0.02);
    int task = 2, room = 8;
    std::array<double, 8> values{};
    cntc_getparameters(contact.ire(), contact.icp(), &task, &room, values.data());
    CHECK(values == std::array{0.28, 0.28, 82000.0, 82000.0, 1.0, 2.0, 0.01, 0.02});
}

TEST_CASE("creep that makes no sense, or does not roll steadily, is refused") {
    Case contact = wheel(1);
    viscoelastic(contact, -1, 1, 0.01, 0.01);
    CHECK(last_code() == -39);
    viscoelastic(contact, 1, 1, 0.01, 0.01);
    contact.flag(1972, 1);
    CHECK(contact.calculate() < 0);
    CHECK(last_sentence().find("viscoelastic") != std::string::npos);
}
