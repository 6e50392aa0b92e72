#include "field_types.hpp"

#include <cstddef>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "contactd/fields/profile_spec.hpp"
#include "contactd/fields/section.hpp"
#include "contactd/section_fields.hpp"

namespace contactd {

// Lists consist of these, and of points.
template <>
const FieldType& type_of<Outline>();
template <>
const FieldType& type_of<OutlinePart>();

namespace c {
namespace {

template <class T>
const FieldType& object_of();

/// Determines the type of a member's value.
template <class T>
const FieldType& value_type() {
    if constexpr (std::is_arithmetic_v<T> || HasWords<T> || fields::is_list<T> || std::is_same_v<T, SectionPoint>)
        return type_of<T>();
    else
        return object_of<T>();
}

/// A section has points, which contactd_read_profile reads from a file.
template <class Alternative>
constexpr bool is_field = !std::is_same_v<Alternative, ProfileFile>;

/// An alternative of a variant has its own name, like other members.
template <class Owner, auto member, class... Alternatives>
void add(std::vector<Field>& list, const char*, std::type_identity<std::variant<Alternatives...>>) {
    std::size_t index = 0;
    const auto add_one = [&]<class Alternative>(std::type_identity<Alternative>) {
        const std::string_view name = alternative_names<std::variant<Alternatives...>>[index++];
        if constexpr (is_field<Alternative>)
            list.push_back(
                fields::field_as<Owner, member, fields::alternative<Alternative>>(name, &value_type<Alternative>));
    };
    (add_one(std::type_identity<Alternatives>()), ...);
}
template <class Owner, auto member, class Value>
void add(std::vector<Field>& list, const char* name, std::type_identity<Value>) {
    list.push_back(fields::field_as<Owner, member>(name, &value_type<Value>));
}

template <class T, std::size_t index>
void add_member(std::vector<Field>& list) {
    constexpr auto named = std::get<index>(named_members<T>);
    add<T, named.member>(list, named.name, std::type_identity<typename fields::member_of<named.member>::Value>());
}

template <class T>
std::vector<Field> fields_of() {
    std::vector<Field> list;
    [&]<std::size_t... index>(std::index_sequence<index...>) {
        (add_member<T, index>(list), ...);
    }(std::make_index_sequence<std::tuple_size_v<std::remove_const_t<decltype(named_members<T>)>>>());
    return list;
}

/// The wire has the owner of the profile beside the profile.
template <>
std::vector<Field> fields_of<ProfileSection>() {
    return {fields::field_along<ProfileSection, &ProfileSection::profile, &ProfileSpec::kind>("kind"),
            fields::field<&ProfileSection::profile>("profile"), fields::field<&ProfileSection::depth>("depth"),
            fields::field<&ProfileSection::from>("from")};
}

template <class T>
const FieldType& object_of() {
    static const std::vector<Field> list = fields_of<T>();
    static const FieldType type = fields::object_type(list);
    return type;
}

}  // namespace

const FieldType& type_of_section() {
    return object_of<Section>();
}

}  // namespace c

template <>
const FieldType& type_of<Outline>() {
    return c::object_of<Outline>();
}
template <>
const FieldType& type_of<OutlinePart>() {
    return c::object_of<OutlinePart>();
}

}  // namespace contactd
