#include "expected.hpp"

#include <algorithm>
#include <cmath>
#include <regex>
#include <vector>

#include "contactd/proto/message.hpp"
#include "shown.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

bool is_of(const std::string& type, const json& value) {
    if (type == "integer") return value.is_number_integer();
    if (type == "number") return value.is_number();
    if (type == "string") return value.is_string();
    if (type == "boolean") return value.is_boolean();
    if (type == "object") return value.is_object();
    if (type == "array") return value.is_array();
    return value.is_null();
}

std::vector<std::string> types_of(const json& schema) {
    const auto at = schema.find("type");
    if (at == schema.end()) return {};
    if (at->is_string()) return {at->get<std::string>()};
    return at->get<std::vector<std::string>>();
}

struct Bounds {
    std::optional<double> minimum, maximum;
    bool above = false, below = false;  // exclusive
};

Bounds bounds_of(const json& schema) {
    Bounds bounds;
    const auto read = [&](const char* inclusive, const char* exclusive, std::optional<double>& bound, bool& excluded) {
        excluded = schema.contains(exclusive);
        if (excluded)
            bound = schema[exclusive].get<double>();
        else if (schema.contains(inclusive))
            bound = schema[inclusive].get<double>();
    };
    read("minimum", "exclusiveMinimum", bounds.minimum, bounds.above);
    read("maximum", "exclusiveMaximum", bounds.maximum, bounds.below);
    return bounds;
}

std::string number(double value) {
    constexpr double largest = 9e18;  // largest whole number printed as an integer
    return std::abs(value) <= largest && value == std::trunc(value) ? dump(static_cast<long long>(value)) : dump(value);
}

std::string expected_integer(const json& schema) {
    const Bounds bounds = bounds_of(schema);
    std::string text = "an integer";
    if (bounds.minimum) text += " from " + number(*bounds.minimum);
    if (bounds.maximum) text += " to " + number(*bounds.maximum);
    return text + ", written without fraction or exponent";
}

std::string interval(const Bounds& bounds) {
    return std::string(bounds.above ? "(" : "[") + number(*bounds.minimum) + ", " + number(*bounds.maximum) +
           (bounds.below ? ")" : "]");
}

std::string expected_of(const std::string& type, const json& schema) {
    if (type == "integer") return expected_integer(schema);
    if (type == "number") return "a number";
    if (type == "string") return "a text";
    if (type == "boolean") return "true or false";
    if (type == "null") return "null";
    if (type == "array") {
        if (!schema.contains("minItems") || schema["minItems"] != schema.value("maxItems", json())) return "a list";
        return "a list of " + dump(schema["minItems"]) + " values";
    }
    if (!schema.contains("properties") || schema["properties"].empty()) return "an object";
    return "an object with " + listed(names_of(schema["properties"]));
}

}  // namespace

bool has_type(const json& schema, const json& value) {
    const std::vector<std::string> types = types_of(schema);
    return types.empty() ||
           std::any_of(types.begin(), types.end(), [&](const std::string& type) { return is_of(type, value); });
}

bool is_choice(const json& schema, const json& value) {
    if (schema.contains("const")) return value == schema["const"];
    if (!schema.contains("enum")) return true;
    const json& choices = schema["enum"];
    return std::find(choices.begin(), choices.end(), value) != choices.end();
}

std::optional<std::string> broken_bound(const json& schema, double value) {
    const Bounds bounds = bounds_of(schema);
    const bool low = bounds.minimum && (bounds.above ? value <= *bounds.minimum : value < *bounds.minimum);
    const bool high = bounds.maximum && (bounds.below ? value >= *bounds.maximum : value > *bounds.maximum);
    if (!low && !high) return std::nullopt;
    if (low && bounds.above && *bounds.minimum == 0) return "be positive";
    const bool integer = schema.value("type", json()) == "integer";
    if (!integer && bounds.minimum && bounds.maximum) return "lie in " + interval(bounds);
    if (low) return (bounds.above ? "be above " : "be at least ") + number(*bounds.minimum);
    return (bounds.below ? "be below " : "be at most ") + number(*bounds.maximum);
}

bool breaks_pattern(const json& schema, const std::string& value) {
    constexpr std::size_t longest = 4096;  // std::regex needs stack for each character
    if (!schema.contains("pattern")) return false;
    return value.size() > longest || !std::regex_search(value, std::regex(schema["pattern"].get<std::string>()));
}

std::string expected(const json& schema) {
    if (schema.contains("title")) return schema["title"].get<std::string>();
    if (schema.contains("const")) return shown(schema["const"]);
    if (schema.contains("enum")) {
        std::vector<std::string> choices;
        for (const json& choice : schema["enum"]) choices.push_back(shown(choice));
        return (choices.size() == 1 ? "" : "one of ") + listed(choices);
    }
    std::string text;
    for (const std::string& type : types_of(schema)) text += (text.empty() ? "" : " or ") + expected_of(type, schema);
    return text.empty() ? "another value" : text;
}

std::vector<std::string> names_of(const json& object) {
    std::vector<std::string> names;
    for (const auto& member : object.items()) names.push_back(member.key());
    return names;
}

}  // namespace contactd::proto
