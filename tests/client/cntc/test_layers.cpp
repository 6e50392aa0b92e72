// Layers between the bodies, and laws of friction of two terms with memory.
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "client/cntc/calls.hpp"

using namespace contactd::cntc::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

void layered(Case& contact, double gg3, double thickness, double tau_c0, double k_tau) {
    int method = 4, count = 8;
    std::array values{0.28, 0.28, 82000.0, 82000.0, gg3, thickness, tau_c0, k_tau};
    cntc_setmaterialparameters(contact.ire(), contact.icp(), &method, &count, values.data());
}

void falling(Case& contact, int law, double f2, double memory) {
    int count = 7;
    std::array values{0.14, 0.19, 1250.0, f2, 100.0, memory, 1.0};
    cntc_setfrictionmethod(contact.ire(), contact.icp(), &law, &count, values.data());
}

}  // namespace

TEST_CASE("a layer lowers the force, the more when it flows") {
    Case contact = wheel(1);
    contact.creepages(5e-4, 0, 0);
    REQUIRE(contact.calculate() == 0);
    const double clean = contact.forces().fx;
    layered(contact, 8200, 0.2, 0, 0);
    CHECK(contact.get_flag(1979) == 4);
    REQUIRE(contact.calculate() == 0);
    const double elastic = contact.forces().fx;
    CHECK(std::abs(elastic) < 0.95 * std::abs(clean));
    layered(contact, 8200, 0.2, 40, 1000);
    REQUIRE(contact.calculate() == 0);
    CHECK(std::abs(contact.forces().fx) < 0.95 * std::abs(elastic));
    contact.material(0.28, 0.28, 82000, 82000);
    CHECK(contact.get_flag(1979) == 0);
    REQUIRE(contact.calculate() == 0);
    CHECK_THAT(contact.forces().fx, WithinRel(clean, 1e-5));
}

TEST_CASE("where surfaces stick, displacements undo a shift, with those of the layer") {
    Case contact = wheel(1);
    contact.flag(1972, 1);
    contact.coulomb(10);
    constexpr double shift = 1e-3;
    contact.creepages(shift, 0, 0);
    layered(contact, 8200, 0.2, 0, 0);
    REQUIRE(contact.calculate() == 0);
    constexpr int elements = 625, middle = elements / 2;
    int length = elements;
    std::vector<double> un(elements), ux(elements), uy(elements);
    cntc_getdisplacements(contact.ire(), contact.icp(), &length, un.data(), ux.data(), uy.data());
    CHECK_THAT(ux[middle], WithinRel(-shift, 1e-4));
}

TEST_CASE("a creep curve with a layer and memory has the published force") {
    Case contact(1);
    falling(contact, 4, 0, 0.003);
    contact.hertz(-1, {48, 44, 8e-4, 2.814173e-4, 1.1});
    contact.normal_force(106700);
    layered(contact, 8200, 1.25, 0, 0);
    contact.velocity(10000);
    contact.creepages(0.015, 0, 0);
    REQUIRE(contact.calculate() >= 0);
    CHECK_THAT(std::abs(contact.forces().fx) / (0.33 * 106700), WithinAbs(0.9442, 2e-4));
}

TEST_CASE("layers and laws that make no sense are refused") {
    Case contact = wheel(1);
    layered(contact, 0, 0.2, 0, 0);
    CHECK(last_code() == -39);
    layered(contact, 8200, 0.2, -1, 0);
    CHECK(last_code() == -39);
    falling(contact, 3, -0.1, 0);
    CHECK(last_code() == -33);
    falling(contact, 3, 0.1, -1);
    CHECK(last_code() == -33);
    Case without_one = wheel(2);
    without_one.flag(1979, 4);
    CHECK(without_one.calculate() == -39);
}
