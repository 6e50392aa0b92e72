// Writes structs by their lists of fields as JSON text, without an intermediate document. The text equals that of
// write_answer's document.
#pragma once

#include <string>
#include <string_view>

#include "contactd/proto/field_codec.hpp"

namespace contactd::proto {

/// Appends the shortest text that reads as this number, with a fraction or an exponent.
void append_number(std::string& text, double number);

/// Appends the name of another member of the object at the end of `text`.
void append_name(std::string& text, std::string_view name);

/// Appends a value. Throws Error for a number that is not finite.
void append_answer(std::string& text, const FieldType& type, const void* value, const MemberPath& path);
/// Appends the members of a struct to the object at the end of `text`, which stays open for others.
void append_members(std::string& text, const FieldType& type, const void* owner, const MemberPath& path);

template <class T>
void append_answer(std::string& text, const T& value, const MemberPath& path) {
    append_answer(text, type_of<T>(), &value, path);
}
template <class T>
void append_members(std::string& text, const T& owner, const MemberPath& path) {
    append_members(text, type_of<T>(), &owner, path);
}

}  // namespace contactd::proto
