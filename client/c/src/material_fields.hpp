// Describes fields of a material: an elastic one has G and nu, a rigid one neither.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string_view>
#include <type_traits>

#include "contactd/fields.hpp"
#include "contactd/material.hpp"

namespace contactd::c {

/// Represents an elastic body without either number.
inline constexpr Material no_material{std::numeric_limits<double>::quiet_NaN(),
                                      std::numeric_limits<double>::quiet_NaN()};

/// Returns the material itself, or that of a body.
template <class Owner>
Material& material_of(void* owner) {
    if constexpr (std::is_same_v<Owner, Material>)
        return *static_cast<Material*>(owner);
    else
        return static_cast<Owner*>(owner)->material;
}
template <class Owner>
const Material& material_of(const void* owner) {
    return material_of<Owner>(const_cast<void*>(owner));
}

template <class Owner, auto member>
Field material_field(std::string_view name) {
    Field field = fields::field<member>(name);
    field.find = [](const void* owner) -> const void* {
        const Material& material = material_of<Owner>(owner);
        return material.is_rigid() ? nullptr : &(material.*member);
    };
    field.make = [](void* owner) -> void* {
        Material& material = material_of<Owner>(owner);
        if (material.is_rigid()) material = no_material;
        return &(material.*member);
    };
    return field;
}

template <class Owner>
const FieldType& rigid_type() {
    static const FieldType type = [] {
        FieldType flag{FieldKind::flag};
        flag.integer = [](const void* owner) -> std::int64_t { return material_of<Owner>(owner).is_rigid() ? 1 : 0; };
        flag.set_integer = [](void* owner, std::int64_t rigid) {
            Material& material = material_of<Owner>(owner);
            if (rigid != 0)
                material = Material::rigid();
            else if (material.is_rigid())
                material = no_material;
        };
        return flag;
    }();
    return type;
}

/// Returns "G", "nu" and "rigid" of a Material, or of a struct with a member `material`.
template <class Owner>
std::array<Field, 3> material_fields() {
    return {material_field<Owner, &Material::G>("G"), material_field<Owner, &Material::nu>("nu"),
            fields::field_within<Owner>("rigid", &rigid_type<Owner>)};
}

}  // namespace contactd::c
