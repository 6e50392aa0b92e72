// Determines which fields a message omits.
#pragma once

#include <string>

#include "contactd/proto/field_codec.hpp"

namespace contactd::proto {

inline bool is_left_to_the_message(const FieldType& type) {
    const FieldHook* hook = hook_of(type);
    return hook != nullptr && hook->write == nullptr && hook->read == nullptr;
}

/// Returns whether the value of a present field means that it is absent.
inline bool is_none(const Field& field, const void* value) {
    const FieldType& type = field.type();
    if (type.kind == FieldKind::number) return *static_cast<const double*>(value) == field.none;
    if (field.present_by_default || field.required) return false;
    return (type.kind == FieldKind::list && type.size(value) == 0) ||
           (type.kind == FieldKind::text && static_cast<const std::string*>(value)->empty());
}

}  // namespace contactd::proto
