// What holds of every field of a struct that the schemas declare, whichever fields these are.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/generators/catch_generators_range.hpp>

#include "codec/field_codec.hpp"
#include "contactd/error.hpp"
#include "contactd/fields/contact_setup.hpp"
#include "contactd/fields/friction.hpp"
#include "contactd/fields/profile_spec.hpp"
#include "contactd/fields/wheel_rail_setup.hpp"
#include "contactd/fields/wheel_rail_solution.hpp"
#include "contactd/fields/wheel_rail_state.hpp"
#include "contactd/proto/schema.hpp"
#include "support/random_fields.hpp"

using namespace contactd;
using namespace contactd::proto;
using nlohmann::json;

TEMPLATE_TEST_CASE("Every field comes back from the wire as it was", "[fields]", WheelRailSetup, WheelRailState,
                   WheelsetState, WheelRailFriction, KineticFriction, ContactSettings, PatchRules, Track,
                   ContactReference, Creepages, ContactRow, Wrench, WheelRailDerivatives, RailShift, Discretisation) {
    const auto value = with_random_fields<TestType>(GENERATE(range(0u, 20u)));
    ArrayWriter arrays(ArrayEncoding::list);
    const json written = write_fields(value, MemberPath("value"), &arrays);
    TestType read;
    REQUIRE(read != value);
    read_fields(json::parse(written.dump()), read, MemberPath("value"));
    CHECK(read == value);
}

TEMPLATE_TEST_CASE("What an optional field was set to can be unset by the wire", "[fields]", WheelRailSetup,
                   WheelRailState, Track) {
    auto value = with_random_fields<TestType>(1);
    const FieldType& type = type_of<TestType>();
    for (const Field& field : type.fields)
        if (field.clear) field.clear(&value);
    ArrayWriter arrays(ArrayEncoding::list);
    TestType read;
    read_fields(write_fields(value, MemberPath("value"), &arrays), read, MemberPath("value"));
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
    const json params{{"setup", write_fields(with_random_fields<WheelRailSetup>(seed), MemberPath("setup"), &arrays)},
                      {"state", write_fields(with_random_fields<WheelRailState>(seed), MemberPath("state"))}};
    CHECK_NOTHROW(check_params("wheelrail.solve", params));
}

TEST_CASE("A number that is not finite cannot be written, and is named by its path", "[fields]") {
    WheelRailSetup setup;
    setup.track.springs = RailSprings{1e4, std::numeric_limits<double>::infinity()};
    ArrayWriter arrays(ArrayEncoding::list);
    try {
        write_fields(setup, MemberPath("setup"), &arrays);
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
