// Tests the part of rolling's preconditioner that divides by A, for all elements and for those near adhesion.
#include "contact/rolling/influence_division.hpp"

#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "plain_operator.hpp"
#include "rolling_cases.hpp"

using namespace contactd;
using namespace contactd::test;

namespace {

/// Creates an ellipse that adheres in its right part, from column `first` on.
struct Example {
    RollingCase rolling{Grid::of_elements(64, 48, 2.0 / 64, 1.4 / 48), {1000, 0.28}, 3, 0, 2.0 / 64};
    Contact contact{rolling.bound, Values(rolling.bound.size()), Values(rolling.bound.size())};
    Linearisation law{contact.size()};
    Field r{contact.size()}, q{contact.size()};

    explicit Example(int first) {
        for (std::size_t e = 0; e < contact.size(); ++e) {
            law.slips[e] = column(e) < first;
            law.tangent_stiffness[e] = law.slips[e] ? 0.1 * self() : 0;
            r.x[e] = std::sin(0.3 * static_cast<double>(e));
            r.y[e] = std::cos(0.2 * static_cast<double>(e));
        }
    }
    int column(std::size_t e) const { return static_cast<int>(contact.elements[e]) % rolling.grid.nx; }
    double self() const { return rolling.influence.diagonal(Axis::x)[0]; }
    InfluenceDivision division(const InfluenceOperator& influence) const {
        InfluenceDivision division(influence, contact, tangential_diagonal(influence, contact), 1);
        division.linearise(law);
        return division;
    }
};

}  // namespace

TEST_CASE("near adhesion the quotient is that of the whole contact", "[rolling]") {
    Example example(48);
    InfluenceDivision division = example.division(example.rolling.influence);
    division.divide(example.r, example.q);
    const Field whole = example.q;
    REQUIRE(division.take_adhesion(example.law.slips));
    division.divide(example.r, example.q);
    double error = 0, size = 0;
    std::size_t counting = 0;
    for (std::size_t e = 0; e < example.contact.size(); ++e) {
        counting += division.counts(e);
        if (example.law.slips[e]) continue;
        REQUIRE(division.counts(e));
        error += std::pow(example.q.x[e] - whole.x[e], 2) + std::pow(example.q.y[e] - whole.y[e], 2);
        size += std::pow(whole.x[e], 2) + std::pow(whole.y[e], 2);
    }
    CHECK(std::sqrt(error / size) < 0.1);
    CHECK(counting < example.contact.size() / 2);
}

TEST_CASE("the elements that count change with adhesion, and only when that pays", "[rolling]") {
    Example example(48);
    InfluenceDivision division = example.division(example.rolling.influence);
    CHECK_FALSE(division.take_all());
    CHECK(division.take_adhesion(example.law.slips));
    CHECK_FALSE(division.take_adhesion(example.law.slips));
    const Example smaller(50), larger(20);
    CHECK_FALSE(division.take_adhesion(smaller.law.slips));
    CHECK(division.take_adhesion(larger.law.slips));
    CHECK(division.take_all());
    division.divide(example.r, example.q);
    const Field again = example.q;
    example.division(example.rolling.influence).divide(example.r, example.q);
    CHECK(again.x == example.q.x);
}

TEST_CASE("without boxes all elements count", "[rolling]") {
    const Example example(48);
    const PlainOperator plain(example.rolling.operators.current);
    InfluenceDivision division = example.division(plain);
    CHECK_FALSE(division.take_adhesion(example.law.slips));
    CHECK(division.counts(0));
}
