#include "contactd/proto/field_codec.hpp"

#include <algorithm>
#include <utility>

#include "codec_parts.hpp"
#include "field_presence.hpp"
#include "wire/json_access.hpp"

namespace contactd::proto {

using nlohmann::json;

namespace {

json write_number(double number, const MemberPath& path) {
    return std::isfinite(number) ? number : finite_field(number, path.text().c_str());
}

json write_list(const FieldType& type, const void* list, const MemberPath& path, const Writing& with) {
    json result = json::array();
    for (std::size_t i = 0; i < type.size(list); ++i)
        result.push_back(write_fields(type.element(), type.at(list, i), MemberPath(path, i), with));
    return result;
}

/// Returns a discarded value if none of the values is present.
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

std::int64_t value_of_keyword(std::string_view keyword, const FieldType& type) {
    const auto at = std::ranges::find(type.keywords, keyword);
    if (at == type.keywords.end()) throw Error("The word \"" + std::string(keyword) + "\" is unknown.");
    return at - type.keywords.begin();
}

/// Calls visit(field, value) for each field that a message contains.
template <class Visit>
void each_given_field(const json& source, const FieldType& type, const Visit& visit) {
    for (const Field& field : type.fields)
        if (const auto given = source.find(field.name); given != source.end()) visit(field, *given);
}
/// Names mostly arrive in the order of the fields, so each search starts after the last match.
template <class Visit>
void each_given_field(const AnswerValue& source, const FieldType& type, const Visit& visit) {
    std::size_t after = 0;
    for (const AnswerValue name : source) {
        const auto begin = type.fields.begin(), middle = begin + static_cast<std::ptrdiff_t>(after);
        auto field = std::find_if(middle, type.fields.end(), [&](const Field& one) { return one.name == name.text(); });
        if (field == type.fields.end())
            field = std::find_if(begin, middle, [&](const Field& one) { return one.name == name.text(); });
        if (field == middle && (middle == type.fields.end() || field->name != name.text())) continue;
        after = static_cast<std::size_t>(field - begin) + 1;
        visit(*field, name.value_of_name());
    }
}

template <class Source>
void read_value_of(const Source& source, const FieldType& type, void* value, const MemberPath& path,
                   const Reading& with);

template <class Source>
void read_tuple(const Source& source, const FieldType& type, void* owner) {
    auto field = type.fields.begin();
    for (const auto& element : source) {
        if (field == type.fields.end()) return;
        if (element.is_null())
            field->clear(owner);
        else
            *static_cast<double*>(field->make(owner)) = number_of(element);
        ++field;
    }
}

template <class Source>
void read_list(const Source& source, const FieldType& type, void* list, const MemberPath& path, const Reading& with) {
    type.empty(list);
    std::size_t place = 0;
    for (const auto& element : source)
        read_value_of(element, type.element(), type.add(list), MemberPath(path, place++), with);
}

template <class Source>
void read_members(const Source& source, const FieldType& type, void* owner, const MemberPath& path,
                  const Reading& with) {
    each_given_field(source, type, [&](const Field& field, const auto& given) {
        if (is_left_to_the_message(field.type())) return;
        if (given.is_null() && field.clear)
            field.clear(owner);
        else
            read_value_of(given, field.type(), field.make(owner), MemberPath(path, field.name), with);
    });
}

template <class Source>
void read_value_of(const Source& source, const FieldType& type, void* value, const MemberPath& path,
                   const Reading& with) {
    const FieldHook* hook = hook_of(type);
    if (hook != nullptr && hook->read != nullptr) return hook->read(as_json(source), value, path, with);
    switch (type.kind) {
        case FieldKind::number:
            *static_cast<double*>(value) = number_of(source);
            return;
        case FieldKind::integer:
            return type.set_integer(value, integer_of(source));
        case FieldKind::flag:
            return type.set_integer(value, flag_of(source) ? 1 : 0);
        case FieldKind::text:
            *static_cast<std::string*>(value) = text_of(source);
            return;
        case FieldKind::keyword:
            return type.set_integer(value, value_of_keyword(text_of(source), type));
        case FieldKind::list:
            return read_list(source, type, value, path, with);
        case FieldKind::object:
            return type.is_tuple ? read_tuple(source, type, value) : read_members(source, type, value, path, with);
        case FieldKind::custom:
            break;
    }
    throw Error("The field " + path.text() + " cannot be sent.");
}

}  // namespace

std::string MemberPath::text() const {
    if (above_ == nullptr) return std::string(name_);
    const std::string above = above_->text();
    if (name_.empty()) return above + "[" + std::to_string(index_) + "]";
    return above.empty() ? std::string(name_) : above + "." + std::string(name_);
}

// An empty object is omitted if its field is always present in C++ and not required on the wire.
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
    throw Error("The field " + path.text() + " cannot be sent.");
}

void read_object(const json& source, const FieldType& type, void* owner, const MemberPath& path, const Reading& with) {
    read_members(source, type, owner, path, with);
}

void read_fields(const json& source, const FieldType& type, void* value, const MemberPath& path, const Reading& with) {
    read_value_of(source, type, value, path, with);
}

void read_fields(const AnswerValue& source, const FieldType& type, void* value, const MemberPath& path,
                 const Reading& with) {
    read_value_of(source, type, value, path, with);
}

}  // namespace contactd::proto
