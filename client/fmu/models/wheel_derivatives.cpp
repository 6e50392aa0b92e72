// How the forces on the rail follow the inputs of a wheel.
#include <limits>

#include "variables/wheel_variables.hpp"
#include "wheel_model.hpp"

namespace contactd::fmu {
namespace {

consteval std::size_t at(std::string_view name) {
    return reference_of(wheel_variables, name);
}

/// In the order of contactd_wheel_get_forces; of CONTACTD_BY_POSITION_... and CONTACTD_BY_VELOCITY_..., and the force.
const DerivativePlaces places{
    {at("Fx"), at("Fy"), at("Fz"), at("Mx"), at("My"), at("Mz")},
    {at("position.y"), at("position.z"), at("position.roll"), at("position.yaw"), at("velocity.x"), at("velocity.y"),
     at("velocity.z"), at("velocity.roll"), at("velocity.yaw"), at("velocity.pitch"), at("load.Fz")},
};
constexpr std::size_t motions = CONTACTD_BY_VELOCITY_PITCH + 1, columns = motions + 1, Fz = 2;

/// contactd.h holds the height. Where the force is held in its place the height follows, by dz = (dFz - Fz_q dq)/Fz_z,
/// and an estimate of it is of no influence.
void hold_force(std::vector<double>& all) {
    const std::vector<double> held(all.begin() + Fz * columns, all.begin() + (Fz + 1) * columns);
    const double stiffness = held[CONTACTD_BY_POSITION_Z];
    for (std::size_t row = 0; row < all.size(); row += columns) {
        const double by_force = all[row + CONTACTD_BY_POSITION_Z] / stiffness;
        for (std::size_t by = 0; by < motions; ++by) all[row + by] -= by_force * held[by];
        all[row + CONTACTD_BY_POSITION_Z] = 0;
        all[row + motions] = by_force;
    }
}

}  // namespace

const DerivativePlaces& WheelModel::derivative_places() const {
    return places;
}

std::vector<double> WheelModel::derivatives() {
    contactd_wheel* w = wheel_.get();
    if (solved_.empty()) throw Failure(Status::discard, "There are no derivatives before a step; make one first.");
    if (solved_[at("coordinates")] != 0)
        throw Failure(Status::discard, "There are derivatives in track coordinates only; set coordinates to track.");
    if (solved_[at("prescribe_Fx")] != 0)
        throw Failure(Status::discard, "There are no derivatives where the longitudinal force is prescribed.");
    if (!has_derivatives_) {
        Values values(wheel_variables);
        values.numbers = solved_;
        check(contactd_wheel_want_derivatives(w, 1), w);
        try {
            say(values);
            check(contactd_wheel_solve(w), w);
        } catch (...) {
            if (!wants_derivatives_) contactd_wheel_want_derivatives(w, 0);  // steps go on without
            throw;
        }
        has_derivatives_ = wants_derivatives_ = true;
    }
    std::vector<double> all(places.of.size() * columns, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t by = 0; by < motions; ++by) {
        double forces[6];
        if (!found(contactd_wheel_get_derivative(w, static_cast<std::int32_t>(by), forces), w)) continue;
        for (std::size_t of = 0; of < places.of.size(); ++of) all[of * columns + by] = forces[of];
    }
    for (std::size_t of = 0; of < places.of.size(); ++of) all[of * columns + motions] = 0;
    if (solved_[at("vertical")] == 0) hold_force(all);
    return all;
}

}  // namespace contactd::fmu
