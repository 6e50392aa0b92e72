// Describes the fields of a struct on the wire: their names, bounds and units, and access to them.
//
// `./dev generate` writes the lists from proto/schema, one for each struct (contactd/fields/*.hpp). Codec, bounds
// checks, mirrored wheels and paths of the C interface use them, so a new field is declared once.
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
#include <utility>
#include <variant>
#include <vector>

#include "contactd/enum_words.hpp"

namespace contactd {

/// Selects the form of a value on the wire. A value of kind `custom` has no list of fields; the code that uses it
/// handles its type.
enum class FieldKind { number, integer, flag, text, keyword, object, list, custom };

/// Holds the bounds of a number. An excluded bound is itself invalid.
struct Bounds {
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
    bool least_excluded = false, most_excluded = false;

    bool contain(double value) const {
        return std::isfinite(value) && (least_excluded ? value > least : value >= least) &&
               (most_excluded ? value < most : value <= most);
    }
};

/// Selects the change of a number in the mirror image of a wheel, with opposite y: `odd` changes its sign.
enum class MirrorParity { even, odd };

/// NaN represents no number, because it equals no number.
inline constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// Holds the properties of a field besides its name and its member.
struct FieldNotes {
    Bounds bounds{};
    double none = no_number;
    std::string_view unit{};
    MirrorParity parity = MirrorParity::even;
    bool required = false;
};

struct FieldType;

/// Describes one field of a struct; `owner` is the address of the struct.
struct Field {
    std::string_view name;
    const FieldType& (*type)();
    const void* (*find)(const void* owner);  ///< null if the field is optional and absent
    void* (*make)(void* owner);              ///< like `find`; an absent optional field first gets its default
    void (*clear)(void* owner);              ///< makes an optional field absent; null if the field is required
    /// An optional field, or an entry of a list, may be present by default. Then only null or an empty list makes it
    /// absent; an omitted member does not.
    bool present_by_default = false;
    bool required = false;  ///< a message without it is invalid, even if it is an empty list
    Bounds bounds{};
    double none = no_number;  ///< messages omit a number with this value, which means absent
    std::string_view unit{};
    MirrorParity parity = MirrorParity::even;
};

/// Describes the form of a C++ type on the wire. There is one object per type, and its address identifies it.
struct FieldType {
    FieldKind kind = FieldKind::custom;
    bool is_tuple = false;                                ///< for an object that is a list of values on the wire
    std::span<const Field> fields{};                      ///< of an object
    std::span<const std::string_view> keywords{};         ///< for a keyword, indexed by the enumerators' values
    std::int64_t (*integer)(const void* value) = {};      ///< for integers, flags and keywords
    void (*set_integer)(void* value, std::int64_t) = {};  ///< for the same kinds
    const FieldType& (*element)() = {};                   ///< for a list, like the members below
    std::size_t (*size)(const void* list) = {};
    const void* (*at)(const void* list, std::size_t index) = {};  ///< an entry; to write to it, cast away const
    void* (*add)(void* list) = {};                                ///< appends a default
    void (*empty)(void* list) = {};
};

/// Gives the type of a member's value, without std::optional.
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

/// Returns the type of values without a list of fields.
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

/// Returns the type of a struct without members, which is `true` on the wire if present.
inline FieldType presence_type() {
    FieldType type{FieldKind::flag};
    type.integer = [](const void*) { return std::int64_t{1}; };
    type.set_integer = [](void*, std::int64_t) {};
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
    } else if constexpr (std::is_empty_v<T>) {
        return presence_type();
    } else if constexpr (HasWords<T>) {
        FieldType type = integer_type<T>(FieldKind::keyword);
        type.keywords = enum_words<T>;
        return type;
    } else {
        static_assert(is_list<T>, "Include contactd/fields/*.hpp of the header that defines this type.");
        return list_type<T>();
    }
}

/// Represents a step to one alternative of a variant. It is absent while the variant holds another one; making it
/// replaces that one.
template <class T>
inline constexpr std::type_identity<T> alternative{};

template <class Value>
auto* find_value(Value& value) {
    if constexpr (is_optional<std::remove_const_t<Value>>)
        return value ? &*value : nullptr;
    else
        return &value;
}
template <class Value>
auto* make_value(Value& value) {
    if constexpr (is_optional<Value>)
        return value ? &*value : &value.emplace();
    else
        return &value;
}

template <class Value, class Member, class Owner>
auto* find_next(Value& value, Member Owner::* member) {
    return &(value.*member);
}
template <class Value, class T>
auto* find_next(Value& value, std::type_identity<T>) {
    return std::get_if<T>(&value);
}
template <class Value, class Member, class Owner>
auto* make_next(Value& value, Member Owner::* member) {
    return &(value.*member);
}
template <class Value, class T>
auto* make_next(Value& value, std::type_identity<T>) {
    T* found = std::get_if<T>(&value);
    return found ? found : &value.template emplace<T>();
}
/// Returns the value at the end of the steps from `value`, or null if it is absent. Steps do not include optional
/// values.
template <auto step, auto... more, class Value>
auto* find_along(Value& value) {
    auto* from = find_value(value);
    auto* next = from ? find_next(*from, step) : decltype(find_next(*from, step)){};
    if constexpr (sizeof...(more) == 0)
        return next;
    else
        return next ? find_along<more...>(*next) : decltype(find_along<more...>(*next)){};
}

template <auto step, auto... more, class Value>
auto* make_along(Value& value) {
    auto* next = make_next(*make_value(value), step);
    if constexpr (sizeof...(more) == 0)
        return next;
    else
        return make_along<more...>(*next);
}

/// Gives the type of the member at the end of the steps, which may be std::optional.
template <class Owner, auto... steps>
using MemberAlong = std::remove_pointer_t<decltype(make_along<steps...>(std::declval<Owner&>()))>;

template <class Owner, auto... steps>
Field field_as(std::string_view name, const FieldType& (*type)(), const FieldNotes& notes = {}) {
    using Member = MemberAlong<Owner, steps...>;
    Field field{name, type, {}, {}, {}};
    field.bounds = notes.bounds;
    field.none = notes.none;
    field.unit = notes.unit;
    field.parity = notes.parity;
    field.required = notes.required;
    field.find = [](const void* owner) -> const void* {
        const auto* member = find_along<steps...>(*static_cast<const Owner*>(owner));
        return member ? find_value(*member) : nullptr;
    };
    field.make = [](void* owner) -> void* { return make_value(*make_along<steps...>(*static_cast<Owner*>(owner))); };
    if constexpr (is_optional<Member>)
        field.clear = [](void* owner) {
            if (auto* member = find_along<steps...>(*static_cast<Owner*>(owner))) member->reset();
        };
    // An alternative that a variant holds by default is not required.
    if constexpr (std::is_member_pointer_v<decltype((steps, ...))> && sizeof...(steps) == 1) {
        const Owner defaults{};
        const auto* value = find_value(*find_along<steps...>(defaults));
        if constexpr (is_optional<Member>)
            field.present_by_default = value != nullptr;
        else if constexpr (is_list<Member>)
            field.present_by_default = !value->empty();
    }
    return field;
}

/// Gives the type of a field's value, without std::optional.
template <class Owner, auto... steps>
using ValueAlong = typename FieldValue<MemberAlong<Owner, steps...>>::type;

/// Returns the field at the end of the steps from Owner; its value may be in std::optional.
template <class Owner, auto... steps>
Field field_along(std::string_view name, const FieldNotes& notes = {}) {
    return field_as<Owner, steps...>(name, &type_of<ValueAlong<Owner, steps...>>, notes);
}

/// Returns a field whose type has no list of fields.
template <class Owner, auto... steps>
Field custom_field_along(std::string_view name, const FieldNotes& notes = {}) {
    return field_as<Owner, steps...>(name, &custom_type<ValueAlong<Owner, steps...>>, notes);
}

/// Returns the field that `member` points at.
template <auto member>
Field field(std::string_view name, const FieldNotes& notes = {}) {
    return field_along<typename member_of<member>::Owner, member>(name, notes);
}
template <auto member>
Field custom_field(std::string_view name, const FieldNotes& notes = {}) {
    return custom_field_along<typename member_of<member>::Owner, member>(name, notes);
}

/// Returns a field that groups members of Owner itself: in messages, they are below its name.
template <class Owner>
Field field_within(std::string_view name, const FieldType& (*type)()) {
    Field field{name, type, {}, {}, {}};
    field.find = [](const void* owner) { return owner; };
    field.make = [](void* owner) { return owner; };
    return field;
}

/// Returns a field that groups members of Owner itself, and that is absent while the optional `member` is.
template <class Owner, auto member>
Field field_beside(std::string_view name, const FieldType& (*type)()) {
    Field field = field_within<Owner>(name, type);
    field.find = [](const void* owner) { return static_cast<const Owner*>(owner)->*member ? owner : nullptr; };
    field.make = [](void* owner) {
        make_value(static_cast<Owner*>(owner)->*member);
        return owner;
    };
    field.clear = [](void* owner) { (static_cast<Owner*>(owner)->*member).reset(); };
    return field;
}

inline FieldType object_type(std::span<const Field> fields) {
    FieldType type{FieldKind::object};
    type.fields = fields;
    return type;
}

inline FieldType tuple_type(std::span<const Field> fields) {
    FieldType type = object_type(fields);
    type.is_tuple = true;
    return type;
}

}  // namespace fields

/// Returns the type of T; contactd/fields/*.hpp specialises it for structs with fields.
template <class T>
const FieldType& type_of() {
    static const FieldType type = fields::make_type<T>();
    return type;
}

/// Throws InvalidArgument with `name` as its field if the number is outside the field's bounds, or not finite.
void check_number(const Field& field, double number, const std::string& name);

/// Throws InvalidArgument for the first number in `value` or its fields that is outside its bounds.
void check_bounds(const FieldType& type, const void* value);
template <class T>
void check_bounds(const T& value) {
    check_bounds(type_of<T>(), &value);
}

/// Mirrors `value`: changes the sign of every number in its fields that is odd or belongs to an odd object. The order
/// of lists and values of custom types do not change.
void mirror_fields(const FieldType& type, void* value);
template <class T>
void mirror_fields(T& value) {
    mirror_fields(type_of<T>(), &value);
}

}  // namespace contactd
