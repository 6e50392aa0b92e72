// Cases that two ways must answer alike: what is set before the start, and what before each step.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "c_contact.hpp"

struct SameCase {
    std::string name;
    std::function<void(contactd_contact*)> set_up;
    std::vector<std::function<void(contactd_contact*)>> steps;
};

inline std::vector<SameCase> same_cases() {
    const auto nothing = [](contactd_contact*) {};
    const auto rolls = [](contactd_contact* c) {
        require_ok(contactd_set_mu(c, 0.3), c);
        require_ok(contactd_set_rolling(c, CONTACTD_STEADY, 4e-3, -1e-3, 2e-3), c);
    };
    std::vector<SameCase> cases;
    cases.push_back({"normal, by approach and by force",
                     nothing,
                     {nothing, [](contactd_contact* c) { require_ok(contactd_set_Fn(c, 5), c); },
                      [](contactd_contact* c) { require_ok(contactd_set_paraboloid(c, 40, 60), c); },
                      [](contactd_contact* c) { require_ok(contactd_set_approach(c, 0.01), c); }}});
    cases.push_back({"semi-axes",
                     [](contactd_contact* c) { require_ok(contactd_set_semi_axes(c, 0.9, 0.7), c); },
                     {nothing, nothing}});
    cases.push_back({"a gap of its own",
                     [](contactd_contact* c) {
                         std::vector<double> gap(elements);
                         for (int i = 0; i < elements; ++i)
                             gap[i] = 1e-4 * ((i % across - 5) * (i % across - 6) + i / across);
                         require_ok(contactd_set_gap(c, gap.data(), elements), c);
                     },
                     {nothing}});
    cases.push_back(
        {"shift, there and back",
         [](contactd_contact* c) {
             require_ok(contactd_set_mu(c, 0.4), c);
             require_ok(contactd_set_shift(c, 0.004, 0, 0), c);
         },
         {nothing, nothing, [](contactd_contact* c) { require_ok(contactd_set_shift(c, -0.006, 0.001, 1e-3), c); },
          nothing}});
    cases.push_back({"shift under a force",
                     [](contactd_contact* c) {
                         require_ok(contactd_set_mu(c, 0.4), c);
                         require_ok(contactd_set_Fx(c, -1.5), c);
                     },
                     {nothing, [](contactd_contact* c) { require_ok(contactd_set_Fx(c, -2), c); },
                      [](contactd_contact* c) { require_ok(contactd_clear_forces(c), c); }}});
    cases.push_back(
        {"steady rolling",
         rolls,
         {nothing, [](contactd_contact* c) { require_ok(contactd_set_rolling(c, CONTACTD_STEADY, 1e-3, 0, 0), c); },
          [](contactd_contact* c) { require_ok(contactd_set_direction(c, 0.5, 0.15), c); },
          [](contactd_contact* c) { require_ok(contactd_set_spin_offset(c, 1. / 6), c); }}});
    cases.push_back({"rolling under a force",
                     rolls,
                     {[](contactd_contact* c) { require_ok(contactd_set_Fx(c, -1), c); }, nothing,
                      [](contactd_contact* c) { require_ok(contactd_set_Fy(c, 0.2), c); }, nothing}});
    cases.push_back({"transient rolling",
                     [&](contactd_contact* c) {
                         require_ok(contactd_set_mu(c, 0.3), c);
                         require_ok(contactd_set_rolling(c, CONTACTD_TRANSIENT, 4e-3, 0, 0), c);
                         require_ok(contactd_set_rolling_steps(c, 2), c);
                     },
                     {nothing, nothing, nothing}});
    cases.push_back({"bodies that differ",
                     [](contactd_contact* c) {
                         require_ok(contactd_set_material(c, CONTACTD_LOWER, 900, 0.2), c);
                         require_ok(contactd_set_mu(c, 0.4), c);
                         require_ok(contactd_set_shift(c, 0.002, 0, 0), c);
                     },
                     {nothing, nothing}});
    cases.push_back({"a rigid body and tents",
                     [](contactd_contact* c) {
                         require_ok(contactd_set_rigid(c, CONTACTD_LOWER), c);
                         require_ok(contactd_set_half_space(c, CONTACTD_BOTH, CONTACTD_BILINEAR), c);
                     },
                     {nothing}});
    cases.push_back({"friction by element that falls, and slip of the elements",
                     [](contactd_contact* c) {
                         std::vector<double> mu(elements, 0.4), x(elements, 1e-3), y(elements, 0);
                         mu[70] = 0.2;
                         x[5] = -1e-3;
                         require_ok(contactd_set_mu_array(c, mu.data(), elements), c);
                         require_ok(contactd_set_kinetic(c, CONTACTD_EXPONENTIAL, 0.1, 0.01), c);
                         require_ok(contactd_set_duration(c, 0.5), c);
                         require_ok(contactd_set_rigid_slip(c, x.data(), y.data(), elements), c);
                     },
                     {nothing, nothing}});
    cases.push_back({"a history",
                     [](contactd_contact* c) {
                         std::vector<double> p(elements, 1), x(elements, 0.1), y(elements, -0.1);
                         require_ok(contactd_set_previous(c, p.data(), x.data(), y.data(), elements), c);
                         require_ok(contactd_set_mu(c, 0.4), c);
                         require_ok(contactd_set_shift(c, 1e-3, 0, 0), c);
                     },
                     {nothing}});
    for (const std::int32_t model : {CONTACTD_HERTZ, CONTACTD_FASTSIM})
        cases.push_back({model == CONTACTD_HERTZ ? "Hertz" : "Fastsim",
                         [=](contactd_contact* c) {
                             require_ok(contactd_set_model(c, model), c);
                             if (model == CONTACTD_FASTSIM) rolls(c);
                         },
                         {nothing, [](contactd_contact* c) { require_ok(contactd_set_Fn(c, 7), c); }}});
    cases.push_back({"a line contact",
                     [](contactd_contact* c) {
                         require_ok(contactd_set_grid_centred(c, elements, 1, 0.02, 1), c);
                         require_ok(contactd_set_paraboloid(c, 50, std::numeric_limits<double>::infinity()), c);
                         require_ok(contactd_set_line_contact(c, 20), c);
                         require_ok(contactd_set_Fn(c, 5), c);
                         require_ok(contactd_set_mu(c, 0.3), c);
                         require_ok(contactd_set_rolling(c, CONTACTD_STEADY, 1e-3, 0, 0), c);
                     },
                     {nothing}});
    cases.push_back(
        {"friction that comes later, rolling, and then a shift",
         nothing,
         {nothing, rolls, nothing, [](contactd_contact* c) { require_ok(contactd_set_shift(c, 2e-3, 0, 0), c); },
          [](contactd_contact* c) { require_ok(contactd_set_mu(c, 0.1), c); }}});
    return cases;
}
