// Tests the access of users to methods.
#include "access/method_access.hpp"

#include <catch2/catch_test_macros.hpp>

using namespace contactd;
using namespace contactd::server;
using nlohmann::json;

TEST_CASE("Without rules everybody may call everything") {
    const MethodRules rules;

    CHECK_FALSE(refusal(rules, "ic.import", "alice"));
    CHECK_FALSE(refusal(rules, "ic.import", ""));
    CHECK(is_allowed(rules, MethodRules::builds, "alice"));
}

TEST_CASE("A method that is switched off is so for all, also for those to whom it is given") {
    const MethodRules rules{{"ic.import"}, {{"ic.import", {"alice"}}}};

    const auto status = refusal(rules, "ic.import", "alice");
    REQUIRE(status);
    CHECK(status->code == StatusCode::unimplemented);
    CHECK(status->reason == reason::method_disabled);
    CHECK_FALSE(refusal(rules, "ic.export", "alice"));
}

TEST_CASE("A method that is given to users is refused to others, and to who has no name") {
    const MethodRules rules{{}, {{"ic.delete", {"alice", "uid:1000"}}, {"job.cancel", {}}}};

    CHECK_FALSE(refusal(rules, "ic.delete", "alice"));
    CHECK_FALSE(refusal(rules, "ic.delete", "uid:1000"));
    for (const char* user : {"bob", "uid:100", "uid:10000", "Alice", ""}) {
        CAPTURE(user);
        const auto status = refusal(rules, "ic.delete", user);
        REQUIRE(status);
        CHECK(status->code == StatusCode::permission_denied);
        CHECK(status->reason == reason::method_denied);
    }
    CHECK(refusal(rules, "job.cancel", "alice"));
    CHECK_FALSE(refusal(rules, "ic.deleted", "bob"));
}

TEST_CASE("The description marks what a user may not call, and nothing else") {
    const MethodRules rules{{"ic.import"}, {{"ic.delete", {"alice"}}, {MethodRules::builds, {}}}};
    const json document{{"methods", {{{"name", "ic.import"}}, {{"name", "ic.delete"}}, {{"name", "ic.get"}}}}};

    const json of_alice = described_for(rules, "alice", document), of_bob = described_for(rules, "bob", document);
    CHECK(of_alice ==
          json{{"methods",
                {{{"name", "ic.import"}, {"x-disabled", true}}, {{"name", "ic.delete"}}, {{"name", "ic.get"}}}}});
    CHECK(of_bob["methods"][1] == json{{"name", "ic.delete"}, {"x-denied", true}});
}
