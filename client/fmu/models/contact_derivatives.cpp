// Computes derivatives of the forces of a contact with respect to its inputs.
#include <limits>
#include <string>

#include "contact_model.hpp"
#include "variables/contact_variables.hpp"

namespace contactd::fmu {
namespace {

consteval std::size_t at(std::string_view name) {
    return reference_of(contact_variables, name);
}

/// Lists the answers, and the inputs named in `rolling`, `sliding`, `load` and "mu" below.
const DerivativePlaces places{
    {at("Fx"), at("Fy"), at("Mz"), at("Fn"), at("approach")},
    {at("motion.xi"), at("motion.eta"), at("motion.phi"), at("motion.shift_x"), at("motion.shift_y"),
     at("motion.shift_turn"), at("load.Fn"), at("load.approach"), at("friction.mu")},
};

constexpr const char* answers[] = {"Fx", "Fy", "Mz", "Fn", "approach"};
constexpr const char *rolling[] = {"xi", "eta", "phi"}, *sliding[] = {"rigid_shift.x", "rigid_shift.y", "rotation"};
constexpr double none = std::numeric_limits<double>::quiet_NaN();

}  // namespace

const DerivativePlaces& ContactModel::derivative_places() const {
    return places;
}

std::vector<double> ContactModel::derivatives() {
    contactd_contact* c = contact_.get();
    if (force_is_prescribed_)
        throw Failure(Status::discard, "There are no derivatives where a force along x or y is prescribed.");
    if (!requests_derivatives_) {
        set_field(c, "derivatives", 1);
        try {
            step_again("derivatives");
        } catch (...) {
            contactd_set(c, "derivatives", 0);  // steps continue without
            throw;
        }
        requests_derivatives_ = true;
    }
    // A prescribed quantity depends only on itself.
    const std::string prescribed = by_force_ ? "Fn" : "approach";
    const auto value = [&](const std::string& of, const std::string& by) -> double {
        if (of == prescribed) return by == prescribed ? 1 : 0;
        double derivative = none;
        return found(contactd_get(c, ("derivatives." + of + "." + by).c_str(), &derivative), c) ? derivative : none;
    };
    std::vector<double> all;
    for (const char* of : answers) {
        for (const char* by : rolling) all.push_back(shifts_ ? 0 : value(of, by));
        // A shift is a velocity over the step.
        for (const char* by : sliding) all.push_back(shifts_ ? value(of, by) * step_size_ : 0);
        const double by_load = value(of, prescribed);
        all.push_back(by_force_ ? by_load : 0);
        all.push_back(by_force_ ? 0 : by_load);
        all.push_back(value(of, "mu"));
    }
    return all;
}

}  // namespace contactd::fmu
