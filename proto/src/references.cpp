#include "references.hpp"

#include <stdexcept>

namespace contactd::proto {
namespace {

using nlohmann::json;

/// The path of the definition: its name, or a place within it such as "ics/properties/order".
std::string path_in(const std::string& reference) {
    const std::string place = "definitions.json#/definitions/";
    if (!reference.starts_with(place)) throw std::logic_error("A schema refers to " + reference + ".");
    return reference.substr(place.size());
}

}  // namespace

json inlined(const json& schema, const json& definitions) {
    if (!schema.is_structured()) return schema;
    json result = schema;
    if (schema.is_object() && schema.contains("$ref")) {
        const auto reference = schema["$ref"].get<std::string>();
        result = definitions.at(json::json_pointer("/" + path_in(reference)));
        for (const auto& beside : schema.items())
            if (beside.key() != "$ref") result[beside.key()] = beside.value();
    }
    for (json& child : result) child = inlined(child, definitions);
    return result;
}

json redirected(const json& schema, const std::string& prefix) {
    if (!schema.is_structured()) return schema;
    json result = schema;
    if (schema.is_object() && schema.contains("$ref")) result["$ref"] = prefix + path_in(schema["$ref"]);
    for (json& child : result) child = redirected(child, prefix);
    return result;
}

}  // namespace contactd::proto
