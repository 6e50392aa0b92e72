#include "rules.hpp"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "shown.hpp"
#include "wire/json_access.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

constexpr std::size_t most_members = 128;
constexpr std::size_t longest_for_a_pattern = 4096;  // std::regex needs stack for each character

/// These keywords do not affect conformance.
constexpr std::array notes{"$schema", "title", "description", "default", "definitions", "examples"};

unsigned bit(JsonKind kind) {
    return 1U << static_cast<unsigned>(kind);
}

unsigned kinds_of(const std::string& type) {
    if (type == "integer") return bit(JsonKind::integer);
    if (type == "number") return bit(JsonKind::integer) | bit(JsonKind::number);
    if (type == "string") return bit(JsonKind::text);
    if (type == "boolean") return bit(JsonKind::boolean);
    if (type == "object") return bit(JsonKind::object);
    if (type == "array") return bit(JsonKind::list);
    if (type == "null") return bit(JsonKind::null);
    throw std::logic_error("A schema has the type " + type + ".");
}

std::vector<std::unique_ptr<const Rules>> parts_of(const json& schemas) {
    std::vector<std::unique_ptr<const Rules>> parts;
    for (const json& schema : schemas) parts.push_back(std::make_unique<const Rules>(schema));
    return parts;
}

template <class Value>
bool are_equal(const Value& value, const json& choice) {
    const JsonKind kind = kind_of(value);
    if (choice.is_string()) return kind == JsonKind::text && text_of(value) == choice.get_ref<const std::string&>();
    if (choice.is_number())
        return (kind == JsonKind::integer || kind == JsonKind::number) && number_of(value) == choice.get<double>();
    return as_json(value) == choice;
}

}  // namespace

Rules::Rules(Rules&&) noexcept = default;
Rules::~Rules() = default;

// --- reading a schema ------------------------------------------------------------------------------------------------

Rules::Rules(const json& schema) {
    for (const auto& [keyword, value] : schema.items()) {
        if (keyword.starts_with("x-") || std::ranges::find(notes, keyword) != notes.end()) continue;
        if (keyword == "type")
            read_type(value);
        else if (keyword == "enum")
            choices_.assign(value.begin(), value.end());
        else if (keyword == "const")
            choices_ = {value};
        else if (keyword == "pattern")
            pattern_ = std::make_unique<const std::regex>(value.get<std::string>());
        else if (keyword == "required" || keyword == "properties")
            continue;  // together, below
        else if (!read_bound(keyword, value) && !read_object_keyword(keyword, value) &&
                 !read_part_keyword(keyword, value))
            throw std::logic_error("A schema has the keyword " + keyword + ", which is unknown here.");
    }
    if (const auto at = schema.find("properties"); at != schema.end())
        for (const auto& [name, member] : at->items()) read_member(name, member);
    if (object_.members.size() > most_members) throw std::logic_error("A schema has too many properties.");
    if (const auto at = schema.find("required"); at != schema.end()) read_required(*at);
}

void Rules::read_type(const json& type) {
    kinds_ = 0;
    for (const json& name : type.is_array() ? type : json::array({type})) kinds_ |= kinds_of(name.get<std::string>());
}

void Rules::read_member(const std::string& name, const json& schema) {
    object_.members.push_back({name, std::make_unique<const Rules>(schema)});  // by name, in the order of nlohmann-json
}

void Rules::read_required(const json& names) {
    for (const json& name : names) {
        const auto member = std::ranges::find(object_.members, name.get<std::string>(), &Member::name);
        if (member == object_.members.end()) {
            object_.required_beside.push_back(name.get<std::string>());
        } else {
            member->required = true;
            ++object_.required;
        }
    }
}

bool Rules::read_bound(const std::string& keyword, const json& value) {
    const std::pair<std::string_view, double*> of_numbers[] = {
        {"minimum", &least_}, {"maximum", &most_}, {"exclusiveMinimum", &above_}, {"exclusiveMaximum", &below_}};
    const std::pair<std::string_view, std::size_t*> of_sizes[] = {
        {"minLength", &least_characters_}, {"maxLength", &most_characters_},  {"minItems", &least_items_},
        {"maxItems", &most_items_},        {"minProperties", &object_.least}, {"maxProperties", &object_.most}};
    for (const auto& [name, bound] : of_numbers)
        if (name == keyword) return *bound = value.get<double>(), true;
    for (const auto& [name, bound] : of_sizes)
        if (name == keyword) return *bound = value.get<std::size_t>(), true;
    return false;
}

bool Rules::read_object_keyword(const std::string& keyword, const json& value) {
    if (keyword == "additionalProperties") {
        object_.closed = value == false;
        if (value.is_object()) object_.others = std::make_unique<const Rules>(value);
        return true;
    }
    if (keyword != "propertyNames") return false;
    for (const auto& [rule, of_names] : value.items())
        if (rule != "enum" && rule != "maxLength")
            throw std::logic_error("Names of a schema have the rule " + rule + ".");
    object_.names = std::make_unique<const Rules>(value);
    return true;
}

bool Rules::read_part_keyword(const std::string& keyword, const json& value) {
    const std::pair<std::string_view, Part*> single[] = {{"items", &items_}, {"contains", &contained_},
                                                         {"not", &without_}, {"if", &if_},
                                                         {"then", &then_},   {"else", &else_}};
    const std::pair<std::string_view, std::vector<Part>*> several[] = {
        {"allOf", &all_of_}, {"anyOf", &any_of_}, {"oneOf", &one_of_}};
    for (const auto& [name, part] : single) {
        if (name != keyword) continue;
        if (!value.is_object()) throw std::logic_error("The keyword " + keyword + " of a schema is not a schema.");
        *part = std::make_unique<const Rules>(value);
        return true;
    }
    for (const auto& [name, parts] : several)
        if (name == keyword) return *parts = parts_of(value), true;
    return false;
}

// --- checking --------------------------------------------------------------------------------------------------------

bool Rules::conform(const json& document) const {
    return hold_for(document);
}

bool Rules::conform(const AnswerValue& document) const {
    return hold_for(document);
}

template <class Value>
bool Rules::hold_for(const Value& value) const {
    const JsonKind kind = kind_of(value);
    if ((kinds_ & bit(kind)) == 0 || (!choices_.empty() && !is_choice(value))) return false;
    switch (kind) {
        case JsonKind::integer:
        case JsonKind::number:
            if (!number_conforms(number_of(value))) return false;
            break;
        case JsonKind::text:
            if (!text_conforms(text_of(value))) return false;
            break;
        case JsonKind::list:
            if (!list_conforms(value)) return false;
            break;
        case JsonKind::object:
            if (!object_conforms(value)) return false;
            break;
        default:
            break;
    }
    return parts_conform(value);
}

template <class Value>
bool Rules::is_choice(const Value& value) const {
    return std::ranges::any_of(choices_, [&](const json& choice) { return are_equal(value, choice); });
}

bool Rules::name_conforms(std::string_view name) const {
    return text_conforms(name) && (choices_.empty() || std::ranges::any_of(choices_, [&](const json& choice) {
                                       return choice.get_ref<const std::string&>() == name;
                                   }));
}

bool Rules::number_conforms(double number) const {
    return number >= least_ && number <= most_ && (number > above_ || std::isinf(above_)) &&
           (number < below_ || std::isinf(below_));
}

bool Rules::text_conforms(std::string_view text) const {
    if (least_characters_ > 0 && text.starts_with('\0')) return false;
    // A character has at least one byte, and most texts are far from their bounds.
    if (least_characters_ > 0 || text.size() > most_characters_) {
        const std::size_t length = characters(text);
        if (length < least_characters_ || length > most_characters_) return false;
    }
    return !pattern_ || (text.size() <= longest_for_a_pattern &&
                         std::regex_search(text.data(), text.data() + text.size(), *pattern_));
}

template <class Value>
bool Rules::list_conforms(const Value& list) const {
    const std::size_t size = size_of(list);
    if (size < least_items_ || size > most_items_) return false;
    if (contained_ && all_elements(list, [&](const auto& element) { return !contained_->hold_for(element); }))
        return false;
    return !items_ || all_elements(list, [&](const auto& element) { return items_->hold_for(element); });
}

/// `after` is the place after the last match: names mostly arrive in the order of the members.
const Rules::Member* Rules::ObjectRules::find(std::string_view name, std::size_t& after) const {
    auto from = members.begin();
    if (after > 0 && members[after - 1].name < name) from += static_cast<std::ptrdiff_t>(after);
    if (from == members.end() || from->name != name)
        from = std::lower_bound(from, members.end(), name,
                                [](const Member& member, std::string_view other) { return member.name < other; });
    if (from == members.end() || from->name != name) return nullptr;
    after = static_cast<std::size_t>(from - members.begin()) + 1;
    return &*from;
}

template <class Value>
bool Rules::object_conforms(const Value& object) const {
    const std::size_t size = size_of(object);
    if (size < object_.least || size > object_.most) return false;
    std::size_t after = 0, required = 0;
    std::bitset<most_members> seen;
    const bool conform = all_members(object, [&](std::string_view name, const auto& value) {
        if (object_.names && !object_.names->name_conforms(name)) return false;
        const Member* member = object_.find(name, after);
        if (!member) return !object_.closed && (!object_.others || object_.others->hold_for(value));
        if (seen.test(after - 1)) return false;  // twice
        seen.set(after - 1);
        required += member->required;
        return member->rules->hold_for(value);
    });
    return conform && required == object_.required &&
           std::ranges::all_of(object_.required_beside,
                               [&](const std::string& name) { return bool(member_of(object, name)); });
}

template <class Value>
bool Rules::parts_conform(const Value& value) const {
    const auto conforms = [&](const Part& part) { return part->hold_for(value); };
    if (without_ && without_->hold_for(value)) return false;
    if (!std::ranges::all_of(all_of_, conforms)) return false;
    if (!any_of_.empty() && std::ranges::none_of(any_of_, conforms)) return false;
    if (!one_of_.empty() && std::ranges::count_if(one_of_, conforms) != 1) return false;
    if (!if_) return true;
    const Part& part = if_->hold_for(value) ? then_ : else_;
    return !part || part->hold_for(value);
}

}  // namespace contactd::proto
