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
    CHECK(optional == std::vector<std::string>{"Fn",       "accuracy",          "approach",      "bodies",
                                               "columns",  "derivatives",       "displacements", "fatigue",
                                               "fields",   "friction",          "ics",           "initial",
                                               "model",    "normal_model",      "previous",      "regions",
                                               "settings", "sheet_flexibility", "simplified",    "temperature",
                                               "wear"});
}

TEST_CASE("Notes of a schema's file are used, not shown", "[openrpc]") {
    for (const json& method : openrpc()["methods"])
        CHECK(method["summary"] == schema(method["name"].get<std::string>() + ".params")["x-summary"]);
    CHECK(openrpc()["methods"][0]["name"] == "server.info");
    const std::string document = openrpc().dump();
    for (const char* note : {"x-order", "x-summary", "x-errors", "x-arrays-of", "x-cpp", "x-derived", "x-fmu",
                             "x-history", "x-label", "x-largest", "x-only-with", "x-parity", "x-partial", "x-python"}) {
        CAPTURE(note);
        CHECK(document.find(note) == std::string::npos);
    }
    CHECK(document.find("\"x-unit\":\"mm\"") != std::string::npos);
}

TEST_CASE("Errors are those of every method and those that the schema names", "[openrpc]") {
    const auto errors_of = [](const std::string& name) {
        std::vector<std::string> errors;
        for (const json& method : openrpc()["methods"])
            if (method["name"] == name)
                for (const json& error : method["errors"]) errors.push_back(error["message"]);
        return errors;
    };
    CHECK(errors_of("server.info") == std::vector<std::string>{"INVALID_ARGUMENT", "PERMISSION_DENIED", "UNIMPLEMENTED",
                                                               "UNAVAILABLE", "INTERNAL"});
    CHECK(errors_of("job.cancel") == std::vector<std::string>{"INVALID_ARGUMENT", "PERMISSION_DENIED", "UNIMPLEMENTED",
                                                              "UNAVAILABLE", "INTERNAL", "NOT_FOUND"});
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
