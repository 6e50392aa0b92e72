// Generates the OpenRPC document from the schemas, so that the two cannot disagree. The schema of its parameters
// contains summary, order and errors of a method.
#include <algorithm>
#include <string>
#include <utility>

#include "contactd/proto/schema.hpp"
#include "references.hpp"
#include "schema_texts.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

constexpr const char* place = "#/components/schemas/";

/// Defines one error for each status code; `data` is the status of the reply (components.schemas.status).
json error(StatusCode code) {
    return {{"code", static_cast<int>(code)}, {"message", name_of(code)}};
}

/// Returns the errors of every method, and those that the schema of this one adds.
json errors_of(const json& params) {
    json errors{error(StatusCode::invalid_argument), error(StatusCode::permission_denied),
                error(StatusCode::unimplemented), error(StatusCode::unavailable), error(StatusCode::internal)};
    for (const json& name : params.at("x-errors")) errors.push_back(error(code_named(name.get<std::string>())));
    return errors;
}

json params_of(const json& schema) {
    json params = json::array();
    const json required = schema.value("required", json::array());
    const json properties = schema.value("properties", json::object());
    // By-name parameters must list the required ones first.
    for (const bool comes_first : {true, false})
        for (const auto& property : properties.items()) {
            const bool is_required = std::find(required.begin(), required.end(), property.key()) != required.end();
            if (is_required != comes_first) continue;
            params.push_back({{"name", property.key()},
                              {"description", property.value().value("description", "")},
                              {"required", is_required},
                              {"schema", redirected(property.value(), place)}});
        }
    return params;
}

json method_of(const std::string& name, const Documents& documents) {
    const json& params = documents.at(name + ".params");
    const json& result = documents.at(name + ".result");
    return {{"name", name},
            {"summary", params.at("x-summary")},
            {"paramStructure", "by-name"},
            {"params", params_of(params)},
            {"result",
             {{"name", name + ".result"},
              {"description", result["description"]},
              {"required", true},
              {"schema", {{"$ref", place + (name + ".result")}}}}},
            {"errors", errors_of(params)}};
}

json make_document() {
    Documents documents;
    for (const SchemaText& source : schema_texts()) documents.emplace(source.name, json::parse(source.text));
    json schemas = json::object();
    for (const auto& definition : documents.at("definitions")["definitions"].items())
        schemas[definition.key()] = redirected(definition.value(), place);
    for (const auto& [name, document] : documents)
        if (name != "definitions") schemas[name] = redirected(without_file_notes(document), place);
    json methods = json::array();
    for (const std::string& name : method_names()) methods.push_back(method_of(name, documents));
    return {{"openrpc", "1.3.2"},
            {"info",
             {{"title", "contactd"},
              {"version", CONTACTD_VERSION},
              {"description",
               "Elastic contact with computed influence coefficients. Requests and replies are ZeroMQ messages: one "
               "JSON envelope (components.schemas.envelope, progress, reply) and raw array frames behind it."}}},
            {"methods", std::move(methods)},
            {"components", {{"schemas", std::move(schemas)}}}};
}

}  // namespace

const json& openrpc() {
    static const json document = make_document();
    return document;
}

}  // namespace contactd::proto
