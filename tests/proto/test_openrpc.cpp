#include <catch2/catch_test_macros.hpp>

#include <functional>
#include <string>
#include <vector>

#include "contactd/proto/schema.hpp"

using namespace contactd::proto;
using nlohmann::json;

namespace {

std::vector<json> params_of(const std::string& method) {
    for (const json& candidate : openrpc()["methods"])
        if (candidate["name"] == method) return candidate["params"];
    return {};
}

}  // namespace

TEST_CASE("The OpenRPC document describes every method", "[openrpc]") {
    CHECK(openrpc()["openrpc"].get<std::string>().starts_with("1.3"));
    CHECK(openrpc()["info"]["version"].is_string());
    std::vector<std::string> names;
    for (const json& method : openrpc()["methods"]) {
        names.push_back(method["name"]);
        CHECK(method["paramStructure"] == "by-name");
        CHECK(method["result"]["schema"].is_object());
        CHECK_FALSE(method["errors"].empty());
    }
    CHECK(names == method_names());
}

TEST_CASE("Parameters are listed one by one, the required ones first", "[openrpc]") {
    std::vector<std::string> required, optional;
    for (const json& param : params_of("contact.solve")) {
        CHECK_FALSE(param["description"].get<std::string>().empty());
        if (param["required"].get<bool>()) CHECK(optional.empty());
        (param["required"].get<bool>() ? required : optional).push_back(param["name"]);
    }
    CHECK(required == std::vector<std::string>{"gap", "grid"});
    CHECK(optional == std::vector<std::string>{"Fn", "approach", "bodies", "friction", "ics", "initial", "model",
                                               "previous", "settings"});
}

TEST_CASE("Every reference of the document can be followed", "[openrpc]") {
    int references = 0;
    const std::function<void(const json&)> visit = [&](const json& node) {
        if (node.is_object() && node.contains("$ref")) {
            const auto target = node["$ref"].get<std::string>();
            CAPTURE(target);
            REQUIRE(target.starts_with("#/"));
            CHECK(openrpc().contains(json::json_pointer(target.substr(1))));
            ++references;
        }
        if (node.is_structured())
            for (const json& child : node) visit(child);
    };
    visit(openrpc());
    CHECK(references > 20);
}

TEST_CASE("The document is a result of server.describe", "[openrpc]") {
    CHECK(violations_of("server.describe.result", openrpc()).empty());
}
