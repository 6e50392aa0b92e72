#include "contactd/proto/contact_file.hpp"

#include <type_traits>
#include <utility>
#include <variant>

namespace contactd::proto {

using nlohmann::json;

namespace {

json encode_value(const ContactValue& value) {
    return std::visit(
        [](const auto& given) -> json {
            if constexpr (std::is_same_v<std::decay_t<decltype(given)>, ContactNumbers>)
                return *given;
            else
                return given;
        },
        value);
}

json encode_values(const ByName<ContactValue>& values) {
    json encoded = json::object();
    for (const auto& [name, value] : values) encoded[name] = encode_value(value);
    return encoded;
}

std::size_t numbers_in(const ByName<ContactValue>& values) {
    std::size_t count = values.size();
    for (const auto& [name, value] : values)
        if (const auto* list = std::get_if<ContactNumbers>(&value)) count += (*list)->size();
    return count;
}

}  // namespace

json encode_contact_case(const ContactCase& read) {
    json encoded = {{"number", read.number},
                    {"line", read.line},
                    {"module", read.module_number},
                    {"digits", read.digits},
                    {"values", encode_values(read.values)},
                    {"read", read.read},
                    {"warnings", read.warnings},
                    {"errors", read.errors}};
    if (read.reid) encoded["reid"] = *read.reid;
    if (read.cpid) encoded["cpid"] = *read.cpid;
    if (read.friction) encoded["friction"] = *read.friction;
    if (read.subsurface)
        for (const auto& block : *read.subsurface) encoded["subsurface"].push_back(encode_values(block));
    return encoded;
}

std::size_t numbers_of(const ContactCase& read) {
    std::size_t count = numbers_in(read.values);
    if (read.friction)
        for (const auto& set : *read.friction) count += set.size();
    if (read.subsurface)
        for (const auto& block : *read.subsurface) count += numbers_in(block);
    return count;
}

json encode_contact_slices(const ContactSlices& read) {
    json slices = json::array();
    for (const auto& [u, file, features] : read.slices)
        slices.push_back({{"u", u}, {"file", file}, {"features", features}});
    return {{"slices", std::move(slices)},
            {"is_approximated", read.is_approximated},
            {"kinks", read.kinks},
            {"accelerations", read.accelerations}};
}

}  // namespace contactd::proto
