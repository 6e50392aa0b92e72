#include "wheel_model.hpp"

#include <algorithm>

#include "friction_laws.hpp"
#include "set_up.hpp"
#include "variables/wheel_variables.hpp"

namespace contactd::fmu {
namespace {

consteval std::size_t at(std::string_view name) {
    return reference_of(wheel_variables, name);
}

constexpr std::size_t forces_reported[] = {at("Fx"), at("Fy"), at("Fz"), at("Mx"), at("My"), at("Mz")};

}  // namespace

void WheelModel::start(const Values& values, const Carried& from) {
    if (!wheel_) {
        ConnectionHandle connection = opened(values, tell_);
        contactd_wheel* made = nullptr;
        check(contactd_wheel_new(connection.get(), &made), connection.get());
        WheelHandle wheel(made);
        set_up(made, values, resources_);
        // A wheel has no start, so there was no request yet.
        check(contactd_ping(connection.get()), connection.get());
        connection_ = std::move(connection);
        wheel_ = std::move(wheel);
    }
    solved_ = from.solved;
    has_derivatives_ = false;
}

/// Solves at the initial position, because the initialization has enough time.
void WheelModel::solve_start(Values& values) {
    contactd_wheel* w = wheel_.get();
    check(contactd_wheel_set_timeout(w, values[at("limits.start")]), w);
    const bool converged = solved(values);
    check(contactd_wheel_set_timeout(w, values[at("limits.step")]), w);
    if (!converged)
        tell_(Status::warning,
              "The outputs before the first step did not converge: they are estimates. " + quality_flags(values));
}

void WheelModel::step(Values& values, double) {
    has_derivatives_ = false;  // those of the handle may be from a discarded solve
    const std::vector<double> asked = values.numbers;
    if (!solved(values) && !values.is(at("accept_unconverged")))
        throw Failure(Status::discard, "The step did not converge, and is discarded. " + quality_flags(values) +
                                           " Try another position or force, other tolerances, or accept_unconverged.");
    solved_ = asked;
    has_derivatives_ = requests_derivatives_;
}

bool WheelModel::solved(Values& values) {
    say(values);
    check(contactd_step_again(wheel_.get()), wheel_.get());  // without estimates, so that restored states are exact
    read(values);
    return values.is(at("converged"));
}

std::string WheelModel::quality_flags(const Values& values) const {
    std::string text = "Fz is " + std::to_string(values[at("Fz")]) + " N";
    if (values.whole(at("vertical")) == 0) text += " of " + std::to_string(values[at("load.Fz")]) + " N";
    text += ".";
    contactd_wheel* w = wheel_.get();
    for (int k = 0; k < read_field(w, "warnings"); ++k) {
        char warning[1000] = {};
        const std::string path = "warnings[" + std::to_string(k) + "]";
        if (contactd_get_word(w, path.c_str(), warning, sizeof warning) == CONTACTD_OK)
            text += std::string(" ") + warning;
    }
    return text;
}

void WheelModel::say(const Values& v) {
    contactd_wheel* w = wheel_.get();
    const auto set = [&](const char* path, double value) { set_field(w, path, value); };
    const auto clear = [&](const char* path) { check(contactd_clear(w, path), w); };
    set_fields(w, v, Role::input);
    v.whole(at("vertical")) == 0 ? set("state.Fz", v[at("load.Fz")]) : clear("state.Fz");
    v.is(at("prescribe_Fx")) ? set("state.Fx", v[at("load.Fx")]) : clear("state.Fx");
    const NamedValues named(w, "setup.", wheel_variables, v);
    set_temperature(named);
    if (v.is(at("friction.none"))) return clear("setup.friction");
    if (const std::int32_t angles = v.whole(at("friction.angles"));
        angles != 0)  // each angle is beside its coefficient
        check(contactd_set_array(w, "setup.friction.mu", &v.numbers[at("friction.angle[1]")], 2 * angles), w);
    const bool falls = v.whole(at("friction.kinetic.law")) != 0;
    set_friction_laws(named, falls);
    if (!falls) return;
    const std::string law(keyword_of(wheel_variables[at("friction.kinetic.law")], v[at("friction.kinetic.law")]));
    check(contactd_set_word(w, "setup.friction.kinetic.law", law.c_str()), w);
    set("setup.friction.kinetic.mu", v[at("friction.kinetic.mu")]);
    set("setup.friction.kinetic.slip_velocity", v[at("friction.kinetic.slip_velocity")]);
}

void WheelModel::read(Values& values) {
    contactd_wheel* w = wheel_.get();
    const Variable& coordinates = wheel_variables[at("coordinates")];
    const std::string path = "forces." + std::string(keyword_of(coordinates, values[at("coordinates")]));
    double forces[6] = {};
    check(contactd_get_array(w, path.c_str(), forces, 6), w);
    for (std::size_t part = 0; part < 6; ++part) values[forces_reported[part]] = forces[part];
    read_fields(w, values);
    read_patches(values);
}

void WheelModel::read_patches(Values& values) {
    contactd_wheel* w = wheel_.get();
    constexpr std::size_t first = at("patch[1].x");
    static constexpr struct {
        std::size_t at;
        const char* path;
        bool is_largest;
    } of_patches[] = {
        {at("pmax"), "solution.pmax", true},
        {at("area.contact"), "solution.area.contact", false},
        {at("area.adhesion"), "solution.area.adhesion", false},
        {at("area.slip"), "solution.area.slip", false},
        {at("power"), "solution.frictional_power", false},
        {at("temperature.largest"), "solution.temperature.largest", true},
        {at("temperature.rise"), "solution.temperature.rise", true},
        {at("temperature.heat_upper"), "solution.temperature.heat_upper", false},
        {at("temperature.heat_lower"), "solution.temperature.heat_lower", false},
    };
    for (const auto& output : of_patches) values[output.at] = 0;
    std::fill(values.numbers.begin() + first, values.numbers.end(), 0);
    for (int patch = 0; patch < values.whole(at("patches")); ++patch) {
        const std::string path = "patches[" + std::to_string(patch) + "].";
        for (const auto& output : of_patches) {
            const double part = read_field(w, path + output.path);
            double& whole = values[output.at];
            whole = patch == 0 ? part : output.is_largest ? std::max(whole, part) : whole + part;
        }
        if (patch >= patches_reported) continue;
        for (std::size_t part = 0; part < detail::patch_values; ++part)
            values[first + static_cast<std::size_t>(patch) * detail::patch_values + part] =
                read_field(w, path + std::string(detail::patch_parts[part].path));
    }
}

void WheelModel::cancel() {
    if (wheel_) contactd_wheel_cancel(wheel_.get());
}

}  // namespace contactd::fmu
