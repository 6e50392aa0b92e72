// Lists the variables of a plain contact: two bodies on one grid, under a force or an approach, rolling or shifted.
#pragma once

#include <algorithm>

#include "common_variables.hpp"
#include "generated/contact_fields.hpp"

namespace contactd::fmu {

inline constexpr std::string_view gap_keywords[] = {"radii", "semi_axes"};
inline constexpr Enumeration gaps{"Gap", gap_keywords};
inline constexpr std::string_view load_keywords[] = {"force", "approach"};
inline constexpr Enumeration loads{"Load", load_keywords};
inline constexpr std::string_view coefficient_keywords[] = {"half_space", "half_space_by_elements", "block_by_elements",
                                                            "layer", "viscoelastic"};
inline constexpr Enumeration coefficients{"Coefficients", coefficient_keywords};

namespace detail {
/// Returns the variable of a field with x-fmu in proto/schema; an unknown name is a compile error.
consteval Variable field(std::string_view name) {
    return contact_fields[reference_in(contact_fields, name)];
}

inline constexpr auto contact_alone = std::to_array<Variable>({
    field("grid.nx"),
    field("grid.ny"),
    field("grid.dx"),
    field("grid.dy"),
    field("upper.G"),
    field("upper.nu"),
    field("upper.rigid"),
    keyword("upper.coefficients", coefficients, 0,
            "Kind of the upper body: in closed form, by finite elements, layered, or viscoelastic."),
    number("upper.coefficients_number", "upper.coefficients", coefficients,
           "Overrides upper.coefficients: 0 half_space, 1 half_space_by_elements, 2 block_by_elements, 3 layer, 4 "
           "viscoelastic; -1: upper.coefficients applies."),
    real("upper.layer.thickness", Role::parameter, "mm", 1,
         "Thickness of the layer on the upper body. Its base has upper.G and upper.nu."),
    real("upper.layer.G", Role::parameter, "N/mm2", 82000, "Shear modulus of the layer on the upper body."),
    real("upper.layer.nu", Role::parameter, "", 0.28, "Poisson's ratio of the layer on the upper body."),
    field("upper.viscoelastic.f"),
    field("upper.viscoelastic.tau"),
    field("lower.G"),
    field("lower.nu"),
    field("lower.rigid"),
    keyword("lower.coefficients", coefficients, 0, "Kind of the lower body, like upper.coefficients."),
    number("lower.coefficients_number", "lower.coefficients", coefficients,
           "Overrides lower.coefficients, like upper.coefficients_number; -1: lower.coefficients applies."),
    real("lower.layer.thickness", Role::parameter, "mm", 1,
         "Thickness of the layer on the lower body. Its base has lower.G and lower.nu."),
    real("lower.layer.G", Role::parameter, "N/mm2", 82000, "Shear modulus of the layer on the lower body."),
    real("lower.layer.nu", Role::parameter, "", 0.28, "Poisson's ratio of the layer on the lower body."),
    field("lower.viscoelastic.f"),
    field("lower.viscoelastic.tau"),
    real("elements.accuracy", Role::parameter, "", 1e-3, "Largest relative error of coefficients by finite elements."),
    real("elements.L_over_h", Role::parameter, "", 640, "Half the width of a block over the size of an element."),
    keyword("gap.kind", gaps, 0,
            "radii: h = x^2/(2 Rx) + y^2/(2 Ry). semi_axes: the gap of a Hertzian contact with these semi-axes."),
    number("gap.kind_number", "gap.kind", gaps, "Overrides gap.kind: 0 radii, 1 semi_axes; -1: gap.kind applies."),
    field("gap.Rx"),
    field("gap.Ry"),
    field("gap.a"),
    field("gap.b"),
    keyword("load.kind", loads, 0, "Prescribed load: the normal force, or the approach of the bodies."),
    number("load.kind_number", "load.kind", loads, "Overrides load.kind: 0 force, 1 approach; -1: load.kind applies."),
    field("load.Fn"),
    field("load.approach"),
    keyword("motion.kind", enumerations::motion, 0,
            "steady: steady rolling. transient: rolling that continues the previous step, over velocity times step "
            "size. shift: sliding that continues the previous step."),
    number("motion.kind_number", "motion.kind", enumerations::motion),
    field("motion.xi"),
    field("motion.eta"),
    field("motion.phi"),
    field("motion.velocity"),
    field("motion.chi"),
    real("motion.shift_x", Role::input, "mm/s", 0,
         "Velocity of a shift along x, of the upper body relative to the lower one."),
    real("motion.shift_y", Role::input, "mm/s", 0, "Velocity of a shift along y."),
    real("motion.shift_turn", Role::input, "rad/s", 0, "Angular velocity of a shift about z."),
    boolean("force.prescribe_x", Role::parameter, false,
            "True to prescribe the force along x. The motion along x is then an initial estimate."),
    boolean("force.prescribe_y", Role::parameter, false,
            "True to prescribe the force along y. The motion along y is then an initial estimate."),
    real("force.x", Role::input, "N", 0, "Force on the upper body along x, if prescribed."),
    real("force.y", Role::input, "N", 0, "Force on the upper body along y, if prescribed."),
    real("temperature.upper.bulk_temperature", Role::parameter, "degC", 0,
         "Temperature of the upper body's surface before contact."),
    real("temperature.lower.bulk_temperature", Role::parameter, "degC", 0,
         "Temperature of the lower body's surface before contact."),
    field("Fn"),
    field("Fx"),
    field("Fy"),
    field("Mz"),
    field("approach"),
    field("pmax"),
    field("area.contact"),
    field("area.adhesion"),
    field("area.slip"),
    field("xi"),
    field("eta"),
    field("power"),
    field("work"),
    field("resistance"),
    integer("patches", Role::output, 0, "1 in contact, 0 without contact."),
    field("converged"),
});

constexpr bool is_further(const Variable& variable) {
    for (const Variable& listed : contact_alone)
        if (listed.name == variable.name) return false;
    return true;
}
inline constexpr std::size_t further = static_cast<std::size_t>(std::ranges::count_if(contact_fields, is_further));

/// Returns the fields that the list above does not place.
consteval auto further_fields() {
    std::array<Variable, further> all;
    std::ranges::copy_if(contact_fields, all.begin(), is_further);
    return all;
}
}  // namespace detail

/// Further fields follow at the end, so that the value references of the others stay.
inline constexpr auto contact_variables =
    joined(joined(common_variables, detail::contact_alone), detail::further_fields());

}  // namespace contactd::fmu
