#include "contactd/proto/field_codec.hpp"

#include <algorithm>
#include <utility>

#include "codec_parts.hpp"

namespace contactd::proto {

using nlohmann::json;

namespace {

json write_number(double number, const MemberPath& path) {
    return std::isfinite(number) ? number : finite_field(number, path.text().c_str());
}

bool is_left_to_the_message(const FieldType& type) {
    const FieldHook* hook = hook_of(type);
    return hook != nullptr && hook->write == nullptr && hook->read == nullptr;
}

bool is_empty_list(const FieldType& type, const void* value) {
    return type.kind == FieldKind::list && type.size(value) == 0;
}

/// Returns whether a field that is there says nothing all the same.
bool is_none(const Field& field, const void* value) {
    const FieldType& type = field.type();
    if (type.kind == FieldKind::number) return *static_cast<const double*>(value) == field.none;
    if (field.present_by_default || field.required) return false;
    return is_empty_list(type, value) ||
           (type.kind == FieldKind::text && static_cast<const std::string*>(value)->empty());
}

json write_list(const FieldType& type, const void* list, const MemberPath& path, const Writing& with) {
    json result = json::array();
    for (std::size_t i = 0; i < type.size(list); ++i)
        result.push_back(write_fields(type.element(), type.at(list, i), MemberPath(path, i), with));
    return result;
}

/// Discarded where none of the values is there.
json write_tuple(const FieldType& type, const void* owner, const MemberPath& path) {
    json result = json::array();
    bool any = false;
    for (const Field& field : type.fields) {
        const void* value = field.find(owner);
        any = any || value != nullptr;
        result.push_back(value == nullptr ? json() : write_number(*static_cast<const double*>(value), path));
    }
    return any ? result : json(json::value_t::discarded);
}

void read_tuple(const json& source, const FieldType& type, void* owner) {
    for (std::size_t i = 0; i < type.fields.size(); ++i) {
        const Field& field = type.fields[i];
        if (source[i].is_null())
            field.clear(owner);
        else
            *static_cast<double*>(field.make(owner)) = source[i].get<double>();
    }
}

void read_list(const json& source, const FieldType& type, void* list, const MemberPath& path, const Reading& with) {
    type.empty(list);
    for (std::size_t i = 0; i < source.size(); ++i)
        read_fields(source[i], type.element(), type.add(list), MemberPath(path, i), with);
}

std::int64_t value_of_keyword(const json& keyword, const FieldType& type) {
    const auto at = std::ranges::find(type.keywords, keyword.get_ref<const std::string&>());
    if (at == type.keywords.end()) throw Error("The word " + keyword.dump() + " is unknown.");
    return at - type.keywords.begin();
}

}  // namespace

std::string MemberPath::text() const {
    if (above_ == nullptr) return std::string(name_);
    const std::string above = above_->text();
    if (name_.empty()) return above + "[" + std::to_string(index_) + "]";
    return above.empty() ? std::string(name_) : above + "." + std::string(name_);
}

// An object that says nothing is left out where its field is always there, and required of nobody.
json write_object(const FieldType& type, const void* owner, const MemberPath& path, const Writing& with) {
    json::object_t object;
    for (const Field& field : type.fields) {
        if (is_left_to_the_message(field.type())) continue;
        const void* value = field.find(owner);
        if (value == nullptr) {
            if (field.present_by_default) object.emplace(field.name, nullptr);
            continue;
        }
        if (is_none(field, value)) continue;
        json written = write_fields(field.type(), value, MemberPath(path, field.name), with);
        const bool says_nothing = written.is_object() && written.empty() && !field.clear && !field.required;
        if (!written.is_discarded() && !says_nothing) object.emplace(field.name, std::move(written));
    }
    return object;
}

json write_fields(const FieldType& type, const void* value, const MemberPath& path, const Writing& with) {
    const FieldHook* hook = hook_of(type);
    if (hook != nullptr && hook->write != nullptr) return hook->write(value, path, with);
    switch (type.kind) {
        case FieldKind::number:
            return write_number(*static_cast<const double*>(value), path);
        case FieldKind::integer:
            return type.integer(value);
        case FieldKind::flag:
            return type.integer(value) != 0;
        case FieldKind::text:
            return *static_cast<const std::string*>(value);
        case FieldKind::keyword:
            return type.keywords[static_cast<std::size_t>(type.integer(value))];
        case FieldKind::list:
            return write_list(type, value, path, with);
        case FieldKind::object:
            return type.is_tuple ? write_tuple(type, value, path) : write_object(type, value, path, with);
        case FieldKind::custom:
            break;
    }
    throw Error("The field " + path.text() + " has no form on the wire.");
}

void read_object(const json& source, const FieldType& type, void* owner, const MemberPath& path, const Reading& with) {
    for (const Field& field : type.fields) {
        const auto given = source.find(field.name);
        if (given == source.end() || is_left_to_the_message(field.type())) continue;
        if (given->is_null() && field.clear)
            field.clear(owner);
        else
            read_fields(*given, field.type(), field.make(owner), MemberPath(path, field.name), with);
    }
}

void read_fields(const json& source, const FieldType& type, void* value, const MemberPath& path, const Reading& with) {
    const FieldHook* hook = hook_of(type);
    if (hook != nullptr && hook->read != nullptr) return hook->read(source, value, path, with);
    switch (type.kind) {
        case FieldKind::number:
            *static_cast<double*>(value) = source.get<double>();
            return;
        case FieldKind::integer:
            return type.set_integer(value, source.get<std::int64_t>());
        case FieldKind::flag:
            return type.set_integer(value, source.get<bool>() ? 1 : 0);
        case FieldKind::text:
            *static_cast<std::string*>(value) = source.get<std::string>();
            return;
        case FieldKind::keyword:
            return type.set_integer(value, value_of_keyword(source, type));
        case FieldKind::list:
            return read_list(source, type, value, path, with);
        case FieldKind::object:
            return type.is_tuple ? read_tuple(source, type, value) : read_object(source, type, value, path, with);
        case FieldKind::custom:
            break;
    }
    throw Error("The field " + path.text() + " has no form on the wire.");
}

}  // namespace contactd::proto
