#include "contactd/fem_fields.hpp"

#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <tuple>
#include <type_traits>

#include "contactd/error.hpp"
#include "contactd/fields/ic_spec.hpp"

using namespace contactd;

namespace {

/// Creates a spec whose every member differs from its default.
FemSpec unusual() {
    return {.mesh = MeshKind::prism,
            .order = 1,
            .l_over_h = 2.5,
            .h_over_hs = 6,
            .f = 1.7,
            .t1_over_hs = 0.3,
            .L_over_h = 12.5,
            .diagonal = Diagonal::across,
            .max_dofs = 4'000'000,
            .far_boundary = FarBoundary::clamped,
            .sampling = Sampling::linear,
            .solver = Solver::amg_pcg,
            .stopping_criterion = StoppingCriterion::update,
            .tolerance = 1e-11,
            .max_iterations = 77,
            .strength_threshold = 0.6};
}

template <class Value>
FemSpec with(Value FemSpec::* member, Value value) {
    FemSpec fem;
    fem.*member = value;
    return fem;
}

/// Returns the field whose own rule refuses a spec that is valid except for `change`.
std::string broken_field(const auto& change) {
    IcSpec spec;
    spec.material = {1, 0.28};
    spec.dx = spec.dy = 1;
    spec.nx = spec.ny = 4;
    spec.source = IcSource::fem;
    change(spec.fem);
    try {
        validate(spec);
        return {};
    } catch (const InvalidArgument& error) {
        return error.field();
    }
}

}  // namespace

TEST_CASE("Every member of a FemSpec is a field") {
    // Fails to compile when a member is added, which must then be added to the list, to unusual(), and to this line.
    const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p] = FemSpec{};
    CHECK(std::tuple_size_v<decltype(std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p))> ==
          std::tuple_size_v<decltype(fem_fields)>);

    const FemSpec source = unusual();
    FemSpec copy;
    for_each_fem_field([&](const auto& field) {
        CAPTURE(field.name);
        CHECK(copy.*field.member != source.*field.member);
        copy.*field.member = source.*field.member;
    });
    CHECK(copy == source);
}

TEST_CASE("No two fields have the same name") {
    std::set<std::string> names;
    for_each_fem_field([&](const auto& field) { names.insert(field.name); });
    CHECK(names.size() == std::tuple_size_v<decltype(fem_fields)>);
}

TEST_CASE("Every number of a FemSpec has a rule, which refuses what is no number") {
    for_each_fem_field([]<class Value>(const FemField<Value>& field) {
        CAPTURE(field.name);
        if constexpr (!HasWords<Value>) {
            CHECK((field.range.rule || field.broken_rule));
            CHECK(broken_field([&](FemSpec& fem) { fem.*field.member = -1; }) == std::string("ics.") + field.name);
        }
        if constexpr (std::is_convertible_v<double, Value> && !std::is_integral_v<Value>) {
            constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
            CHECK(broken_field([&](FemSpec& fem) { fem.*field.member = no_number; }) ==
                  std::string("ics.") + field.name);
        }
    });
}

TEST_CASE("The ends of a range are allowed, and nothing beyond them") {
    const auto tolerance = [](double value) { return broken_field([&](FemSpec& fem) { fem.tolerance = value; }); };
    CHECK(tolerance(1e-13).empty());
    CHECK(tolerance(9.9e-14) == "ics.tolerance");
    CHECK(tolerance(std::nextafter(1.0, 0.0)).empty());
    CHECK(tolerance(1) == "ics.tolerance");
    const auto order = [](int value) { return broken_field([&](FemSpec& fem) { fem.order = value; }); };
    CHECK(order(1).empty());
    CHECK(order(6).empty());
    CHECK(order(7) == "ics.order");
}

TEST_CASE("What a mesh or a solver does not know makes no other table") {
    const auto counts = [](const FemSpec& fem, auto member) {
        bool matters = true;
        for_each_fem_field([&]<class Value>(const FemField<Value>& field) {
            if constexpr (std::is_same_v<Value FemSpec::*, decltype(member)>)
                if (field.member == member) matters = !field.matters || field.matters(fem);
        });
        return matters;
    };
    CHECK(counts(with(&FemSpec::mesh, MeshKind::prism), &FemSpec::diagonal));
    CHECK(!counts(with(&FemSpec::mesh, MeshKind::hex), &FemSpec::diagonal));
    CHECK(counts(with(&FemSpec::mesh, MeshKind::adaptive), &FemSpec::max_dofs));
    CHECK(!counts(with(&FemSpec::mesh, MeshKind::hex), &FemSpec::max_dofs));
    CHECK(!counts(with(&FemSpec::mesh, MeshKind::adaptive), &FemSpec::f));
    CHECK(counts(with(&FemSpec::mesh, MeshKind::hex), &FemSpec::f));
    CHECK(!counts(with(&FemSpec::solver, Solver::direct), &FemSpec::strength_threshold));
    CHECK(counts(with(&FemSpec::solver, Solver::amg_pcg), &FemSpec::strength_threshold));
    CHECK(counts(with(&FemSpec::solver, Solver::direct), &FemSpec::tolerance));
}

TEST_CASE("Each enumerator has a word of its own, which means it again") {
    const auto check = []<class Enum>(Enum) {
        std::set<std::string_view> keywords;
        for (std::size_t at = 0; at < enum_words<Enum>.size(); ++at) {
            const auto value = static_cast<Enum>(at);
            Enum found{};
            keywords.insert(name_of(value));
            REQUIRE(from_name(name_of(value), found));
            CHECK(found == value);
        }
        CHECK(keywords.size() == enum_words<Enum>.size());
        Enum untouched{};
        CHECK(!from_name("no such word", untouched));
        CHECK_THROWS_AS(name_of(static_cast<Enum>(enum_words<Enum>.size())), Error);
    };
    check(BodyShape{});
    check(LoadShape{});
    check(IcSource{});
    for_each_fem_field([&]<class Value>(const FemField<Value>&) {
        if constexpr (HasWords<Value>) check(Value{});
    });
    CHECK(name_of(Solver::automatic) == "auto");
    CHECK(name_of(Sampling::linear_nodes) == "linear_nodes");
    CHECK(name_of(FarBoundary::half_space) == "half_space");
    CHECK(name_of(StoppingCriterion::update) == "update");
    CHECK(name_of(MeshKind::adaptive) == "adaptive");
    CHECK(name_of(Diagonal::across) == "across");
    CHECK(name_of(BodyShape::block) == "block");
    CHECK(name_of(LoadShape::bilinear) == "bilinear");
    CHECK(name_of(IcSource::fem) == "fem");
}
