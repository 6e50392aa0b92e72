#include "contact_model.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "friction_laws.hpp"
#include "set_up.hpp"
#include "variables/contact_variables.hpp"

namespace contactd::fmu {
namespace {

consteval std::size_t at(std::string_view name) {
    return reference_of(contact_variables, name);
}

enum { steady, transient, shift };  // enumerations::motion
enum { full };                      // enumerations::model

}  // namespace

void ContactModel::start(const Values& values, const Carried& from) {
    if (!connection_) connection_ = opened(values, tell_);
    ContactHandle contact = made(values);
    contactd_contact* c = contact.get();
    const bool goes_on = !from.history.front().empty();
    has_history_ = values.whole(at("model")) == full;
    const bool rubs = has_history_ && !values.is(at("friction.none")) && values.whole(at("motion.kind")) != steady;
    const auto is_zero = [&](std::string_view name) {
        return !name.empty() && !values.is(reference_in(contact_variables, name));
    };
    for (std::size_t i = 0; i < history_arrays.size(); ++i) {
        const auto& needs = history_arrays[i].needs;
        carries_[i] = needs[0].empty() || (rubs && std::ranges::none_of(needs, is_zero));
    }
    for (std::size_t i = 0; goes_on && i < history_arrays.size(); ++i) {
        const std::vector<double>& carried = from.history[i];
        const std::string path = std::string("previous.") + history_arrays[i].name;
        if (carries_[i])
            check(contactd_set_array(c, path.c_str(), carried.data(), static_cast<std::int32_t>(carried.size())), c);
    }
    set_load(c, values, values.whole(at("motion.kind")), {});
    for (std::size_t i = 0; i < history_arrays.size(); ++i)
        if (carries_[i]) check(contactd_want(c, history_arrays[i].name, goes_on), c);
    check(contactd_start(c), c);
    contact_ = std::move(contact);
    from_ = from;
    elements_ = static_cast<std::size_t>(values[at("grid.nx")]) * static_cast<std::size_t>(values[at("grid.ny")]);
    requests_arrays_ = goes_on;
    requests_derivatives_ = made_ = failed_ = false;
    by_force_ = values.whole(at("load.kind")) == 0;
    shifts_ = values.whole(at("motion.kind")) == shift;
    force_is_prescribed_ = values.is(at("force.prescribe_x")) || values.is(at("force.prescribe_y"));
}

ContactHandle ContactModel::made(const Values& values) const {
    contactd_contact* made = nullptr;
    check(contactd_new(connection_.get(), &made), connection_.get());
    ContactHandle contact(made);
    set_up(made, values);
    set_temperature({made, "", contact_variables, values});
    return contact;
}

/// Uses a separate contact, which does not affect the first step: steady rolling unchanged, and motions with history
/// pressed together without motion. A model without history only has the former.
void ContactModel::solve_start(Values& values) {
    const ContactHandle contact = made(values);
    contactd_contact* c = contact.get();
    set_field(c, "accept_unconverged", 1);
    check(contactd_set_step_timeout(c, values[at("limits.start")]), c);
    const int kind = values.whole(at("motion.kind"));
    const bool rolls_on = kind == transient;
    set_load(c, values, rolls_on && has_history_ ? shift : kind, {});
    check(contactd_start(c), c);
    check(contactd_step(c), c);
    read(c, values);
    if (rolls_on) values[at("xi")] = values[at("motion.xi")], values[at("eta")] = values[at("motion.eta")];
    if (!values.is(at("converged")))
        tell_(Status::warning, "The outputs before the first step did not converge: they are estimates.");
}

void ContactModel::step(Values& values, double size) {
    failed_ = true;
    set_load(contact_.get(), values, values.whole(at("motion.kind")), size);
    check(contactd_step(contact_.get()), contact_.get());
    failed_ = false;
    made_ = true;
    step_size_ = size;
    read(contact_.get(), values);
}

void ContactModel::set_load(contactd_contact* c, const Values& values, int motion, std::optional<double> size) {
    const bool by_radii = values.whole(at("gap.kind")) == 0, by_force = values.whole(at("load.kind")) == 0;
    set_fields(c, values, by_radii ? "gap.paraboloid." : "gap.semi_axes.");
    set_fields(c, values, by_force ? "Fn" : "approach");
    if (values.is(at("friction.none"))) return;
    set_field(c, "friction.mu", values[at("friction.mu")]);
    constexpr std::size_t law = at("friction.kinetic.law");
    if (values.is(law)) {
        set_keyword(c, "friction.kinetic.law", keyword_of(contact_variables[law], values[law]));
        set_field(c, "friction.kinetic.mu", values[at("friction.kinetic.mu")]);
        set_field(c, "friction.kinetic.slip_velocity", values[at("friction.kinetic.slip_velocity")]);
    }
    set_friction_laws({c, "", contact_variables, values}, values.is(law));
    if (motion == shift)
        set_shift(c, values, size);
    else
        set_rolling(c, values, motion == steady, size);
    const std::string force = motion == shift ? "friction.force" : "friction.rolling.force";
    if (values.is(at("force.prescribe_x"))) set_field(c, force + ".Fx", values[at("force.x")]);
    if (values.is(at("force.prescribe_y"))) set_field(c, force + ".Fy", values[at("force.y")]);
}

void ContactModel::set_shift(contactd_contact* c, const Values& values, std::optional<double> size) {
    const auto over_step = [&](std::size_t velocity) { return size ? values[velocity] * *size : 0; };
    set_field(c, "friction.rigid_shift.x", over_step(at("motion.shift_x")));
    set_field(c, "friction.rigid_shift.y", over_step(at("motion.shift_y")));
    set_field(c, "friction.rotation", over_step(at("motion.shift_turn")));
    set_field(c, "friction.duration", size.value_or(1));
}

void ContactModel::set_rolling(contactd_contact* c, const Values& values, bool is_steady, std::optional<double> size) {
    const double velocity = values[at("motion.velocity")];
    set_keyword(c, "friction.rolling.kind", is_steady ? "steady" : "transient");
    set_fields(c, values, "friction.rolling.");
    double dq = 0;
    if (!is_steady && size) {
        // The bodies roll for the duration of the step, in rolling steps of at most one element.
        constexpr double most = 10'000, nearly = 1e-9;
        const double distance = velocity * *size, steps = std::ceil(distance / values[at("grid.dx")] - nearly);
        if (!(distance > 0) || steps > most)
            throw Failure("motion.velocity times the step is " + std::to_string(distance) +
                          " mm; transient rolling takes more than 0, and at most 10000 elements a step.");
        set_field(c, "friction.rolling.steps", std::fmax(steps, 1));
        dq = distance / std::fmax(steps, 1);
    }
    set_field(c, "friction.rolling.dq", dq);
}

void ContactModel::read(contactd_contact* c, Values& values) {
    for (std::size_t k = 0; k < contact_variables.size(); ++k)
        if (const Variable& variable = contact_variables[k]; variable.role == Role::output && !variable.path.empty())
            values[k] = read_field(c, std::string(variable.path));
    for (const char* temperature : {"largest", "rise", "heat_upper", "heat_lower"}) {
        const std::string name = std::string("temperature.") + temperature;
        values[reference_in(contact_variables, name)] = read_field(c, name);
    }
    values[at("patches")] = values[at("area.contact")] > 0;
}

void ContactModel::step_again(const char* what) {
    if (failed_ || !made_)
        throw Failure(Status::discard, std::string("There are no ") + what +
                                           (failed_ ? " after a step that failed" : " before a step") +
                                           "; make one first.");
    check(contactd_step_again(contact_.get()), contact_.get());
}

std::vector<double> ContactModel::array(const char* which) {
    std::vector<double> values(elements_);
    check(contactd_get_array(contact_.get(), which, values.data(), static_cast<std::int32_t>(elements_)),
          contact_.get());
    return values;
}

Carried ContactModel::carried() {
    if (!has_history_ || !made_) return from_;
    if (!requests_arrays_) {
        for (std::size_t i = 0; i < history_arrays.size(); ++i)
            if (carries_[i]) check(contactd_want(contact_.get(), history_arrays[i].name, 1), contact_.get());
        step_again("tractions");
        requests_arrays_ = true;
    }
    Carried carried;
    for (std::size_t i = 0; i < history_arrays.size(); ++i)
        if (carries_[i]) carried.history[i] = array(history_arrays[i].name);
    return carried;
}

void ContactModel::cancel() {
    if (contact_) contactd_cancel(contact_.get());
}

}  // namespace contactd::fmu
