#include "references.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>

namespace contactd::proto {
namespace {

using nlohmann::json;

struct Reference {
    std::string document;  ///< name of the file
    std::string pointer;   ///< JSON pointer within it; empty for the whole file
};

Reference parsed(const std::string& text) {
    constexpr std::string_view suffix = ".json";
    const std::size_t hash = std::min(text.find('#'), text.size());
    const std::string file = text.substr(0, hash);
    if (!file.ends_with(suffix)) throw std::logic_error("A schema refers to " + text + ".");
    return {file.substr(0, file.size() - suffix.size()), hash == text.size() ? "" : text.substr(hash + 1)};
}

/// Returns the place of a part in the OpenRPC document: definitions have their own names.
std::string path_of(const Reference& reference) {
    const std::string_view definitions = "/definitions/";
    if (reference.document != "definitions") return reference.document + reference.pointer;
    return reference.pointer.substr(definitions.size());
}

/// These annotations control generated code and are irrelevant to readers of messages.
constexpr std::array notes_of_sources{"x-arrays-of", "x-cpp",         "x-cpp-at",    "x-cpp-items", "x-cpp-list",
                                      "x-cpp-none",  "x-cpp-only",    "x-cpp-owner", "x-derived",   "x-fmu",
                                      "x-history",   "x-label",       "x-only-with", "x-parity",    "x-partial",
                                      "x-python",    "x-python-class"};

}  // namespace

json without_file_notes(json document) {
    for (const char* note : {"$schema", "x-order", "x-summary", "x-errors", "x-largest"}) document.erase(note);
    return document;
}

json inlined(const json& schema, const Documents& documents) {
    if (!schema.is_structured()) return schema;
    json result = schema;
    if (schema.is_object() && schema.contains("$ref")) {
        const Reference reference = parsed(schema["$ref"].get<std::string>());
        result = without_file_notes(documents.at(reference.document).at(json::json_pointer(reference.pointer)));
        for (const auto& beside : schema.items())
            if (beside.key() != "$ref") result[beside.key()] = beside.value();
    }
    // The target of a reference may be a reference itself.
    if (result.is_object() && result.contains("$ref")) return inlined(result, documents);
    for (json& child : result) child = inlined(child, documents);
    return result;
}

json redirected(const json& schema, const std::string& prefix) {
    if (!schema.is_structured()) return schema;
    json result = schema;
    if (schema.is_object() && schema.contains("$ref"))
        result["$ref"] = prefix + path_of(parsed(schema["$ref"].get<std::string>()));
    if (result.is_object())
        for (const char* note : notes_of_sources) result.erase(note);
    for (json& child : result) child = redirected(child, prefix);
    return result;
}

}  // namespace contactd::proto
