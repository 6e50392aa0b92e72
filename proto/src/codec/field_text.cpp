#include "field_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "codec_parts.hpp"
#include "field_presence.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

void append_text(std::string& out, std::string_view value) {
    const bool is_plain =
        std::ranges::all_of(value, [](unsigned char c) { return c >= 0x20 && c < 0x7f && c != '"' && c != '\\'; });
    if (!is_plain) {
        out += dump(json(std::string(value)));
        return;
    }
    out += '"';
    out += value;
    out += '"';
}

void append_finite(std::string& text, double number, const MemberPath& path) {
    if (!std::isfinite(number)) finite(number, path.text().c_str());  // throws
    append_number(text, number);
}

/// Returns whether anything was appended, like append_any.
bool append_tuple(std::string& text, const FieldType& type, const void* owner, const MemberPath& path) {
    const std::size_t before = text.size();
    bool any = false;
    text += '[';
    for (const Field& field : type.fields) {
        const void* value = field.find(owner);
        any = any || value != nullptr;
        if (text.back() != '[') text += ',';
        if (value == nullptr)
            text += "null";
        else
            append_finite(text, *static_cast<const double*>(value), path);
    }
    text += ']';
    if (!any) text.resize(before);
    return any;
}

bool append_any(std::string& text, const FieldType& type, const void* value, const MemberPath& path) {
    const FieldHook* hook = hook_of(type);
    if (hook != nullptr && hook->write != nullptr) {
        const json written = hook->write(value, path, {});
        if (!written.is_discarded()) text += dump(written);
        return !written.is_discarded();
    }
    switch (type.kind) {
        case FieldKind::number:
            append_finite(text, *static_cast<const double*>(value), path);
            return true;
        case FieldKind::integer:
            text += std::to_string(type.integer(value));
            return true;
        case FieldKind::flag:
            text += type.integer(value) != 0 ? "true" : "false";
            return true;
        case FieldKind::text:
            append_text(text, *static_cast<const std::string*>(value));
            return true;
        case FieldKind::keyword:
            append_text(text, type.keywords[static_cast<std::size_t>(type.integer(value))]);
            return true;
        case FieldKind::list:
            text += '[';
            for (std::size_t i = 0; i < type.size(value); ++i) {
                if (i > 0) text += ',';
                append_any(text, type.element(), type.at(value, i), MemberPath(path, i));
            }
            text += ']';
            return true;
        case FieldKind::object:
            if (type.is_tuple) return append_tuple(text, type, value, path);
            text += '{';
            append_members(text, type, value, path);
            text += '}';
            return true;
        case FieldKind::custom:
            break;
    }
    throw Error("The field " + path.text() + " cannot be sent.");
}

}  // namespace

void append_number(std::string& text, double number) {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, number).ptr;
    text.append(digits, end);
    if (std::all_of(digits, end, [](char c) { return c == '-' || (c >= '0' && c <= '9'); })) text += ".0";
}

void append_name(std::string& text, std::string_view name) {
    if (text.back() != '{') text += ',';
    text += '"';
    text += name;
    text += "\":";
}

void append_members(std::string& text, const FieldType& type, const void* owner, const MemberPath& path) {
    for (const Field& field : type.fields) {
        if (is_left_to_the_message(field.type())) continue;
        const void* value = field.find(owner);
        if (value == nullptr ? !field.present_by_default : is_none(field, value)) continue;
        const std::size_t before = text.size();
        append_name(text, field.name);
        const std::size_t begin = text.size();
        if (value == nullptr) {
            text += "null";
            continue;
        }
        const bool written = append_any(text, field.type(), value, MemberPath(path, field.name));
        const bool says_nothing = !field.clear && !field.required && std::string_view(text).substr(begin) == "{}";
        if (!written || says_nothing) text.resize(before);
    }
}

void append_answer(std::string& text, const FieldType& type, const void* value, const MemberPath& path) {
    append_any(text, type, value, path);
}

}  // namespace contactd::proto
