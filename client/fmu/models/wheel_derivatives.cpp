// Computes derivatives of the forces on the rail with respect to the inputs of a wheel.
#include <iterator>
#include <limits>
#include <string>
#include <string_view>

#include "variables/wheel_variables.hpp"
#include "wheel_model.hpp"

namespace contactd::fmu {
namespace {

consteval std::size_t at(std::string_view name) {
    return reference_of(wheel_variables, name);
}

/// Lists the outputs in the order of a wrench, and the inputs in that of `motions`, with the force.
const DerivativePlaces places{
    {at("Fx"), at("Fy"), at("Fz"), at("Mx"), at("My"), at("Mz")},
    {at("position.y"), at("position.z"), at("position.roll"), at("position.yaw"), at("velocity.x"), at("velocity.y"),
     at("velocity.z"), at("velocity.roll"), at("velocity.yaw"), at("velocity.pitch"), at("load.Fz")},
};
constexpr std::string_view motions[] = {"position.y", "position.z", "position.roll", "position.yaw", "velocity.x",
                                        "velocity.y", "velocity.z", "velocity.roll", "velocity.yaw", "velocity.pitch"};
constexpr std::size_t by_height = 1, by_force = std::size(motions), columns = by_force + 1, Fz = 2;

/// contactd.h keeps the height constant. For a prescribed force the height follows, by dz = (dFz - Fz_q dq)/Fz_z, and
/// its estimate has no effect.
void hold_force(std::vector<double>& all) {
    const std::vector<double> held(all.begin() + Fz * columns, all.begin() + (Fz + 1) * columns);
    const double stiffness = held[by_height];
    for (std::size_t row = 0; row < all.size(); row += columns) {
        const double per_force = all[row + by_height] / stiffness;
        for (std::size_t by = 0; by < by_force; ++by) all[row + by] -= per_force * held[by];
        all[row + by_height] = 0;
        all[row + by_force] = per_force;
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
        check(contactd_set(w, "state.derivatives", 1), w);
        try {
            say(values);
            check(contactd_step_again(w), w);
        } catch (...) {
            if (!requests_derivatives_) contactd_set(w, "state.derivatives", 0);  // steps continue without
            throw;
        }
        has_derivatives_ = requests_derivatives_ = true;
    }
    std::vector<double> all(places.of.size() * columns, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t by = 0; by < by_force; ++by) {
        double forces[6];
        const std::string path = "derivatives." + std::string(motions[by]);
        if (!found(contactd_get_array(w, path.c_str(), forces, 6), w)) continue;
        for (std::size_t of = 0; of < places.of.size(); ++of) all[of * columns + by] = forces[of];
    }
    for (std::size_t of = 0; of < places.of.size(); ++of) all[of * columns + by_force] = 0;
    if (solved_[at("vertical")] == 0) hold_force(all);
    return all;
}

}  // namespace contactd::fmu
