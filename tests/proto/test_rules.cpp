// Compares rules made of schemas with valijson, which reads the same schemas: both accept and refuse the same
// documents.
#include <catch2/catch_test_macros.hpp>

#include <functional>
#include <random>
#include <stdexcept>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "contactd/proto/answer_text.hpp"
#include "contactd/proto/message.hpp"
#include "contactd/proto/schema.hpp"
#include "schema/rules.hpp"

using namespace contactd::proto;
using nlohmann::json;

namespace {

using Generator = std::mt19937;

class Reference {
   public:
    explicit Reference(const json& schema) : schema_(schema) {
        valijson::SchemaParser(valijson::SchemaParser::kDraft7)
            .populateSchema(valijson::adapters::NlohmannJsonAdapter(schema_), rules_);
    }
    bool conform(const json& document) const {
        valijson::Validator validator(valijson::Validator::kStrongTypes);
        return validator.validate(rules_, valijson::adapters::NlohmannJsonAdapter(document), nullptr);
    }

   private:
    json schema_;
    valijson::Schema rules_;
};

std::size_t below(Generator& generator, std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(generator);
}

/// Returns all values of a document, by their places.
std::vector<json::json_pointer> places_of(const json& document, const json::json_pointer& at) {
    std::vector<json::json_pointer> places{at};
    const auto add = [&](const json& child, const json::json_pointer& place) {
        for (json::json_pointer& found : places_of(child, place)) places.push_back(std::move(found));
    };
    if (document.is_object())
        for (const auto& [name, child] : document.items()) add(child, at / name);
    if (document.is_array())
        for (std::size_t i = 0; i < document.size(); ++i) add(document[i], at / i);
    return places;
}

/// Removes, adds, doubles or replaces one value.
json damaged(json document, Generator& generator) {
    static const json others = {nullptr,
                                true,
                                0,
                                -1,
                                1,
                                3,
                                0.5,
                                -2.5,
                                1e300,
                                "",
                                "x",
                                "full",
                                "µm",
                                json::array(),
                                json::object(),
                                {1, 2},
                                {1.5},
                                {{"a", 1}},
                                1e9,
                                "half_space",
                                std::string(70, 'a'),
                                4294967296};
    const std::vector<json::json_pointer> places = places_of(document, json::json_pointer());
    const json::json_pointer& place = places[below(generator, places.size())];
    json& value = document[place];
    switch (below(generator, 4)) {
        case 0:
            if (value.is_object() && !value.empty()) {
                auto at = value.begin();
                std::advance(at, below(generator, value.size()));
                value.erase(at);
                break;
            }
            [[fallthrough]];
        case 1:
            if (value.is_array() && !value.empty()) {
                value.push_back(value.front());
                break;
            }
            [[fallthrough]];
        case 2:
            if (value.is_object()) {
                value["another"] = others[below(generator, others.size())];
                break;
            }
            [[fallthrough]];
        default:
            value = others[below(generator, others.size())];
    }
    return document;
}

/// Checks that the rules and the reference agree on a document, read in either way.
void compare(const Rules& rules, const Reference& reference, const json& document) {
    const std::string text = dump(document);
    CAPTURE(text);
    const bool expected = reference.conform(document);
    const auto parsed = AnswerText::parsed(text);
    REQUIRE(parsed);
    if (rules.conform(document) != expected) CHECK(rules.conform(document) == expected);
    if (rules.conform(parsed->root()) != expected) CHECK(rules.conform(parsed->root()) == expected);
}

void compare_all(const std::string& name, int times) {
    CAPTURE(name);
    const json& document = schema(name);
    const Rules rules(document);
    const Reference reference(document);
    Generator generator(17);
    for (const json& example : document.value("examples", json::array())) {
        CHECK(rules.conform(example));
        for (int i = 0; i < times; ++i) {
            json other = damaged(example, generator);
            for (std::size_t more = below(generator, 3); more > 0; --more) other = damaged(other, generator);
            compare(rules, reference, other);
        }
    }
}

}  // namespace

TEST_CASE("Rules take and refuse what valijson does, of every message") {
    for (const std::string& method : method_names())
        for (const char* part : {".params", ".result"}) compare_all(method + part, 100);
}

TEST_CASE("Rules take and refuse what valijson does, keyword by keyword") {
    const json values = {nullptr,
                         true,
                         false,
                         0,
                         1,
                         2,
                         -1,
                         1.0,
                         0.5,
                         2.5,
                         1e300,
                         "",
                         "a",
                         "ab",
                         "µµ",
                         "abc",
                         {},
                         {1},
                         {1, 2},
                         {1, 2, 3},
                         {"a"},
                         {"a", 1},
                         json::object(),
                         {{"a", 1}},
                         {{"b", 1}},
                         {{"a", "x"}},
                         {{"a", 1}, {"b", 2}},
                         {{"a", 1}, {"b", 2}, {"c", 3}},
                         {{"long name", 1}},
                         {{"a", {{"a", 1}}}}};
    for (const char* text : {
             R"({"type": "integer"})",
             R"({"type": "number"})",
             R"({"type": ["string", "null"]})",
             R"({"minimum": 1})",
             R"({"maximum": 1})",
             R"({"exclusiveMinimum": 1})",
             R"({"exclusiveMaximum": 1})",
             R"({"exclusiveMinimum": 0, "exclusiveMaximum": 2})",
             R"({"minimum": 0, "maximum": 0})",
             R"({"minLength": 2})",
             R"({"maxLength": 2})",
             R"({"pattern": "^a"})",
             R"({"minItems": 2})",
             R"({"maxItems": 2})",
             R"({"items": {"type": "number"}})",
             R"({"contains": {"type": "number"}})",
             R"({"minProperties": 2})",
             R"({"maxProperties": 1})",
             R"({"required": ["a"]})",
             R"({"required": ["a", "b"], "properties": {"a": {}}})",
             R"({"properties": {"a": {"type": "number"}}})",
             R"({"properties": {"a": {}}, "additionalProperties": false})",
             R"({"properties": {"a": {}}, "additionalProperties": {"minimum": 3}})",
             R"({"propertyNames": {"enum": ["a", "b"]}})",
             R"({"propertyNames": {"maxLength": 1}})",
             R"({"enum": ["a", "b", "ab"]})",
             R"({"enum": [1, 2]})",
             R"({"const": 1})",
             R"({"const": true})",
             R"({"not": {"const": 0}})",
             R"({"allOf": [{"minimum": 0}, {"maximum": 1}]})",
             R"({"anyOf": [{"required": ["a"]}, {"required": ["b"]}]})",
             R"({"oneOf": [{"required": ["a"]}, {"required": ["b"]}]})",
             R"({"if": {"required": ["a"]}, "then": {"required": ["b"]}, "else": {"required": ["c"]}})",
             R"({"if": {"properties": {"a": {"const": 1}}}, "then": {"required": ["b"]}})",
             R"({"if": {"type": "number"}, "else": {"type": "string"}})",
         }) {
        CAPTURE(text);
        const json document = json::parse(text);
        const Rules rules(document);
        const Reference reference(document);
        for (const json& value : values) compare(rules, reference, value);
    }
}

TEST_CASE("A keyword that rules do not know is refused, not passed over") {
    CHECK_THROWS_AS(Rules(json{{"multipleOf", 2}}), std::logic_error);
    CHECK_THROWS_AS(Rules(json{{"type", "nummer"}}), std::logic_error);
    CHECK_THROWS_AS(Rules(json{{"items", json::array({{{"type", "number"}}})}}), std::logic_error);
    CHECK_THROWS_AS(Rules(json{{"propertyNames", {{"minLength", 2}}}}), std::logic_error);
    CHECK_NOTHROW(Rules(json{{"x-unit", "mm"}, {"title", "a length"}}));
}

TEST_CASE("An answer that names a field twice does not conform") {
    const auto once = AnswerText::parsed(R"({"contactd": 1, "id": "7f", "result": {}, "status":
        {"code": 0, "name": "OK", "message": ""}})");
    const auto twice = AnswerText::parsed(R"({"contactd": 1, "id": "7f", "id": "7f", "result": {}, "status":
        {"code": 0, "name": "OK", "message": ""}})");
    REQUIRE(once);
    REQUIRE(twice);
    CHECK(violations_of("reply", once->root()).empty());
    REQUIRE(violations_of("reply", twice->root()).size() == 1);
    CHECK(violations_of("reply", twice->root())[0].description == "contains an object with a duplicate field");
}
