#include "field_types.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <variant>
#include <vector>

#include "contactd/fields/body.hpp"
#include "contactd/fields/contact.hpp"
#include "contactd/fields/ic_spec.hpp"
#include "fields_with.hpp"
#include "inputs.hpp"

namespace contactd {

template <>
const FieldType& type_of<StripFrame>() {
    static const std::array list{fields::field<&StripFrame::y>("y"), fields::field<&StripFrame::z>("z"),
                                 fields::field<&StripFrame::angle>("angle")};
    static const FieldType type = fields::object_type(list);
    return type;
}

namespace c {
namespace {

using fields::alternative;
using fields::field;
using fields::field_along;
using fields::field_as;
using fields::object_type;

Field& named(std::vector<Field>& list, std::string_view name) {
    return *std::ranges::find(list, name, &Field::name);
}

// --- grid, friction and motion ---------------------------------------------------------------------------------------

const FieldType& grid_type() {
    static const std::vector<Field> list = [] {
        std::vector<Field> fields = fields_with<Grid>({});
        for (const char* corner : {"x0", "y0"}) named(fields, corner).none = ContactInputs::centred;
        return fields;
    }();
    static const FieldType type = object_type(list);
    return type;
}

/// Components that are not prescribed are null in the list on the wire.
const FieldType& force_type() {
    static const std::vector<Field> list = fields_with<Force>({{"Fx", &type_of<double>}, {"Fy", &type_of<double>}});
    static const FieldType type = object_type(list);
    return type;
}

const FieldType& rolling_type() {
    static const std::vector<Field> list = [] {
        std::vector<Field> fields = fields_with<Rolling>({{"force", &force_type}});
        named(fields, "force").clear = [](void* rolling) { static_cast<Rolling*>(rolling)->force = {}; };
        return fields;
    }();
    static const FieldType type = object_type(list);
    return type;
}

void clear_motion(void* problem) {
    static_cast<ContactProblem*>(problem)->motion = {};
}

const FieldType& friction_type() {
    static const std::vector<Field> list = [] {
        std::vector<Field> fields =
            fields_with<FrictionFields<ContactProblem>>({{"rolling", &rolling_type}, {"force", &force_type}});
        named(fields, "mu").clear = [](void* problem) {
            if (auto& friction = static_cast<ContactProblem*>(problem)->friction) friction->mu.clear();
        };
        named(fields, "rigid_shift").clear = clear_motion;
        named(fields, "rolling").clear = clear_motion;
        named(fields, "force").clear = [](void* problem) {
            if (auto* shift = std::get_if<Shift>(&static_cast<ContactProblem*>(problem)->motion)) shift->force = {};
        };
        named(fields, "rigid_slip").clear = [](void* problem) {
            static_cast<ContactProblem*>(problem)->rigid_slip = {};
        };
        return fields;
    }();
    static const FieldType type = object_type(list);
    return type;
}

const FieldType& strips_type() {
    static const std::vector<Field> list = fields_with<ContactColumns>({{"frames", &type_of<std::vector<StripFrame>>}});
    static const FieldType type = object_type(list);
    return type;
}

// --- bodies ----------------------------------------------------------------------------------------------------------

const FieldType& base_type() {
    static const auto list = material_fields<Material>();
    static const FieldType type = object_type(list);
    return type;
}

const FieldType& ics_type() {
    static const std::vector<Field> list = fields_with<Ics>({{"section", &type_of_section}, {"base", &base_type}});
    static const FieldType type = object_type(list);
    return type;
}

/// Coefficients have a requested accuracy, unless it is cleared: then the fields of mesh and solver apply.
template <class Owner>
Field ics_field() {
    Field field = field_as<Owner, &Owner::ics, alternative<Ics>>("ics", &ics_type);
    field.make = [](void* owner) -> void* {
        constexpr double default_accuracy = 1e-3;
        std::optional<Coefficients>& ics = static_cast<Owner*>(owner)->ics;
        if (!ics || !std::holds_alternative<Ics>(*ics)) std::get<Ics>(ics.emplace(Ics{})).accuracy = default_accuracy;
        return &std::get<Ics>(*ics);
    };
    field.clear = [](void* owner) { static_cast<Owner*>(owner)->ics.reset(); };
    return field;
}

const FieldType& body_type() {
    static const std::vector<Field> list = [] {
        const auto material = material_fields<BodyInput>();
        std::vector<Field> fields(material.begin(), material.end());
        fields.push_back(field<&BodyInput::viscoelastic>("viscoelastic"));
        fields.push_back(ics_field<BodyInput>());
        return fields;
    }();
    static const FieldType type = object_type(list);
    return type;
}

const FieldType& bodies_type() {
    static const std::array list = [] {
        Field upper = field_as<ContactInputs, &ContactInputs::upper>("upper", &body_type);
        upper.clear = [](void* inputs) { static_cast<ContactInputs*>(inputs)->upper = {}; };
        return std::array{upper, field_as<ContactInputs, &ContactInputs::lower>("lower", &body_type)};
    }();
    static const FieldType type = object_type(list);
    return type;
}

// --- the computed motion ---------------------------------------------------------------------------------------------

template <class Kind, auto member>
Field field_of_motion(std::string_view name) {
    return field_along<Motion, alternative<Kind>, member>(name);
}

const FieldType& motion_type() {
    static const std::array list = [] {
        Field force{"force", &force_type, {}, {}, {}};
        force.find = [](const void* motion) -> const void* {
            return std::visit([](const auto& kind) { return &kind.force; }, *static_cast<const Motion*>(motion));
        };
        return std::array{field_of_motion<Shift, &Shift::rigid_shift>("rigid_shift"),
                          field_of_motion<Shift, &Shift::rotation>("rotation"),
                          field_of_motion<Shift, &Shift::duration>("duration"),
                          field_of_motion<Rolling, &Rolling::xi>("xi"),
                          field_of_motion<Rolling, &Rolling::eta>("eta"),
                          field_of_motion<Rolling, &Rolling::phi>("phi"),
                          field_of_motion<Rolling, &Rolling::chi>("chi"),
                          field_of_motion<Rolling, &Rolling::dq>("dq"),
                          field_of_motion<Rolling, &Rolling::spin_offset>("spin_offset"),
                          field_of_motion<Rolling, &Rolling::kind>("kind"),
                          field_of_motion<Rolling, &Rolling::steps>("steps"),
                          field_of_motion<Rolling, &Rolling::velocity>("velocity"),
                          force};
    }();
    static const FieldType type = object_type(list);
    return type;
}

}  // namespace

const FieldType& type_of_problem() {
    static const std::vector<Field> list = [] {
        std::vector<Field> fields = fields_with<ContactProblem>(
            {{"grid", &grid_type}, {"friction", &friction_type}, {"columns", &strips_type}});
        std::erase_if(fields, [](const Field& field) { return field.name == "initial"; });  // steps have none
        Field& friction = named(fields, "friction");
        friction.make = [](void* owner) -> void* {
            auto& problem = *static_cast<ContactProblem*>(owner);
            if (!problem.friction) problem.friction = FrictionLaw{{}, {}};
            return owner;
        };
        friction.clear = [](void* owner) {
            auto& problem = *static_cast<ContactProblem*>(owner);
            problem.friction.reset();
            problem.motion = {};
            problem.rigid_slip = {};
        };
        return fields;
    }();
    static const FieldType type = object_type(list);
    return type;
}

const FieldType& type_of_bodies_and_session() {
    static const std::array list{fields::field_within<ContactInputs>("bodies", &bodies_type),
                                 ics_field<ContactInputs>(),
                                 field<&ContactInputs::lease_seconds>(
                                     "lease_seconds", {.bounds = {.least = 0, .least_excluded = true}, .unit = "s"}),
                                 field<&ContactInputs::accept_unconverged>("accept_unconverged")};
    static const FieldType type = object_type(list);
    return type;
}

const FieldType& type_of_solution() {
    static const std::vector<Field> list = fields_with<ContactSolution>({{"motion", &motion_type}});
    static const FieldType type = object_type(list);
    return type;
}

}  // namespace c
}  // namespace contactd
