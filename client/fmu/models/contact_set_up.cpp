#include "contact_set_up.hpp"

#include "variables/contact_variables.hpp"

namespace contactd::fmu {
namespace {

consteval std::size_t at(std::string_view name) {
    return reference_of(contact_variables, name);
}

/// Where the list has what a body is made of.
struct BodyPlaces {
    std::int32_t body;
    std::size_t G, nu, rigid, coefficients, thickness, layer_G, layer_nu;
};
constexpr BodyPlaces bodies[] = {
    {CONTACTD_UPPER, at("upper.G"), at("upper.nu"), at("upper.rigid"), at("upper.coefficients"),
     at("upper.layer.thickness"), at("upper.layer.G"), at("upper.layer.nu")},
    {CONTACTD_LOWER, at("lower.G"), at("lower.nu"), at("lower.rigid"), at("lower.coefficients"),
     at("lower.layer.thickness"), at("lower.layer.G"), at("lower.layer.nu")},
};

void set_up_body(contactd_contact* c, const Values& values, const BodyPlaces& of) {
    if (values.is(of.rigid)) return check(contactd_set_rigid(c, of.body), c);
    const double G = values[of.G], nu = values[of.nu];
    check(contactd_set_material(c, of.body, G, nu), c);
    const int kind = values.whole(of.coefficients);
    if (kind == 3)
        return check(contactd_set_layers(c, of.body, CONTACTD_CONSTANT, &values.numbers[of.thickness],
                                         &values.numbers[of.layer_G], &values.numbers[of.layer_nu], 1, G, nu),
                     c);
    if (kind == 0) return;
    const bool block = kind == 2;
    check(contactd_set_fem(c, of.body, block ? CONTACTD_BLOCK : CONTACTD_HALF_SPACE, CONTACTD_CONSTANT,
                           values[at("elements.accuracy")], block ? values[at("elements.L_over_h")] : 0),
          c);
}

}  // namespace

void set_up(contactd_contact* c, const Values& values) {
    check(contactd_set_grid_centred(c, values.whole(at("grid.nx")), values.whole(at("grid.ny")), values[at("grid.dx")],
                                    values[at("grid.dy")]),
          c);
    for (const BodyPlaces& body : bodies) set_up_body(c, values, body);
    check(contactd_set_model(c, values.whole(at("model"))), c);
    check(contactd_set_accept_unconverged(c, values.is(at("accept_unconverged"))), c);
    const int most = values.whole(at("tolerances.iterations"));
    check(contactd_set_tolerance(c, CONTACTD_NORMAL, values[at("tolerances.normal")], most ? most : 1000), c);
    check(contactd_set_tolerance(c, CONTACTD_TANGENTIAL, values[at("tolerances.tangential")], most ? most : 1000), c);
    check(contactd_set_tolerance(c, CONTACTD_OUTER, values[at("tolerances.outer")], most ? most : 100), c);
    check(contactd_set_step_timeout(c, values[at("limits.step")]), c);
}

}  // namespace contactd::fmu
