#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "contactd/proto/schema.hpp"
#include "methods/all_methods.hpp"
#include "methods/cost_examples.hpp"

using namespace contactd;
using namespace contactd::server;

TEST_CASE("Every method of the wire has its handler, and no other is there") {
    const MethodTable methods = all_methods();
    std::vector<std::string> described = proto::method_names();
    std::sort(described.begin(), described.end());

    CHECK(methods.names() == described);
    for (const std::string& name : described) {
        const Method& method = *methods.find(name);
        CHECK((method.handle == nullptr) != (method.queue == nullptr));
    }
    CHECK(methods.find("server.restart") == nullptr);
}

TEST_CASE("A method that waits for nothing does not count, all others do") {
    const MethodTable methods = all_methods();
    CHECK_FALSE(methods.find("server.health")->counts);
    CHECK(methods.find("health.watch")->counts);
    CHECK(methods.find("contact.solve")->counts);
    CHECK_FALSE(methods.find("contact.solve")->is_immediate);
}

TEST_CASE("Steps of a session go before solves, and these before many of them") {
    const MethodTable methods = all_methods();
    CHECK(methods.find("session.step")->priority == proto::Priority::high);
    CHECK(methods.find("contact.solve")->priority == proto::Priority::normal);
    CHECK(methods.find("contact.solve_many")->priority == proto::Priority::low);
}

TEST_CASE("Every method whose work is not little shows a large request, which conforms to its schema") {
    const MethodTable methods = all_methods();
    std::set<std::string> shown;
    for (const auto& example : cost_examples(config_from_json(nlohmann::json::object()))) {
        const std::string name = example["method"];
        CAPTURE(name);
        CHECK(shown.insert(name + example["arguments"].get<std::string>()).second);
        shown.insert(name);
        CHECK(example["bytes"].is_null() == (methods.find(name)->cost == nullptr));
        if (example.contains("params")) CHECK_NOTHROW(proto::check_params(name, example["params"]));
    }
    for (const std::string& name : methods.names()) CHECK(shown.contains(name));
}

TEST_CASE("A large request is written out from what its schema abbreviates") {
    for (const auto& example : cost_examples(config_from_json(nlohmann::json::object())))
        if (example["method"] == "wheelrail.geometry") {
            const auto& states = example["params"]["states"];
            REQUIRE(states.size() == 1000);
            CHECK(states[1]["position"]["y"].get<double>() > 0);
            CHECK(states[999]["position"]["y"].get<double>() < 5);
        }
}
