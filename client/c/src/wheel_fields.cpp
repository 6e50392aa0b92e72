#include "field_types.hpp"

#include <array>
#include <vector>

#include "backend.hpp"
#include "contactd/fields/wheel_rail_setup.hpp"
#include "contactd/fields/wheel_rail_state.hpp"
#include "fields_with.hpp"
#include "material_fields.hpp"

namespace contactd::c {
namespace {

using fields::field;
using fields::object_type;

const FieldType& body_type() {
    static const auto list = material_fields<Body>();
    static const FieldType type = object_type(list);
    return type;
}

const FieldType& bodies_type() {
    static const std::array list{fields::field_as<Bodies, &Bodies::upper>("upper", &body_type),
                                 fields::field_as<Bodies, &Bodies::lower>("lower", &body_type)};
    static const FieldType type = object_type(list);
    return type;
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
