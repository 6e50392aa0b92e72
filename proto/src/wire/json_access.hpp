// Gives rules and readers the same access to a nlohmann::json and to a value of an AnswerText.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include <nlohmann/json.hpp>

#include "contactd/proto/answer_text.hpp"

namespace contactd::proto {

inline JsonKind kind_of(const nlohmann::json& value) {
    switch (value.type()) {
        case nlohmann::json::value_t::object:
            return JsonKind::object;
        case nlohmann::json::value_t::array:
            return JsonKind::list;
        case nlohmann::json::value_t::string:
            return JsonKind::text;
        case nlohmann::json::value_t::boolean:
            return JsonKind::boolean;
        case nlohmann::json::value_t::number_integer:
        case nlohmann::json::value_t::number_unsigned:
            return JsonKind::integer;
        case nlohmann::json::value_t::number_float:
            return JsonKind::number;
        default:
            return JsonKind::null;
    }
}
inline JsonKind kind_of(const AnswerValue& value) {
    return value.kind();
}

inline double number_of(const nlohmann::json& value) {
    return value.get<double>();
}
inline double number_of(const AnswerValue& value) {
    return value.number();
}

inline std::int64_t integer_of(const nlohmann::json& value) {
    return value.get<std::int64_t>();
}
inline std::int64_t integer_of(const AnswerValue& value) {
    return value.integer();
}

inline bool flag_of(const nlohmann::json& value) {
    return value.get<bool>();
}
inline bool flag_of(const AnswerValue& value) {
    return value.flag();
}

inline std::string_view text_of(const nlohmann::json& value) {
    return value.get_ref<const std::string&>();
}
inline std::string_view text_of(const AnswerValue& value) {
    return value.text();
}

inline std::size_t size_of(const nlohmann::json& value) {
    return value.size();
}
inline std::size_t size_of(const AnswerValue& value) {
    return value.size();
}

/// Returns a pointer to the member, or an optional with it; both are false if there is none.
inline const nlohmann::json* member_of(const nlohmann::json& object, std::string_view name) {
    const auto at = object.find(name);
    return at == object.end() ? nullptr : &*at;
}
inline std::optional<AnswerValue> member_of(const AnswerValue& object, std::string_view name) {
    return object.find(name);
}

inline const nlohmann::json& as_json(const nlohmann::json& value) {
    return value;
}
inline nlohmann::json as_json(const AnswerValue& value) {
    return value.json();
}

/// Calls visit(name, member) until one call returns false; returns whether none did.
template <class Visit>
bool all_members(const nlohmann::json& object, const Visit& visit) {
    for (auto at = object.begin(); at != object.end(); ++at)
        if (!visit(std::string_view(at.key()), *at)) return false;
    return true;
}
template <class Visit>
bool all_members(const AnswerValue& object, const Visit& visit) {
    for (const AnswerValue& name : object)
        if (!visit(name.text(), name.value_of_name())) return false;
    return true;
}

/// Calls visit(element) until one call returns false; returns whether none did.
template <class Value, class Visit>
bool all_elements(const Value& list, const Visit& visit) {
    for (const auto& element : list)
        if (!visit(element)) return false;
    return true;
}

}  // namespace contactd::proto
