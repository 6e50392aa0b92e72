#include "wheel_fields.hpp"

#include <array>
#include <initializer_list>
#include <span>
#include <utility>
#include <vector>

#include "backend.hpp"
#include "contactd/fields/wheel_rail_setup.hpp"
#include "contactd/fields/wheel_rail_state.hpp"

namespace contactd::c {
namespace {

using fields::field;
using fields::object_type;
using TypeOf = const FieldType& (*)();

// --- bodies: an elastic one has G and nu, a rigid one neither --------------------------------------------------------

template <auto member>
Field material_field(std::string_view name) {
    Field field = fields::field<member>(name);
    field.find = [](const void* body) -> const void* {
        const Material& material = static_cast<const Body*>(body)->material;
        return material.is_rigid() ? nullptr : &(material.*member);
    };
    field.make = [](void* body) -> void* {
        Material& material = static_cast<Body*>(body)->material;
        if (material.is_rigid()) material = {};
        return &(material.*member);
    };
    return field;
}

const FieldType& rigid_type() {
    static const FieldType type = [] {
        FieldType flag{FieldKind::flag};
        flag.integer = [](const void* body) -> std::int64_t {
            return static_cast<const Body*>(body)->material.is_rigid() ? 1 : 0;
        };
        flag.set_integer = [](void* body, std::int64_t rigid) {
            Material& material = static_cast<Body*>(body)->material;
            if (rigid != 0)
                material = Material::rigid();
            else if (material.is_rigid())
                material = {};
        };
        return flag;
    }();
    return type;
}

const FieldType& body_type() {
    static const std::array list = [] {
        Field rigid{"rigid", &rigid_type, {}, {}, {}};
        rigid.find = [](const void* body) { return body; };
        rigid.make = [](void* body) { return body; };
        return std::array{material_field<&Material::G>("G"), material_field<&Material::nu>("nu"), rigid};
    }();
    static const FieldType type = object_type(list);
    return type;
}

const FieldType& bodies_type() {
    static const std::array list{fields::field_as<Bodies, &Bodies::upper>("upper", &body_type),
                                 fields::field_as<Bodies, &Bodies::lower>("lower", &body_type)};
    static const FieldType type = object_type(list);
    return type;
}

// --- the inputs, with these ------------------------------------------------------------------------------------------

/// The fields of T, of which those that are named are of other types.
template <class T>
std::vector<Field> fields_with(std::initializer_list<std::pair<std::string_view, TypeOf>> others) {
    const std::span<const Field> all = type_of<T>().fields;
    std::vector<Field> list(all.begin(), all.end());
    for (Field& field : list)
        for (const auto& [name, type] : others)
            if (field.name == name) field.type = type;
    return list;
}

const FieldType& setup_type() {
    static const std::vector<Field> list = fields_with<WheelRailSetup>({{"bodies", &bodies_type}});
    static const FieldType type = object_type(list);
    return type;
}

}  // namespace

const FieldType& type_of_wheel_input() {
    static const std::array list{fields::field_as<WheelInput, &WheelInput::setup>("setup", &setup_type),
                                 field<&WheelInput::state>("state")};
    static const FieldType type = object_type(list);
    return type;
}

}  // namespace contactd::c
