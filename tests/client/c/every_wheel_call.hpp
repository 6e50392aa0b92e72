// Every function that takes a wheel on its rail, with arguments that are fine for themselves.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "c_contact.hpp"

using WheelCall = std::function<std::int32_t(contactd_wheel*)>;

/// What the calls below read and write.
struct WheelArguments {
    double in[9] = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9}, out[6] = {};
    std::int32_t number[4] = {};
    char text[8] = {};
};

/// By the function's name; `a` outlives them.
inline std::map<std::string, WheelCall> every_wheel_call(WheelArguments& a) {
    using W = contactd_wheel*;
    return {
        {"contactd_wheel_free", [](W w) { return contactd_wheel_free(w); }},
        {"contactd_wheel_solve", [](W w) { return contactd_wheel_solve(w); }},
        {"contactd_wheel_solve_wheelset", [](W w) { return contactd_wheel_solve_wheelset(w, w); }},
        {"contactd_wheel_cancel", [](W w) { return contactd_wheel_cancel(w); }},
        {"contactd_wheel_set_timeout", [](W w) { return contactd_wheel_set_timeout(w, 0.1); }},
        {"contactd_wheel_set_side", [](W w) { return contactd_wheel_set_side(w, 1); }},
        {"contactd_wheel_set_s1002", [](W w) { return contactd_wheel_set_s1002(w); }},
        {"contactd_wheel_set_rail_60e1", [](W w) { return contactd_wheel_set_rail_60e1(w, 0.025); }},
        {"contactd_wheel_set_arc", [](W w) { return contactd_wheel_set_arc(w, CONTACTD_RAIL, 300, 0, -30, 30); }},
        {"contactd_wheel_set_cone", [](W w) { return contactd_wheel_set_cone(w, CONTACTD_WHEEL, -0.05, -30, 30); }},
        {"contactd_wheel_set_points",
         [&a](W w) { return contactd_wheel_set_points(w, CONTACTD_WHEEL, a.in, a.in, 3, 0.1); }},
        {"contactd_wheel_set_file", [](W w) { return contactd_wheel_set_file(w, CONTACTD_RAIL, "nowhere.prr", 0); }},
        {"contactd_wheel_add_slice", [](W w) { return contactd_wheel_add_slice(w, 0.1); }},
        {"contactd_wheel_clear_slices", [](W w) { return contactd_wheel_clear_slices(w); }},
        {"contactd_wheel_add_wheel_slice", [](W w) { return contactd_wheel_add_wheel_slice(w, 0.1); }},
        {"contactd_wheel_clear_wheel_slices", [](W w) { return contactd_wheel_clear_wheel_slices(w); }},
        {"contactd_wheel_set_track", [](W w) { return contactd_wheel_set_track(w, 1435, 14, 0); }},
        {"contactd_wheel_set_rail_origin", [](W w) { return contactd_wheel_set_rail_origin(w, 0.1, 0.1); }},
        {"contactd_wheel_set_roller", [](W w) { return contactd_wheel_set_roller(w, 0.1); }},
        {"contactd_wheel_set_springs", [](W w) { return contactd_wheel_set_springs(w, 0.1, 0.1); }},
        {"contactd_wheel_set_wheelset", [](W w) { return contactd_wheel_set_wheelset(w, 1360, -70, 460); }},
        {"contactd_wheel_set_material", [](W w) { return contactd_wheel_set_material(w, CONTACTD_WHEEL, 0.1, 0.1); }},
        {"contactd_wheel_set_rigid", [](W w) { return contactd_wheel_set_rigid(w, CONTACTD_WHEEL); }},
        {"contactd_wheel_set_model", [](W w) { return contactd_wheel_set_model(w, 1); }},
        {"contactd_wheel_set_mu", [](W w) { return contactd_wheel_set_mu(w, 0.1); }},
        {"contactd_wheel_set_mu_by_angle", [&a](W w) { return contactd_wheel_set_mu_by_angle(w, a.in, a.in, 3, 1); }},
        {"contactd_wheel_set_kinetic", [](W w) { return contactd_wheel_set_kinetic(w, 1, 0.1, 0.1); }},
        {"contactd_wheel_set_frictionless", [](W w) { return contactd_wheel_set_frictionless(w); }},
        {"contactd_wheel_set_elements", [](W w) { return contactd_wheel_set_elements(w, 1, 1, 0); }},
        {"contactd_wheel_set_patch_rules", [](W w) { return contactd_wheel_set_patch_rules(w, 1.5, 8, 4, 12, 0.3); }},
        {"contactd_wheel_set_bilinear", [](W w) { return contactd_wheel_set_bilinear(w, 1); }},
        {"contactd_wheel_set_slip_of_surfaces", [](W w) { return contactd_wheel_set_slip_of_surfaces(w, 1); }},
        {"contactd_wheel_set_mesh_search", [](W w) { return contactd_wheel_set_mesh_search(w, 1); }},
        {"contactd_wheel_set_conformal", [](W w) { return contactd_wheel_set_conformal(w, 1); }},
        {"contactd_wheel_get_rows",
         [&a](W w) { return contactd_wheel_get_rows(w, 0, a.out, a.out + 1, a.out + 2, 1); }},
        {"contactd_wheel_set_tolerance", [](W w) { return contactd_wheel_set_tolerance(w, CONTACTD_FORCE, 0.1, 1); }},
        {"contactd_wheel_set_position", [](W w) { return contactd_wheel_set_position(w, 0.1, 0.1, 0.1, 0.1); }},
        {"contactd_wheel_set_x", [](W w) { return contactd_wheel_set_x(w, 0.1); }},
        {"contactd_wheel_set_pitch_angle", [](W w) { return contactd_wheel_set_pitch_angle(w, 0.1); }},
        {"contactd_wheel_set_velocity",
         [](W w) { return contactd_wheel_set_velocity(w, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1); }},
        {"contactd_wheel_set_deviation", [](W w) { return contactd_wheel_set_deviation(w, 0.1, 0.1, 0.1); }},
        {"contactd_wheel_set_deviation_rate", [](W w) { return contactd_wheel_set_deviation_rate(w, 0.1, 0.1, 0.1); }},
        {"contactd_wheel_set_rail_forces", [](W w) { return contactd_wheel_set_rail_forces(w, 0.1, 0.1); }},
        {"contactd_wheel_set_roller_pitch", [](W w) { return contactd_wheel_set_roller_pitch(w, 0.1); }},
        {"contactd_wheel_set_Fz", [](W w) { return contactd_wheel_set_Fz(w, 0.1); }},
        {"contactd_wheel_set_Fx", [](W w) { return contactd_wheel_set_Fx(w, 0.1); }},
        {"contactd_wheel_clear_forces", [](W w) { return contactd_wheel_clear_forces(w); }},
        {"contactd_wheel_want", [](W w) { return contactd_wheel_want(w, CONTACTD_PRESSURE, 1); }},
        {"contactd_wheel_want_derivatives", [](W w) { return contactd_wheel_want_derivatives(w, 1); }},
        {"contactd_wheel_get_motion", [&a](W w) { return contactd_wheel_get_motion(w, a.out, a.out + 1); }},
        {"contactd_wheel_get_roll", [&a](W w) { return contactd_wheel_get_roll(w, a.out); }},
        {"contactd_wheel_get_rail_shift", [&a](W w) { return contactd_wheel_get_rail_shift(w, a.out, a.out + 1); }},
        {"contactd_wheel_get_clearance", [&a](W w) { return contactd_wheel_get_clearance(w, a.out); }},
        {"contactd_wheel_get_forces", [&a](W w) { return contactd_wheel_get_forces(w, CONTACTD_IN_RAIL, a.out); }},
        {"contactd_wheel_get_derivative",
         [&a](W w) { return contactd_wheel_get_derivative(w, CONTACTD_BY_POSITION_Y, a.out); }},
        {"contactd_wheel_get_converged", [&a](W w) { return contactd_wheel_get_converged(w, a.number); }},
        {"contactd_wheel_get_evidence",
         [&a](W w) { return contactd_wheel_get_evidence(w, CONTACTD_FORCE, a.number, a.out, a.number + 1); }},
        {"contactd_wheel_get_warnings", [&a](W w) { return contactd_wheel_get_warnings(w, a.number); }},
        {"contactd_wheel_get_warning", [&a](W w) { return contactd_wheel_get_warning(w, 0, a.text, 8); }},
        {"contactd_wheel_get_patches", [&a](W w) { return contactd_wheel_get_patches(w, a.number); }},
        {"contactd_wheel_get_place",
         [&a](W w) { return contactd_wheel_get_place(w, 0, a.out, a.out + 1, a.out + 2, a.out + 3); }},
        {"contactd_wheel_get_grid",
         [&a](W w) {
             return contactd_wheel_get_grid(w, 0, a.number, a.number + 1, a.out, a.out + 1, a.out + 2, a.out + 3);
         }},
        {"contactd_wheel_get_creepages",
         [&a](W w) { return contactd_wheel_get_creepages(w, 0, a.out, a.out + 1, a.out + 2, a.out + 3); }},
        {"contactd_wheel_get_radii",
         [&a](W w) { return contactd_wheel_get_radii(w, 0, a.out, a.out + 1, a.out + 2, a.out + 3); }},
        {"contactd_wheel_get_contact_forces",
         [&a](W w) { return contactd_wheel_get_contact_forces(w, 0, a.out, a.out + 1, a.out + 2, a.out + 3); }},
        {"contactd_wheel_get_patch_forces",
         [&a](W w) { return contactd_wheel_get_patch_forces(w, 0, CONTACTD_IN_RAIL, a.out); }},
        {"contactd_wheel_get_pressure", [&a](W w) { return contactd_wheel_get_pressure(w, 0, a.out, a.out + 1); }},
        {"contactd_wheel_get_frictional_power", [&a](W w) { return contactd_wheel_get_frictional_power(w, 0, a.out); }},
        {"contactd_wheel_get_areas", [&a](W w) { return contactd_wheel_get_areas(w, 0, a.out, a.out + 1, a.out + 2); }},
        {"contactd_wheel_get_counts",
         [&a](W w) { return contactd_wheel_get_counts(w, 0, a.number, a.number + 1, a.number + 2, a.number + 3); }},
        {"contactd_wheel_get_array", [&a](W w) { return contactd_wheel_get_array(w, 0, CONTACTD_PRESSURE, a.out, 4); }},
        {"contactd_wheel_get_division", [&a](W w) { return contactd_wheel_get_division(w, 0, a.number, 4); }},
    };
}

/// A wheel that is given back.
class WheelHandle {
   public:
    explicit WheelHandle(contactd_connection* place) { require_ok(contactd_wheel_new(place, &handle_), place); }
    ~WheelHandle() { contactd_wheel_free(handle_); }
    WheelHandle(const WheelHandle&) = delete;
    WheelHandle& operator=(const WheelHandle&) = delete;
    operator contactd_wheel*() const { return handle_; }

   private:
    contactd_wheel* handle_ = nullptr;
};
