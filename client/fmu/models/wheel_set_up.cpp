#include "wheel_set_up.hpp"

#include <string>
#include <string_view>

#include "place.hpp"
#include "variables/wheel_variables.hpp"

namespace contactd::fmu {
namespace {

consteval std::size_t at(std::string_view name) {
    return reference_of(wheel_variables, name);
}

/// Where the list has what a body is, and its profile.
struct BodyPlaces {
    std::int32_t body;
    std::size_t profile, radius, slope, from, to, smoothing, G, nu, rigid;
};
constexpr BodyPlaces bodies[] = {
    {CONTACTD_WHEEL, at("wheel.profile"), at("wheel.radius"), at("wheel.slope"), at("wheel.from"), at("wheel.to"),
     at("wheel.smoothing"), at("wheel.G"), at("wheel.nu"), at("wheel.rigid")},
    {CONTACTD_RAIL, at("rail.profile"), at("rail.radius"), at("rail.slope"), at("rail.from"), at("rail.to"),
     at("rail.smoothing"), at("rail.G"), at("rail.nu"), at("rail.rigid")},
};

void set_file(contactd_wheel* w, const Values& values, const BodyPlaces& of, const std::filesystem::path& resources) {
    const std::string& name = values.text(of.profile);
    const auto path = file_named(name, resources);
    if (!path)
        throw Failure(std::string(wheel_variables[of.profile].name) + " is \"" + name + "\"; " +
                      (resources / path_of(name)).string() + " is no file. It must be " +
                      (of.body == CONTACTD_WHEEL ? "S1002" : "60E1") +
                      ", cone, arc, a path from / on, a URI file:///..., or a file in the FMU's resources.");
    check(contactd_wheel_set_file(w, of.body, path->c_str(), values[of.smoothing]), w);
}

void set_profile(contactd_wheel* w, const Values& values, const BodyPlaces& of,
                 const std::filesystem::path& resources) {
    const std::string name = word_of(values.text(of.profile));
    if (name == "cone")
        check(contactd_wheel_set_cone(w, of.body, values[of.slope], values[of.from], values[of.to]), w);
    else if (name == "arc")
        check(contactd_wheel_set_arc(w, of.body, values[of.radius], values[of.slope], values[of.from], values[of.to]),
              w);
    else if (name == "s1002" && of.body == CONTACTD_WHEEL)
        check(contactd_wheel_set_s1002(w), w);
    else if (name == "60e1" && of.body == CONTACTD_RAIL)
        check(contactd_wheel_set_rail_60e1(w, values[at("rail.inclination")]), w);
    else
        set_file(w, values, of, resources);
}

void set_track(contactd_wheel* w, const Values& values) {
    check(contactd_wheel_set_track(w, values[at("track.gauge")], values[at("track.gauge_height")],
                                   values[at("track.cant")]),
          w);
    if (values.is(at("track.by_origin")))
        check(contactd_wheel_set_rail_origin(w, values[at("track.origin_y")], values[at("track.origin_z")]), w);
    check(contactd_wheel_set_roller(w, values[at("track.roller_radius")]), w);
    check(
        contactd_wheel_set_wheelset(w, values[at("wheelset.flange_back_distance")],
                                    values[at("wheelset.flange_back_position")], values[at("wheelset.nominal_radius")]),
        w);
}

void set_solvers(contactd_wheel* w, const Values& values) {
    check(contactd_wheel_set_model(w, values.whole(at("model"))), w);
    check(
        contactd_wheel_set_elements(w, values[at("elements.dx")], values[at("elements.dy")], values[at("elements.dq")]),
        w);
    check(contactd_wheel_set_mesh_search(w, values.is(at("mesh_search"))), w);
    check(contactd_wheel_set_conformal(w, values.whole(at("conformal"))), w);
    check(contactd_wheel_set_slip_of_surfaces(w, values.is(at("slip_of_surfaces"))), w);
    const int most = values.whole(at("tolerances.iterations"));
    check(contactd_wheel_set_tolerance(w, CONTACTD_NORMAL, values[at("tolerances.normal")], most ? most : 1000), w);
    check(contactd_wheel_set_tolerance(w, CONTACTD_TANGENTIAL, values[at("tolerances.tangential")], most ? most : 1000),
          w);
    check(contactd_wheel_set_tolerance(w, CONTACTD_OUTER, values[at("tolerances.outer")], most ? most : 100), w);
    check(contactd_wheel_set_tolerance(w, CONTACTD_FORCE, values[at("tolerances.force")], 40), w);
    check(contactd_wheel_set_timeout(w, values[at("limits.step")]), w);
}

}  // namespace

void set_fields(contactd_wheel* w, const Values& values, Role role) {
    for (std::size_t at = 0; at < wheel_variables.size(); ++at) {
        const Variable& variable = wheel_variables[at];
        if (variable.path.empty() || variable.role != role || (variable.zero_is_absent && values[at] == 0)) continue;
        check(contactd_set(w, std::string(variable.path).c_str(), values[at]), w);
    }
}

void read_fields(contactd_wheel* w, Values& values) {
    for (std::size_t at = 0; at < wheel_variables.size(); ++at) {
        const Variable& variable = wheel_variables[at];
        if (variable.path.empty() || variable.role != Role::output) continue;
        if (!found(contactd_get(w, std::string(variable.path).c_str(), &values[at]), w)) values[at] = 0;
    }
}

void set_up(contactd_wheel* w, const Values& values, const std::filesystem::path& resources) {
    check(contactd_wheel_set_side(w, values.whole(at("side"))), w);
    for (const BodyPlaces& of : bodies) {
        set_profile(w, values, of, resources);
        check(values.is(of.rigid) ? contactd_wheel_set_rigid(w, of.body)
                                  : contactd_wheel_set_material(w, of.body, values[of.G], values[of.nu]),
              w);
    }
    set_track(w, values);
    set_solvers(w, values);
    set_fields(w, values, Role::parameter);
}

}  // namespace contactd::fmu
