#include "contactd/proto/schema.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <stdexcept>
#include <utility>

#include "explain.hpp"
#include "references.hpp"
#include "rules.hpp"
#include "schema_texts.hpp"
#include "shown.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

struct CompiledSchema {
    json document;
    Rules rules{document};
};
using Registry = std::map<std::string, CompiledSchema, std::less<>>;

/// Returns the schema of params that consist of one list of another method's params.
struct ListSchema {
    std::string name;      ///< of the list
    CompiledSchema shape;  ///< checks everything except the members
    CompiledSchema member;
};
using ListSchemas = std::map<std::string, ListSchema, std::less<>>;

Registry compile_all() {
    Documents documents;
    for (const SchemaText& source : schema_texts()) documents.emplace(source.name, json::parse(source.text));
    Registry registry;
    for (const auto& [name, document] : documents) registry.emplace(name, CompiledSchema{inlined(document, documents)});
    return registry;
}

ListSchema list_of(json document) {
    std::string name = document.at("properties").begin().key();
    json member = std::exchange(document["properties"][name]["items"], json::object());
    return {std::move(name), {std::move(document)}, {std::move(member)}};
}

const Registry& registry() {
    static const Registry schemas = compile_all();
    return schemas;
}

const CompiledSchema& compiled(std::string_view name) {
    const auto at = registry().find(name);
    if (at == registry().end()) throw std::out_of_range("There is no schema " + std::string(name) + ".");
    return at->second;
}

const ListSchema& list_schema(const std::string& method) {
    static const ListSchemas schemas = [] {
        ListSchemas lists;
        for (const auto& [name, schema] : registry())
            if (name.ends_with("_many.params")) lists.emplace(name, list_of(schema.document));
        return lists;
    }();
    return schemas.at(method + ".params");
}

/// Orders methods by the places in the schemas of their parameters.
std::vector<std::string> methods_in_order() {
    constexpr std::string_view suffix = ".params";
    std::map<int, std::string> methods;
    for (const auto& [name, entry] : registry())
        if (name.ends_with(suffix))
            methods.emplace(entry.document.at("x-order").get<int>(), name.substr(0, name.size() - suffix.size()));
    std::vector<std::string> names;
    for (const auto& [place, name] : methods) names.push_back(name);
    return names;
}

std::vector<Violation> violations(const CompiledSchema& schema, const json& document) {
    if (schema.rules.conform(document)) return {};
    std::vector<Violation> found = explain(schema.document, document);
    if (found.empty()) found.push_back({"", "does not conform to its schema"});
    return found;
}

}  // namespace

const std::vector<std::string>& method_names() {
    static const std::vector<std::string> names = methods_in_order();
    return names;
}

const json& schema(std::string_view name) {
    return compiled(name).document;
}

std::vector<Violation> violations_of(std::string_view schema_name, const json& document) {
    return violations(compiled(schema_name), document);
}

std::vector<Violation> violations_of(std::string_view schema_name, const AnswerValue& document) {
    const CompiledSchema& schema = compiled(schema_name);
    if (schema.rules.conform(document)) return {};
    std::vector<Violation> found = violations(schema, document.json());
    if (found.empty()) found.push_back({"", "contains an object with a duplicate field"});
    return found;
}

std::vector<Violation> violations_against(const json& schema, const json& document) {
    return violations(CompiledSchema{schema}, document);
}

void check_params(const std::string& method, const json& params) {
    const auto& known = method_names();
    if (std::find(known.begin(), known.end(), method) == known.end())
        throw StatusError(StatusCode::unimplemented, reason::unknown_method,
                          "There is no method \"" + shortened(method) + "\"; there are " + listed(known) + ".");
    std::vector<Violation> violations = violations_of(method + ".params", params);
    if (violations.empty()) return;
    const bool about_arrays = std::all_of(violations.begin(), violations.end(), [](const Violation& violation) {
        return violation.field.find(".$array") != std::string::npos;
    });
    std::string message;
    for (const Violation& violation : violations)
        message += (message.empty() ? "" : "; ") + violation.field + " " + violation.description;
    throw StatusError(Status{StatusCode::invalid_argument, std::move(message),
                             std::string(about_arrays ? reason::array_invalid : reason::field_invalid),
                             std::move(violations), 0});
}

ListCheck::ListCheck(const std::string& method, const json& params) : method_(method) {
    const ListSchema& schema = list_schema(method_);
    if (schema.shape.rules.conform(params)) members_ = &params[schema.name];
}

bool ListCheck::member_conforms(std::size_t index) const {
    return list_schema(method_).member.rules.conform((*members_)[index]);
}

}  // namespace contactd::proto
