// How the forces of a contact follow its inputs.
#include <limits>

#include "contact_model.hpp"
#include "variables/contact_variables.hpp"

namespace contactd::fmu {
namespace {

consteval std::size_t at(std::string_view name) {
    return reference_of(contact_variables, name);
}

/// In the order of CONTACTD_OF_..., and of CONTACTD_BY_... twice: rolling, and shifts.
const DerivativePlaces places{
    {at("Fx"), at("Fy"), at("Mz"), at("Fn"), at("approach")},
    {at("motion.xi"), at("motion.eta"), at("motion.phi"), at("motion.shift_x"), at("motion.shift_y"),
     at("motion.shift_turn"), at("load.Fn"), at("load.approach"), at("friction.mu")},
};

constexpr double none = std::numeric_limits<double>::quiet_NaN();

}  // namespace

const DerivativePlaces& ContactModel::derivative_places() const {
    return places;
}

std::vector<double> ContactModel::derivatives() {
    contactd_contact* c = contact_.get();
    if (force_is_prescribed_)
        throw Failure(Status::discard, "There are no derivatives where a force along x or y is prescribed.");
    if (!wants_derivatives_) {
        check(contactd_want_derivatives(c, 1), c);
        try {
            step_again("derivatives");
        } catch (...) {
            contactd_want_derivatives(c, 0);  // steps go on without
            throw;
        }
        wants_derivatives_ = true;
    }
    // What is prescribed is the answer to itself, and follows nothing else.
    const int prescribed = by_force_ ? CONTACTD_OF_FN : CONTACTD_OF_APPROACH;
    const auto value = [&](std::size_t of, std::int32_t by) -> double {
        if (static_cast<int>(of) == prescribed) return by == CONTACTD_BY_LOAD ? 1 : 0;
        double found_one = none;
        return found(contactd_get_derivative(c, static_cast<std::int32_t>(of), by, &found_one), c) ? found_one : none;
    };
    std::vector<double> all;
    for (std::size_t of = 0; of < places.of.size(); ++of) {
        for (const std::int32_t by : {CONTACTD_BY_X, CONTACTD_BY_Y, CONTACTD_BY_TURN})
            all.push_back(shifts_ ? 0 : value(of, by));
        // Of a velocity over the step.
        for (const std::int32_t by : {CONTACTD_BY_X, CONTACTD_BY_Y, CONTACTD_BY_TURN})
            all.push_back(shifts_ ? value(of, by) * step_size_ : 0);
        const double by_load = value(of, CONTACTD_BY_LOAD);
        all.push_back(by_force_ ? by_load : 0);
        all.push_back(by_force_ ? 0 : by_load);
        all.push_back(value(of, CONTACTD_BY_MU));
    }
    return all;
}

}  // namespace contactd::fmu
