// Tests properties of every field of a struct that the schemas declare.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/generators/catch_generators_range.hpp>

#include "contactd/error.hpp"
#include "contactd/fields/conicity.hpp"
#include "contactd/fields/contact_setup.hpp"
#include "contactd/fields/derivatives.hpp"
#include "contactd/fields/friction.hpp"
#include "contactd/fields/gap.hpp"
#include "contactd/fields/ic_spec.hpp"
#include "contactd/fields/ic_table.hpp"
#include "contactd/fields/profile_spec.hpp"
#include "contactd/fields/session.hpp"
#include "contactd/fields/solve_reply.hpp"
#include "contactd/fields/wheel_rail_setup.hpp"
#include "contactd/fields/wheel_rail_solution.hpp"
#include "contactd/fields/wheel_rail_state.hpp"
#include "contactd/proto/field_codec.hpp"
#include "contactd/proto/schema.hpp"
#include "support/random_fields.hpp"

using namespace contactd;
using namespace contactd::proto;
using nlohmann::json;

TEMPLATE_TEST_CASE("Every field comes back from the wire as it was", "[fields]", WheelRailSetup, WheelRailState,
                   WheelsetState, WheelRailFriction, KineticFriction, ContactSettings, PatchRules, Track,
                   ContactReference, Creepages, ContactRow, Wrench, WheelRailDerivatives, RailDeflection,
                   Discretisation, Rolling, RigidContact, WheelsetContacts, ConicityRequest, FemSpec, Extent,
                   Derivatives, OperatorUse) {
    const auto value = with_random_fields<TestType>(GENERATE(range(0u, 20u)));
    ArrayWriter arrays(ArrayEncoding::list);
    const json written = write_fields(value, MemberPath("value"), {&arrays});
    TestType read;
    REQUIRE(read != value);
    read_fields(json::parse(written.dump()), read, MemberPath("value"));
    CHECK(read == value);
}

TEMPLATE_TEST_CASE("Every field of what cannot be compared is written again as it was read", "[fields]", ContactProblem,
                   StepInput, IcEvidence) {
    auto value = with_random_fields<TestType>(GENERATE(range(0u, 20u)));
    const Grid grid{3, 2, 0.5, 0.25, 7, -1};
    if constexpr (std::is_same_v<TestType, ContactProblem>) {
        value.grid = grid;
        value.columns->frames = {{1, 2, 3}, {4, 5, 6}};
    }
    ArrayWriter arrays(ArrayEncoding::list);
    const json written = write_fields(value, MemberPath("value"), {&arrays, &grid});
    TestType read;
    read_fields(json::parse(written.dump()), read, MemberPath("value"), {{}, &grid});
    CHECK(write_fields(read, MemberPath("value"), {&arrays, &grid}) == written);
    CHECK(written != write_fields(TestType{}, MemberPath("value"), {&arrays, &grid}));
}

TEST_CASE("Arrays of a problem have the shape of its grid", "[fields]") {
    ContactProblem problem;
    problem.grid = Grid::of_elements(2, 1, 1, 1);
    problem.gap = std::vector<double>{0, 0.5};
    problem.friction = FrictionLaw{{0.2, 0.3}};
    problem.rigid_slip = {{1, 2}, {3, 4}};
    problem.previous.traction_x = {5, 6};
    ArrayWriter arrays(ArrayEncoding::list);
    const json written = write_fields(problem, MemberPath(""), {&arrays, &problem.grid});
    CHECK(written["gap"] == json{{"array", {{0, 0.5}}}});
    CHECK(written["friction"]["mu"] == json{{0.2, 0.3}});
    CHECK(written["previous"] == json{{"traction_x", {{5, 6}}}});
    CHECK_FALSE(written.contains("initial"));
    ContactProblem read;
    read_fields(written, read, MemberPath(""), {{}, &read.grid});
    CHECK(std::get<std::vector<double>>(*read.gap) == std::vector<double>{0, 0.5});
    CHECK(read.friction == problem.friction);
    CHECK(read.rigid_slip == problem.rigid_slip);
    CHECK(read.previous == problem.previous);
}

TEST_CASE("What a number is where it is left out stands in no message", "[fields]") {
    CHECK(write_fields(Rolling{}, MemberPath("rolling")).contains("dq") == false);
    CHECK(write_fields(Rolling{.dq = 0.5}, MemberPath("rolling"))["dq"] == 0.5);
    CHECK(write_fields(Paraboloid{.Rx = 460}, MemberPath("gap")) == json{{"Rx", 460.0}});
}

TEST_CASE("A force of which one component is prescribed is a pair with null", "[fields]") {
    const json written = write_fields(Rolling{.force = {.Fy = 3}}, MemberPath("rolling"));
    CHECK(written["force"] == json{nullptr, 3.0});
    Rolling read{.force = {.Fx = 1}};
    read_fields(written, read, MemberPath("rolling"));
    CHECK(read.force == Force{.Fy = 3});
    CHECK_FALSE(write_fields(Rolling{}, MemberPath("rolling")).contains("force"));
}

TEMPLATE_TEST_CASE("What an optional field was set to can be unset by the wire", "[fields]", WheelRailSetup,
                   WheelRailState, Track) {
    auto value = with_random_fields<TestType>(1);
    const FieldType& type = type_of<TestType>();
    for (const Field& field : type.fields)
        if (field.clear) field.clear(&value);
    ArrayWriter arrays(ArrayEncoding::list);
    TestType read;
    read_fields(write_fields(value, MemberPath("value"), {&arrays}), read, MemberPath("value"));
    CHECK(read == value);
}

TEMPLATE_TEST_CASE("Every number that is out of its bounds is refused by its path", "[fields]", WheelRailSetup,
                   WheelRailState, WheelsetState, KineticFriction, ContactSettings) {
    auto value = with_random_fields<TestType>(7);
    REQUIRE_NOTHROW(check_bounds(value));
    int refused = 0;
    visit_numbers(type_of<TestType>(), &value, "", [&](const Field&, double& number, const std::string& path) {
        CAPTURE(path);
        const double kept = std::exchange(number, std::numeric_limits<double>::quiet_NaN());
        try {
            check_bounds(value);
        } catch (const InvalidArgument& error) {
            CHECK(error.field() == path);
            CHECK(error.problem().starts_with("is nan; it must "));
            ++refused;
        }
        number = kept;
    });
    int numbers = 0;
    visit_numbers(type_of<TestType>(), &value, "", [&](const Field&, double&, const std::string&) { ++numbers; });
    CHECK(numbers > 1);
    CHECK(refused == numbers);
}

TEST_CASE("A random set-up and a random state conform to their schema", "[fields]") {
    const unsigned seed = GENERATE(range(0u, 20u));
    ArrayWriter arrays(ArrayEncoding::list);
    const json params{{"setup", write_fields(with_random_fields<WheelRailSetup>(seed), MemberPath("setup"), {&arrays})},
                      {"state", write_fields(with_random_fields<WheelRailState>(seed), MemberPath("state"))}};
    CHECK_NOTHROW(check_params("wheelrail.solve", params));
}

TEST_CASE("A number that is not finite cannot be written, and is named by its path", "[fields]") {
    WheelRailSetup setup;
    setup.track.springs = RailSprings{1e4, std::numeric_limits<double>::infinity()};
    ArrayWriter arrays(ArrayEncoding::list);
    try {
        write_fields(setup, MemberPath("setup"), {&arrays});
        FAIL("It was written.");
    } catch (const InvalidArgument& error) {
        CHECK(error.field() == "setup.track.springs.z");
    }
}

TEST_CASE("The mirror image of a state's mirror image is the state", "[fields]") {
    const auto state = with_random_fields<WheelRailState>(3);
    WheelRailState twice = state;
    mirror_fields(twice);
    CHECK(twice.position.y == -state.position.y);
    CHECK(twice.position.z == state.position.z);
    mirror_fields(twice);
    CHECK(twice == state);
}

TEST_CASE("Forces by a motion to the side turn all signs but those that turn themselves", "[fields]") {
    WheelRailDerivatives derivatives;
    derivatives.position.z = derivatives.position.y = {1, 2, 3, 4, 5, 6};
    mirror_fields(derivatives);
    CHECK(derivatives.position.z == Wrench{1, -2, 3, -4, 5, -6});
    CHECK(derivatives.position.y == Wrench{-1, 2, -3, 4, -5, 6});
}
