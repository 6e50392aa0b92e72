#include "set_up.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "place.hpp"
#include "slices.hpp"
#include "variables/wheel_variables.hpp"

namespace contactd::fmu {
namespace {

consteval std::size_t at(std::string_view name) {
    return reference_of(wheel_variables, name);
}

/// Rails by name, beside 60E1, which is the shape rail_60e1.
constexpr std::array<std::string_view, 5> named_rails{"UIC60", "49E5", "54E1", "54E3", "60E2"};

/// Holds positions of a body and its profile in the list, and their paths in contactd.h.
struct BodyPlaces {
    std::string_view profile_path, body_path;
    std::size_t profile, radius, slope, from, to, unit, mirror_y, mirror_z, shift_y, shift_z, smoothing, G, nu, rigid;
};
constexpr BodyPlaces wheel{"setup.wheel",         "setup.bodies.lower", at("wheel.profile"), at("wheel.radius"),
                           at("wheel.slope"),     at("wheel.from"),     at("wheel.to"),      at("wheel.unit"),
                           at("wheel.mirror_y"),  at("wheel.mirror_z"), at("wheel.shift_y"), at("wheel.shift_z"),
                           at("wheel.smoothing"), at("wheel.G"),        at("wheel.nu"),      at("wheel.rigid")};
constexpr BodyPlaces rail{"setup.rail",         "setup.bodies.upper", at("rail.profile"), at("rail.radius"),
                          at("rail.slope"),     at("rail.from"),      at("rail.to"),      at("rail.unit"),
                          at("rail.mirror_y"),  at("rail.mirror_z"),  at("rail.shift_y"), at("rail.shift_z"),
                          at("rail.smoothing"), at("rail.G"),         at("rail.nu"),      at("rail.rigid")};

FileReading reading_of(const Values& values, const BodyPlaces& of) {
    return {values[of.unit],    values.is(of.mirror_y), keyword_of(wheel_variables[of.mirror_z], values[of.mirror_z]),
            values[of.shift_y], values[of.shift_z],     values[of.smoothing]};
}

void set_file(contactd_wheel* w, const Values& values, const BodyPlaces& of, const std::filesystem::path& resources) {
    const std::string& name = values.text(of.profile);
    const auto path = file_named(name, resources);
    if (!path)
        throw Failure(std::string(wheel_variables[of.profile].name) + " is \"" + name + "\"; " +
                      (resources / path_of(name)).string() + " is not a file. It must be " +
                      (of.profile == wheel.profile ? "S1002" : "60E1, another rail by name") +
                      ", cone, arc, a path from / on, a URI file:///..., or a file in the FMU's resources.");
    set_profile_file(w, std::string(of.profile_path), *path, reading_of(values, of));
}

void set_profile(contactd_wheel* w, const Values& values, const BodyPlaces& of,
                 const std::filesystem::path& resources) {
    const std::string name = lowercase_name(values.text(of.profile)), profile(of.profile_path),
                      shape = profile + "." + name;
    if (name == "cone" || name == "arc") {
        if (name == "arc") set_field(w, shape + ".radius", values[of.radius]);
        set_field(w, shape + ".slope", values[of.slope]);
        set_field(w, shape + ".ends.from", values[of.from]);
        set_field(w, shape + ".ends.to", values[of.to]);
    } else if (name == "s1002" && of.profile == wheel.profile) {
        set_field(w, profile + ".s1002", 1);
    } else if (name == "60e1" && of.profile == rail.profile) {
        set_field(w, profile + ".rail_60e1.inclination", values[at("rail.inclination")]);
    } else if (const auto named = std::ranges::find(named_rails, name, lowercase_name);
               named != named_rails.end() && of.profile == rail.profile) {
        set_keyword(w, profile + ".standard.name", *named);
        set_field(w, profile + ".standard.inclination", values[at("rail.inclination")]);
    } else {
        set_file(w, values, of, resources);
    }
}

void set_material(contactd_wheel* w, const Values& values, const BodyPlaces& of) {
    const std::string body(of.body_path);
    if (values.is(of.rigid)) return set_field(w, body + ".rigid", 1);
    set_field(w, body + ".G", values[of.G]);
    set_field(w, body + ".nu", values[of.nu]);
}

}  // namespace

void set_fields(contactd_wheel* w, const Values& values, Role role) {
    for (std::size_t at = 0; at < wheel_variables.size(); ++at) {
        const Variable& variable = wheel_variables[at];
        if (variable.path.empty() || variable.role != role || (variable.zero_is_absent && values[at] == 0)) continue;
        const std::string path(variable.path);
        if (variable.enumeration == nullptr)
            set_field(w, path, values[at]);
        else
            set_keyword(w, path, keyword_of(variable, values[at]));
    }
}

void read_fields(contactd_wheel* w, Values& values) {
    for (std::size_t at = 0; at < wheel_variables.size(); ++at) {
        const Variable& variable = wheel_variables[at];
        if (!variable.path.empty() && variable.role == Role::output)
            values[at] = read_field(w, std::string(variable.path));
    }
}

void set_up(contactd_wheel* w, const Values& values, const std::filesystem::path& resources) {
    for (const BodyPlaces& of : {wheel, rail}) {
        set_profile(w, values, of, resources);
        set_material(w, values, of);
    }
    if (const std::string& slices = values.text(at("wheel.slices")); !slices.empty())
        set_slices(w, {"setup.wheel_slices", "angle"}, "wheel.slices", slices, reading_of(values, wheel), resources);
    if (const std::string& slices = values.text(at("rail.slices")); !slices.empty())
        set_slices(w, {"setup.rail_slices", "x"}, "rail.slices", slices, reading_of(values, rail), resources);
    if (const int angles = values.whole(at("friction.angles")); angles < 0 || angles > most_angles)
        throw Failure("friction.angles is " + std::to_string(angles) + "; it must be 0 to " +
                      std::to_string(most_angles) + ".");
    set_fields(w, values, Role::parameter);
    if (values.is(at("track.by_origin"))) {
        set_field(w, "setup.track.rail_origin.y", values[at("track.origin_y")]);
        set_field(w, "setup.track.rail_origin.z", values[at("track.origin_z")]);
    }
    if (const double most = values[at("tolerances.iterations")]; most != 0)
        for (const char* solver : {"normal", "tangential", "outer"})
            set_field(w, std::string("setup.settings.") + solver + ".max_iterations", most);
    check(contactd_wheel_set_timeout(w, values[at("limits.step")]), w);
}

}  // namespace contactd::fmu
