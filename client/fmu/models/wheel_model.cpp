#include "wheel_model.hpp"

#include <algorithm>

#include "variables/wheel_variables.hpp"
#include "wheel_set_up.hpp"

namespace contactd::fmu {
namespace {

consteval std::size_t at(std::string_view name) {
    return reference_of(wheel_variables, name);
}

constexpr std::size_t forces_told[] = {at("Fx"), at("Fy"), at("Fz"), at("Mx"), at("My"), at("Mz")};

}  // namespace

void WheelModel::start(const Values& values, const Carried& from) {
    if (!wheel_) {
        ConnectionHandle connection = opened(values, tell_);
        contactd_wheel* made = nullptr;
        check(contactd_wheel_new(connection.get(), &made), connection.get());
        WheelHandle wheel(made);
        set_up(made, values, resources_);
        // A wheel has nothing to start, and so nobody has been asked yet.
        check(contactd_ping(connection.get()), connection.get());
        connection_ = std::move(connection);
        wheel_ = std::move(wheel);
    }
    solved_ = from.solved;
    has_derivatives_ = false;
}

/// In the position of the start, which the initialization has time for.
void WheelModel::solve_start(Values& values) {
    contactd_wheel* w = wheel_.get();
    check(contactd_wheel_set_timeout(w, values[at("limits.start")]), w);
    const bool converged = solved(values);
    check(contactd_wheel_set_timeout(w, values[at("limits.step")]), w);
    if (!converged)
        tell_(Status::warning,
              "The outputs before the first step did not converge: they are estimates. " + doubts(values));
}

void WheelModel::step(Values& values, double) {
    has_derivatives_ = false;  // those that the handle has are of a solve that may be discarded
    const std::vector<double> asked = values.numbers;
    if (!solved(values) && !values.is(at("accept_unconverged")))
        throw Failure(Status::discard, "The step did not converge, and is discarded. " + doubts(values) +
                                           " Try another position or force, other tolerances, or accept_unconverged.");
    solved_ = asked;
    has_derivatives_ = wants_derivatives_;
}

bool WheelModel::solved(Values& values) {
    say(values);
    check(contactd_wheel_solve(wheel_.get()), wheel_.get());
    read(values);
    return values.is(at("converged"));
}

std::string WheelModel::doubts(const Values& values) const {
    std::string text = "Fz is " + std::to_string(values[at("Fz")]) + " N";
    if (values.whole(at("vertical")) == 0) text += " of " + std::to_string(values[at("load.Fz")]) + " N";
    text += ".";
    contactd_wheel* w = wheel_.get();
    std::int32_t warnings = 0;
    check(contactd_wheel_get_warnings(w, &warnings), w);
    for (std::int32_t k = 0; k < warnings; ++k) {
        char warning[1000] = {};
        if (contactd_wheel_get_warning(w, k, warning, sizeof warning) == CONTACTD_OK)
            text += std::string(" ") + warning;
    }
    return text;
}

void WheelModel::say(const Values& v) {
    contactd_wheel* w = wheel_.get();
    check(contactd_wheel_set_position(w, v[at("position.y")], v[at("position.z")], v[at("position.roll")],
                                      v[at("position.yaw")]),
          w);
    check(contactd_wheel_set_x(w, v[at("position.x")]), w);
    check(contactd_wheel_set_velocity(w, v[at("velocity.x")], v[at("velocity.y")], v[at("velocity.z")],
                                      v[at("velocity.roll")], v[at("velocity.yaw")], v[at("velocity.pitch")]),
          w);
    check(contactd_wheel_set_deviation(w, v[at("deviation.y")], v[at("deviation.z")], v[at("deviation.roll")]), w);
    check(contactd_wheel_set_deviation_rate(w, v[at("deviation_rate.y")], v[at("deviation_rate.z")],
                                            v[at("deviation_rate.roll")]),
          w);
    check(contactd_wheel_set_roller_pitch(w, v[at("roller.pitch")]), w);
    set_fields(w, v, Role::input);
    check(contactd_wheel_clear_forces(w), w);
    if (v.whole(at("vertical")) == 0) check(contactd_wheel_set_Fz(w, v[at("load.Fz")]), w);
    if (v.is(at("prescribe_Fx"))) check(contactd_wheel_set_Fx(w, v[at("load.Fx")]), w);
    if (v.is(at("friction.none"))) return check(contactd_wheel_set_frictionless(w), w);
    check(contactd_wheel_set_mu(w, v[at("friction.mu")]), w);
    if (const int law = v.whole(at("friction.kinetic.law")); law > 0)
        check(contactd_wheel_set_kinetic(w, law - 1, v[at("friction.kinetic.mu")],
                                         v[at("friction.kinetic.slip_velocity")]),
              w);
}

void WheelModel::read(Values& values) {
    contactd_wheel* w = wheel_.get();
    double forces[6] = {};
    check(contactd_wheel_get_forces(w, values.whole(at("coordinates")), forces), w);
    for (std::size_t part = 0; part < 6; ++part) values[forces_told[part]] = forces[part];
    check(contactd_wheel_get_motion(w, &values[at("z")], &values[at("pitch_rate")]), w);
    if (!found(contactd_wheel_get_clearance(w, &values[at("clearance")]), w)) values[at("clearance")] = 0;
    std::int32_t converged = 0;
    check(contactd_wheel_get_converged(w, &converged), w);
    values[at("converged")] = converged;
    read_fields(w, values);
    read_patches(values);
}

void WheelModel::read_patches(Values& values) {
    contactd_wheel* w = wheel_.get();
    std::int32_t patches = 0;
    check(contactd_wheel_get_patches(w, &patches), w);
    constexpr std::size_t first = at("patch[1].x");
    constexpr std::size_t sums[] = {at("pmax"), at("area.contact"), at("area.adhesion"), at("area.slip"), at("power")};
    for (const std::size_t sum : sums) values[sum] = 0;
    std::fill(values.numbers.begin() + first, values.numbers.end(), 0);
    for (std::int32_t patch = 0; patch < patches; ++patch) {
        double place[4], forces[4], approach, pmax, area[3], creepages[3], velocity, power = 0;
        check(contactd_wheel_get_place(w, patch, place, place + 1, place + 2, place + 3), w);
        check(contactd_wheel_get_contact_forces(w, patch, forces, forces + 1, forces + 2, forces + 3), w);
        check(contactd_wheel_get_pressure(w, patch, &approach, &pmax), w);
        check(contactd_wheel_get_areas(w, patch, area, area + 1, area + 2), w);
        check(contactd_wheel_get_creepages(w, patch, creepages, creepages + 1, creepages + 2, &velocity), w);
        if (!found(contactd_wheel_get_frictional_power(w, patch, &power), w)) power = 0;
        values[at("pmax")] = std::max(values[at("pmax")], pmax);
        values[at("area.contact")] += area[0];
        values[at("area.adhesion")] += area[1];
        values[at("area.slip")] += area[2];
        values[at("power")] += power;
        if (patch >= patches_told) continue;
        // In the order of detail::patch_parts.
        const double told[] = {place[0],  place[1], place[2], place[3],     forces[0],    forces[1],    forces[2],
                               forces[3], pmax,     area[0],  creepages[0], creepages[1], creepages[2], power};
        static_assert(std::size(told) == detail::patch_values);
        std::copy(std::begin(told), std::end(told),
                  values.numbers.begin() + static_cast<std::ptrdiff_t>(first + patch * detail::patch_values));
    }
    values[at("patches")] = patches;
}

void WheelModel::cancel() {
    if (wheel_) contactd_wheel_cancel(wheel_.get());
}

}  // namespace contactd::fmu
