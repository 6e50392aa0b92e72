#include "contactd/proto/schema.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <stdexcept>
#include <utility>

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "explain.hpp"
#include "references.hpp"
#include "schema_texts.hpp"
#include "shown.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;
using valijson::adapters::NlohmannJsonAdapter;

struct CompiledSchema {
    json document;
    valijson::Schema rules;
};
using Registry = std::map<std::string, CompiledSchema, std::less<>>;

/// Schema of params that are one list of another method's.
struct ListSchema {
    std::string name;      ///< of the list
    CompiledSchema shape;  ///< of all but the members
    CompiledSchema member;
};
using ListSchemas = std::map<std::string, ListSchema, std::less<>>;

void compile(CompiledSchema& entry) {
    valijson::SchemaParser(valijson::SchemaParser::kDraft7)
        .populateSchema(NlohmannJsonAdapter(entry.document), entry.rules);
}

Registry compile_all() {
    Documents documents;
    for (const SchemaText& source : schema_texts()) documents.emplace(source.name, json::parse(source.text));
    Registry registry;
    for (const auto& [name, document] : documents) {
        CompiledSchema& entry = registry[name];
        entry.document = inlined(document, documents);
        compile(entry);
    }
    return registry;
}

void compile_list(const json& document, ListSchema& entry) {
    entry.name = document.at("properties").begin().key();
    entry.shape.document = document;
    json& items = entry.shape.document["properties"][entry.name]["items"];
    entry.member.document = std::exchange(items, json::object());
    compile(entry.shape);
    compile(entry.member);
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
            if (name.ends_with("_many.params")) compile_list(schema.document, lists[name]);
        return lists;
    }();
    return schemas.at(method + ".params");
}

/// By the places that the schemas of their parameters give them.
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

bool conforms(const CompiledSchema& schema, const json& document, valijson::ValidationResults* results) {
    valijson::Validator validator(valijson::Validator::kStrongTypes);
    return validator.validate(schema.rules, NlohmannJsonAdapter(document), results);
}

/// valijson's own words, for what `explain` has none for.
std::vector<Violation> plain_violations(const CompiledSchema& schema, const json& document) {
    valijson::ValidationResults results;
    conforms(schema, document, &results);
    std::vector<Violation> violations;
    for (const auto& error : results) {
        std::string path;
        for (std::size_t i = 1; i < error.context.size(); ++i) path += error.context[i];
        violations.push_back({path, error.description});
        if (violations.size() == max_violations) break;
    }
    if (violations.empty()) violations.push_back({"", "does not conform to its schema"});
    return violations;
}

std::vector<Violation> violations(const CompiledSchema& rules, const json& document) {
    // Without a place for results valijson stops at the first violation, however many a hostile document has.
    if (conforms(rules, document, nullptr)) return {};
    std::vector<Violation> found = explain(rules.document, document);
    return found.empty() ? plain_violations(rules, document) : found;
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

std::vector<Violation> violations_against(const json& schema, const json& document) {
    CompiledSchema rules;
    rules.document = schema;
    compile(rules);
    return violations(rules, document);
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
    if (proto::conforms(schema.shape, params, nullptr)) members_ = &params[schema.name];
}

bool ListCheck::member_conforms(std::size_t index) const {
    return proto::conforms(list_schema(method_).member, (*members_)[index], nullptr);
}

}  // namespace contactd::proto
