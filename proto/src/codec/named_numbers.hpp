// Structs of numbers, by the names that these have on the wire.
#pragma once

#include <array>
#include <utility>

#include <nlohmann/json.hpp>

#include "codec_parts.hpp"

namespace contactd::proto {

/// Names, and where the numbers are: in something that is read, or written.
template <class Number, std::size_t n>
using NamedNumbers = std::array<std::pair<const char*, Number*>, n>;

template <class Number, class... Numbers>
auto named(std::pair<const char*, Number*> first, Numbers... others) {
    return NamedNumbers<Number, 1 + sizeof...(others)>{first, others...};
}

template <class Number, std::size_t n>
nlohmann::json encode_numbers(const NamedNumbers<Number, n>& numbers) {
    nlohmann::json result = nlohmann::json::object();
    for (const auto& [name, number] : numbers) result[name] = finite(*number, name);
    return result;
}

/// Those that are not there stay as they are.
template <std::size_t n>
void decode_numbers(const nlohmann::json& source, const NamedNumbers<double, n>& numbers) {
    for (const auto& [name, number] : numbers)
        if (const auto found = source.find(name); found != source.end()) *number = found->template get<double>();
}

}  // namespace contactd::proto
