// Changes the types of some fields in lists of fields.
#pragma once

#include <initializer_list>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "contactd/fields.hpp"

namespace contactd::c {

using TypeOf = const FieldType& (*)();

/// Returns the fields of T, with other types for the named ones, whose form on the wire differs.
template <class T>
std::vector<Field> fields_with(std::initializer_list<std::pair<std::string_view, TypeOf>> others) {
    const std::span<const Field> all = type_of<T>().fields;
    std::vector<Field> list(all.begin(), all.end());
    for (Field& field : list)
        for (const auto& [name, type] : others)
            if (field.name == name) field.type = type;
    return list;
}

}  // namespace contactd::c
