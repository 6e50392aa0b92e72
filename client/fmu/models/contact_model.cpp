#include "contact_model.hpp"

#include <cmath>

#include "contact_set_up.hpp"
#include "variables/contact_variables.hpp"

namespace contactd::fmu {
namespace {

consteval std::size_t at(std::string_view name) {
    return reference_of(contact_variables, name);
}

enum { steady, transient, shift };  // motion_words

/// What a step leaves to the next.
constexpr const char* arrays[] = {"pressure", "traction_x", "traction_y"};

}  // namespace

void ContactModel::start(const Values& values, const Carried& from) {
    if (!connection_) connection_ = opened(values, tell_);
    ContactHandle contact = made(values);
    contactd_contact* c = contact.get();
    const bool goes_on = !from.pressure.empty();
    if (goes_on)
        check(contactd_set_previous(c, from.pressure.data(), from.traction_x.data(), from.traction_y.data(),
                                    static_cast<std::int32_t>(from.pressure.size())),
              c);
    say(c, values, {});
    for (const char* array : arrays) check(contactd_want(c, array, goes_on), c);
    check(contactd_start(c), c);
    contact_ = std::move(contact);
    from_ = from;
    elements_ = static_cast<std::size_t>(values[at("grid.nx")]) * static_cast<std::size_t>(values[at("grid.ny")]);
    has_history_ = values.whole(at("model")) == CONTACTD_FULL;
    wants_arrays_ = goes_on;
    wants_derivatives_ = made_ = failed_ = false;
    by_force_ = values.whole(at("load.kind")) == 0;
    shifts_ = values.whole(at("motion.kind")) == shift;
    force_is_prescribed_ = values.is(at("force.prescribe_x")) || values.is(at("force.prescribe_y"));
}

ContactHandle ContactModel::made(const Values& values) const {
    contactd_contact* made = nullptr;
    check(contactd_new(connection_.get(), &made), connection_.get());
    ContactHandle contact(made);
    set_up(made, values);
    return contact;
}

/// By a contact of its own, which leaves nothing to the first step: rolling in its steady state as it is, and what goes
/// on from step to step pressed together and not moved yet. A model without history knows the former only.
void ContactModel::solve_start(Values& values) {
    const ContactHandle contact = made(values);
    contactd_contact* c = contact.get();
    check(contactd_set_accept_unconverged(c, 1), c);
    check(contactd_set_step_timeout(c, values[at("limits.start")]), c);
    say(c, values, {});
    const bool rolls_on = values.whole(at("motion.kind")) == transient;
    if (rolls_on && has_history_ && !values.is(at("friction.none"))) check(contactd_set_shift(c, 0, 0, 0), c);
    check(contactd_start(c), c);
    check(contactd_step(c), c);
    read(c, values);
    if (rolls_on) values[at("xi")] = values[at("motion.xi")], values[at("eta")] = values[at("motion.eta")];
    if (!values.is(at("converged")))
        tell_(Status::warning, "The outputs before the first step did not converge: they are estimates.");
}

void ContactModel::step(Values& values, double size) {
    failed_ = true;
    say(contact_.get(), values, size);
    check(contactd_step(contact_.get()), contact_.get());
    failed_ = false;
    made_ = true;
    step_size_ = size;
    read(contact_.get(), values);
}

void ContactModel::say(contactd_contact* c, const Values& values, std::optional<double> size) {
    check(values.whole(at("gap.kind")) == 0 ? contactd_set_paraboloid(c, values[at("gap.Rx")], values[at("gap.Ry")])
                                            : contactd_set_semi_axes(c, values[at("gap.a")], values[at("gap.b")]),
          c);
    check(values.whole(at("load.kind")) == 0 ? contactd_set_Fn(c, values[at("load.Fn")])
                                             : contactd_set_approach(c, values[at("load.approach")]),
          c);
    if (values.is(at("friction.none"))) return;
    check(contactd_set_mu(c, values[at("friction.mu")]), c);
    if (const int law = values.whole(at("friction.kinetic.law")); law > 0)
        check(contactd_set_kinetic(c, law - 1, values[at("friction.kinetic.mu")],
                                   values[at("friction.kinetic.slip_velocity")]),
              c);
    say_motion(c, values, size);
    if (values.is(at("force.prescribe_x"))) check(contactd_set_Fx(c, values[at("force.x")]), c);
    if (values.is(at("force.prescribe_y"))) check(contactd_set_Fy(c, values[at("force.y")]), c);
}

void ContactModel::say_motion(contactd_contact* c, const Values& values, std::optional<double> size) {
    const int kind = values.whole(at("motion.kind"));
    if (kind == shift) {
        const double seconds = size.value_or(0);
        check(contactd_set_shift(c, values[at("motion.shift_x")] * seconds, values[at("motion.shift_y")] * seconds,
                                 values[at("motion.shift_turn")] * seconds),
              c);
        return check(contactd_set_duration(c, size.value_or(1)), c);
    }
    const double velocity = values[at("motion.velocity")];
    check(contactd_set_rolling(c, kind == steady ? CONTACTD_STEADY : CONTACTD_TRANSIENT, values[at("motion.xi")],
                               values[at("motion.eta")], values[at("motion.phi")]),
          c);
    check(contactd_set_velocity(c, velocity), c);
    double dq = 0;
    if (kind == transient && size) {
        // As far as the step goes, in steps of rolling that are no longer than an element.
        constexpr double most = 10'000, nearly = 1e-9;
        const double distance = velocity * *size, steps = std::ceil(distance / values[at("grid.dx")] - nearly);
        if (!(distance > 0) || steps > most)
            throw Failure("motion.velocity times the step is " + std::to_string(distance) +
                          " mm; transient rolling takes more than 0, and at most 10000 elements a step.");
        check(contactd_set_rolling_steps(c, static_cast<std::int32_t>(std::fmax(steps, 1))), c);
        dq = distance / std::fmax(steps, 1);
    }
    check(contactd_set_direction(c, values[at("motion.chi")], dq), c);
}

void ContactModel::read(contactd_contact* c, Values& values) {
    check(contactd_get_forces(c, &values[at("Fn")], &values[at("Fx")], &values[at("Fy")], &values[at("Mz")]), c);
    check(contactd_get_approach(c, &values[at("approach")]), c);
    check(contactd_get_pmax(c, &values[at("pmax")]), c);
    check(contactd_get_areas(c, &values[at("area.contact")], &values[at("area.adhesion")], &values[at("area.slip")]),
          c);
    double phi = 0;
    if (!found(contactd_get_creepages(c, &values[at("xi")], &values[at("eta")], &phi), c))
        values[at("xi")] = values[at("eta")] = 0;
    if (!found(contactd_get_frictional_power(c, &values[at("power")]), c)) values[at("power")] = 0;
    if (!found(contactd_get_frictional_work(c, &values[at("work")]), c)) values[at("work")] = 0;
    values[at("patches")] = values[at("area.contact")] > 0;
    std::int32_t converged = 0;
    check(contactd_get_converged(c, &converged), c);
    values[at("converged")] = converged;
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
    if (!wants_arrays_) {
        for (const char* which : arrays) check(contactd_want(contact_.get(), which, 1), contact_.get());
        step_again("tractions");
        wants_arrays_ = true;
    }
    return {{}, array(arrays[0]), array(arrays[1]), array(arrays[2])};
}

void ContactModel::cancel() {
    if (contact_) contactd_cancel(contact_.get());
}

}  // namespace contactd::fmu
