// The fields of a struct as the wire knows them: their names, bounds and units, and how to reach them.
//
// The lists are written by `./dev generate` from proto/schema, one a struct (contactd/fields/*.hpp). Codec, range
// checks, mirrored wheels and paths of the C interface walk through them, so that a new field is declared once.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "contactd/enum_words.hpp"

namespace contactd {

/// How a value stands on the wire. A value of kind `custom` has no list of fields: whoever meets one knows its type.
enum class FieldKind { number, integer, flag, text, keyword, object, list, custom };

/// Bounds of a number. A bound that is excluded may not be reached itself.
struct Bounds {
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
    bool least_excluded = false, most_excluded = false;

    bool contain(double value) const {
        return std::isfinite(value) && (least_excluded ? value > least : value >= least) &&
               (most_excluded ? value < most : value <= most);
    }
};

/// What a number becomes in the mirror image of a wheel, of which y points to the other side: `odd` turns its sign.
enum class MirrorParity { even, odd };

/// What a list says of a field beside its name and its member.
struct FieldNotes {
    Bounds bounds{};
    std::string_view unit{};
    MirrorParity parity = MirrorParity::even;
    bool required = false;
};

struct FieldType;

/// One field of a struct, whose address is `owner` in what follows.
struct Field {
    std::string_view name;
    const FieldType& (*type)();
    const void* (*find)(const void* owner);  ///< null where the field is optional and absent
    void* (*make)(void* owner);              ///< as `find`; an optional that is absent gets its default first
    void (*clear)(void* owner);              ///< makes an optional absent; null where the field is always there
    /// Whether an optional, or an entry of a list, is there by default: null or an empty list says otherwise then, and
    /// not a member that is left out.
    bool present_by_default = false;
    bool required = false;  ///< a message without it is wrong, also where it is an empty list
    Bounds bounds{};
    std::string_view unit{};
    MirrorParity parity = MirrorParity::even;
};

/// What a type of C++ is on the wire. There is one object a type, whose address is that of no other type.
struct FieldType {
    FieldKind kind = FieldKind::custom;
    std::span<const Field> fields{};                      ///< of an object
    std::span<const std::string_view> keywords{};         ///< of a keyword, by the enumerators' values
    std::int64_t (*integer)(const void* value) = {};      ///< of integers, flags and keywords
    void (*set_integer)(void* value, std::int64_t) = {};  ///< of the same
    const FieldType& (*element)() = {};                   ///< of a list, with what follows
    std::size_t (*size)(const void* list) = {};
    const void* (*at)(const void* list, std::size_t index) = {};  ///< to be written to where the list is
    void* (*add)(void* list) = {};                                ///< a default at its end
    void (*empty)(void* list) = {};
};

/// The type of a member's value, which may stand in an optional.
template <class T>
struct FieldValue {
    using type = T;
};
template <class T>
struct FieldValue<std::optional<T>> {
    using type = T;
};

namespace fields {

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

template <class T>
inline constexpr bool is_list = false;
template <class T>
inline constexpr bool is_list<std::vector<T>> = true;

template <auto member>
struct member_of;
template <class Owner_, class Value_, Value_ Owner_::* member>
struct member_of<member> {
    using Owner = Owner_;
    using Value = Value_;
};

}  // namespace fields

template <class T>
const FieldType& type_of();

/// The type of values that have no list of fields.
template <class T>
const FieldType& custom_type() {
    static const FieldType type{FieldKind::custom};
    return type;
}

namespace fields {

template <class T>
FieldType integer_type(FieldKind kind) {
    FieldType type{kind};
    type.integer = [](const void* value) { return static_cast<std::int64_t>(*static_cast<const T*>(value)); };
    type.set_integer = [](void* value, std::int64_t integer) { *static_cast<T*>(value) = static_cast<T>(integer); };
    return type;
}

template <class List>
FieldType list_type() {
    FieldType type{FieldKind::list};
    type.element = &type_of<typename List::value_type>;
    type.size = [](const void* list) { return static_cast<const List*>(list)->size(); };
    type.at = [](const void* list, std::size_t index) -> const void* {
        return &static_cast<const List*>(list)->at(index);
    };
    type.add = [](void* list) -> void* { return &static_cast<List*>(list)->emplace_back(); };
    type.empty = [](void* list) { static_cast<List*>(list)->clear(); };
    return type;
}

template <class T>
FieldType make_type() {
    if constexpr (std::is_same_v<T, double>) {
        return {FieldKind::number};
    } else if constexpr (std::is_same_v<T, bool>) {
        return integer_type<T>(FieldKind::flag);
    } else if constexpr (std::is_integral_v<T>) {
        return integer_type<T>(FieldKind::integer);
    } else if constexpr (std::is_same_v<T, std::string>) {
        return {FieldKind::text};
    } else if constexpr (HasWords<T>) {
        FieldType type = integer_type<T>(FieldKind::keyword);
        type.keywords = enum_words<T>;
        return type;
    } else {
        static_assert(is_list<T>, "Include contactd/fields/*.hpp of the header that defines this type.");
        return list_type<T>();
    }
}

template <auto member>
Field field_of_type(std::string_view name, const FieldType& (*type)(), const FieldNotes& notes) {
    using Owner = typename member_of<member>::Owner;
    using Value = typename member_of<member>::Value;
    Field field{name, type, {}, {}, {}};
    field.bounds = notes.bounds;
    field.unit = notes.unit;
    field.parity = notes.parity;
    field.required = notes.required;
    if constexpr (is_optional<Value>) {
        field.find = [](const void* owner) -> const void* {
            const auto& value = static_cast<const Owner*>(owner)->*member;
            return value ? &*value : nullptr;
        };
        field.make = [](void* owner) -> void* {
            auto& value = static_cast<Owner*>(owner)->*member;
            return value ? &*value : &value.emplace();
        };
        field.clear = [](void* owner) { (static_cast<Owner*>(owner)->*member).reset(); };
        field.present_by_default = (Owner{}.*member).has_value();
    } else {
        field.find = [](const void* owner) -> const void* { return &(static_cast<const Owner*>(owner)->*member); };
        field.make = [](void* owner) -> void* { return &(static_cast<Owner*>(owner)->*member); };
        if constexpr (is_list<Value>) field.present_by_default = !(Owner{}.*member).empty();
    }
    return field;
}

template <auto member>
using ValueOf = typename FieldValue<typename member_of<member>::Value>::type;

/// The field that `member` points at; its value may stand in an optional.
template <auto member>
Field field(std::string_view name, const FieldNotes& notes = {}) {
    return field_of_type<member>(name, &type_of<ValueOf<member>>, notes);
}

/// One whose type has no list of fields.
template <auto member>
Field custom_field(std::string_view name, const FieldNotes& notes = {}) {
    return field_of_type<member>(name, &custom_type<ValueOf<member>>, notes);
}

inline FieldType object_type(std::span<const Field> fields) {
    FieldType type{FieldKind::object};
    type.fields = fields;
    return type;
}

}  // namespace fields

/// The type of T; those of structs that have fields are specialised in contactd/fields/*.hpp.
template <class T>
const FieldType& type_of() {
    static const FieldType type = fields::make_type<T>();
    return type;
}

/// Throws InvalidArgument with `name` for its field where the number is out of the field's bounds, or not finite.
void check_number(const Field& field, double number, const std::string& name);

/// Throws InvalidArgument for the first number of `value`, below its fields, that is out of its bounds.
void check_bounds(const FieldType& type, const void* value);
template <class T>
void check_bounds(const T& value) {
    check_bounds(type_of<T>(), &value);
}

/// Makes `value` its mirror image: turns the sign of every number below its fields that is odd, or stands in an object
/// that is. The order of lists stays, and so do values of custom types.
void mirror_fields(const FieldType& type, void* value);
template <class T>
void mirror_fields(T& value) {
    mirror_fields(type_of<T>(), &value);
}

}  // namespace contactd
