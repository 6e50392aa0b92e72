// Every function that takes a contact, with arguments that are fine for themselves.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "c_contact.hpp"

using Call = std::function<std::int32_t(contactd_contact*)>;

/// What the calls below read and write.
struct Arguments {
    double in[9] = {1, 1, 1, 1, 1, 1, 1, 1, 1}, out[4] = {};
    std::int32_t number[4] = {};
    char text[8] = {};
};

/// By the function's name; `a` outlives them.
inline std::map<std::string, Call> every_call(Arguments& a) {
    using C = contactd_contact*;
    double *x = a.out, *y = a.out + 1, *z = a.out + 2, *w = a.out + 3;
    std::int32_t *n = a.number, *m = a.number + 1, *k = a.number + 2, *l = a.number + 3;
    return {
        {"contactd_free", [](C c) { return contactd_free(c); }},
        {"contactd_start", [](C c) { return contactd_start(c); }},
        {"contactd_step", [](C c) { return contactd_step(c); }},
        {"contactd_step_again", [](C c) { return contactd_step_again(c); }},
        {"contactd_want_derivatives", [](C c) { return contactd_want_derivatives(c, 1); }},
        {"contactd_get_derivative", [=](C c) { return contactd_get_derivative(c, CONTACTD_OF_FX, CONTACTD_BY_X, x); }},
        {"contactd_cancel", [](C c) { return contactd_cancel(c); }},
        {"contactd_save", [=](C c) { return contactd_save(c, n); }},
        {"contactd_restore", [](C c) { return contactd_restore(c, 1); }},
        {"contactd_forget", [](C c) { return contactd_forget(c, 1); }},
        {"contactd_set_grid", [](C c) { return contactd_set_grid(c, 2, 2, 1, 1, 0, 0); }},
        {"contactd_set_grid_centred", [](C c) { return contactd_set_grid_centred(c, 2, 2, 1, 1); }},
        {"contactd_set_material", [](C c) { return contactd_set_material(c, CONTACTD_BOTH, 200, 0.3); }},
        {"contactd_set_rigid", [](C c) { return contactd_set_rigid(c, CONTACTD_UPPER); }},
        {"contactd_set_half_space", [](C c) { return contactd_set_half_space(c, CONTACTD_BOTH, CONTACTD_CONSTANT); }},
        {"contactd_set_fem", [](C c) { return contactd_set_fem(c, CONTACTD_BOTH, CONTACTD_BLOCK, 0, 0.01, 40); }},
        {"contactd_set_table", [&a](C c) { return contactd_set_table(c, CONTACTD_BOTH, 1, 1, 1, 1, a.in, 9); }},
        {"contactd_set_layers",
         [&a](C c) { return contactd_set_layers(c, CONTACTD_LOWER, CONTACTD_CONSTANT, a.in, a.in, a.in, 1, 0, 0); }},
        {"contactd_set_section", [&a](C c) { return contactd_set_section(c, CONTACTD_LOWER, CONTACTD_SLAB, a.in, 2); }},
        {"contactd_set_profile_points",
         [&a](C c) { return contactd_set_profile_points(c, CONTACTD_LOWER, CONTACTD_RAIL, a.in, a.in, 9, 0, 40, 0); }},
        {"contactd_set_profile_file",
         [](C c) { return contactd_set_profile_file(c, CONTACTD_LOWER, CONTACTD_RAIL, "rail.prr", 0, 40, 0); }},
        {"contactd_set_outline", [](C c) { return contactd_set_outline(c, CONTACTD_LOWER, 0, 0); }},
        {"contactd_add_line", [](C c) { return contactd_add_line(c, CONTACTD_LOWER, 1, 0, 0); }},
        {"contactd_add_arc", [](C c) { return contactd_add_arc(c, CONTACTD_LOWER, 1, 0, 1, 0); }},
        {"contactd_add_spline", [&a](C c) { return contactd_add_spline(c, CONTACTD_LOWER, a.in, a.in, 2, 0); }},
        {"contactd_add_hole", [](C c) { return contactd_add_hole(c, CONTACTD_LOWER, 0, 0); }},
        {"contactd_set_first_column", [](C c) { return contactd_set_first_column(c, CONTACTD_LOWER, 0, 0, 0); }},
        {"contactd_set_section_place", [](C c) { return contactd_set_section_place(c, CONTACTD_LOWER, 1, 0); }},
        {"contactd_set_section_accuracy", [](C c) { return contactd_set_section_accuracy(c, CONTACTD_LOWER, 0.01); }},
        {"contactd_set_columns", [&a](C c) { return contactd_set_columns(c, a.in, a.in, a.in, 2, 0, 0, 0); }},
        {"contactd_get_frames", [=](C c) { return contactd_get_frames(c, CONTACTD_LOWER, x, y, z, 2); }},
        {"contactd_get_resultant", [&a](C c) { return contactd_get_resultant(c, a.in); }},
        {"contactd_set_line_contact", [](C c) { return contactd_set_line_contact(c, 10); }},
        {"contactd_set_model", [](C c) { return contactd_set_model(c, CONTACTD_FULL); }},
        {"contactd_set_tolerance", [](C c) { return contactd_set_tolerance(c, CONTACTD_OUTER, 1e-6, 10); }},
        {"contactd_set_accept_unconverged", [](C c) { return contactd_set_accept_unconverged(c, 1); }},
        {"contactd_set_previous", [&a](C c) { return contactd_set_previous(c, a.in, a.in, a.in, 4); }},
        {"contactd_set_lease", [](C c) { return contactd_set_lease(c, 10); }},
        {"contactd_set_approach", [](C c) { return contactd_set_approach(c, 0.01); }},
        {"contactd_set_Fn", [](C c) { return contactd_set_Fn(c, 1); }},
        {"contactd_set_paraboloid", [](C c) { return contactd_set_paraboloid(c, 50, 50); }},
        {"contactd_set_semi_axes", [](C c) { return contactd_set_semi_axes(c, 1, 1); }},
        {"contactd_set_gap", [&a](C c) { return contactd_set_gap(c, a.in, 4); }},
        {"contactd_set_mu", [](C c) { return contactd_set_mu(c, 0.3); }},
        {"contactd_set_mu_array", [&a](C c) { return contactd_set_mu_array(c, a.in, 4); }},
        {"contactd_set_kinetic", [](C c) { return contactd_set_kinetic(c, CONTACTD_LINEAR, 0.1, 1); }},
        {"contactd_set_shift", [](C c) { return contactd_set_shift(c, 0, 0, 0); }},
        {"contactd_set_duration", [](C c) { return contactd_set_duration(c, 1); }},
        {"contactd_set_rolling", [](C c) { return contactd_set_rolling(c, CONTACTD_STEADY, 0, 0, 0); }},
        {"contactd_set_direction", [](C c) { return contactd_set_direction(c, 0, 0); }},
        {"contactd_set_spin_offset", [](C c) { return contactd_set_spin_offset(c, 0); }},
        {"contactd_set_rolling_steps", [](C c) { return contactd_set_rolling_steps(c, 1); }},
        {"contactd_set_velocity", [](C c) { return contactd_set_velocity(c, 1); }},
        {"contactd_set_Fx", [](C c) { return contactd_set_Fx(c, 0); }},
        {"contactd_set_Fy", [](C c) { return contactd_set_Fy(c, 0); }},
        {"contactd_clear_forces", [](C c) { return contactd_clear_forces(c); }},
        {"contactd_set_rigid_slip", [&a](C c) { return contactd_set_rigid_slip(c, a.in, a.in, 4); }},
        {"contactd_set_step_timeout", [](C c) { return contactd_set_step_timeout(c, 10); }},
        {"contactd_get_step", [=](C c) { return contactd_get_step(c, n); }},
        {"contactd_get_forces", [=](C c) { return contactd_get_forces(c, x, y, z, w); }},
        {"contactd_get_approach", [=](C c) { return contactd_get_approach(c, x); }},
        {"contactd_get_pmax", [=](C c) { return contactd_get_pmax(c, x); }},
        {"contactd_get_areas", [=](C c) { return contactd_get_areas(c, x, y, z); }},
        {"contactd_get_counts", [=](C c) { return contactd_get_counts(c, n, m, k, l); }},
        {"contactd_get_creepages", [=](C c) { return contactd_get_creepages(c, x, y, z); }},
        {"contactd_get_shift", [=](C c) { return contactd_get_shift(c, x, y, z); }},
        {"contactd_get_frictional_work", [=](C c) { return contactd_get_frictional_work(c, x); }},
        {"contactd_get_frictional_power", [=](C c) { return contactd_get_frictional_power(c, x); }},
        {"contactd_get_converged", [=](C c) { return contactd_get_converged(c, n); }},
        {"contactd_get_evidence", [=](C c) { return contactd_get_evidence(c, CONTACTD_NORMAL, n, x, m); }},
        {"contactd_get_discretisation", [=](C c) { return contactd_get_discretisation(c, n, x, y, z); }},
        {"contactd_get_warnings", [=](C c) { return contactd_get_warnings(c, n); }},
        {"contactd_get_warning", [&a](C c) { return contactd_get_warning(c, 0, a.text, 8); }},
        {"contactd_get_origin", [&a](C c) { return contactd_get_origin(c, CONTACTD_UPPER, a.text, 8); }},
    };
}
