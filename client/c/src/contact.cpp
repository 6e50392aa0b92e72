#include "contact.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "results.hpp"

namespace contactd::c {
namespace {

StatusError wrong_order_of(const std::string& sentence) {
    return {StatusCode::failed_precondition, wrong_order, sentence};
}

std::string percent(double fraction) {
    return std::to_string(static_cast<int>(100 * fraction)) + " %";
}

}  // namespace

Contact::Contact(const Connection& connection)
    : CancellableHandle(connection, ContactInputs::roots(), results_of_contacts()) {}

void Contact::require_set_up(const char* what) const {
    if (started())
        throw wrong_order_of(std::string("The contact was started, so its ") + what +
                             " cannot change; create another contact.");
}

void Contact::require_started() const {
    if (!started()) throw wrong_order_of("The contact has not been started; call contactd_start first.");
}

void Contact::start() {
    require_set_up("set-up");
    const SessionSpec spec = inputs.opening();
    controlled([&](Control& control) {
        if (log_)
            control.on_progress = [this](const std::string& stage, double fraction) {
                log_(CONTACTD_LOG_INFO,
                     "Waiting for influence coefficients: " + stage + ", " + percent(fraction) + ".");
            };
        open_ = backend_->open(spec, settings_, control);
    });
    std::set<std::string> of_tables;  // both bodies may have the same warning
    for (const auto* use : {&open_->ics().upper, &open_->ics().lower, &open_->ics().pair})
        if (*use) of_tables.insert((*use)->evidence.warnings.begin(), (*use)->evidence.warnings.end());
    for (const std::string& warning : of_tables) warn(warning);
    inputs.problem.grid = spec.setup.grid;
    inputs.problem.previous = {};  // stored in the contact, so steps need not check it
    inputs.changed = {};
}

void Contact::step(Which which) {
    require_started();
    auto result = std::make_shared<Result>();
    result->fields = inputs.fields;
    StepInput input = inputs.step();
    input.again = which == Which::again;
    result->reply = controlled([&](Control& control) {
        control.timeout = inputs.step_timeout;
        return open_->step(input, control);
    });
    inputs.take_estimates(result->reply.solution.motion);
    result_ = std::move(result);
    for (const std::string& warning : result_->reply.solution.warnings) warn(warning);
}

void Contact::close() {
    if (!open_) return;
    const std::unique_ptr<OpenContact> ended = std::move(open_);
    try {
        controlled([&](Control& control) { ended->close(control); });
    } catch (const StatusError& error) {
        if (error.status().code != StatusCode::not_found) throw;  // otherwise it had already ended
    }
}

std::int32_t Contact::save() {
    require_started();
    std::string name = controlled([&](Control& control) { return open_->save(control); });
    return saved_.add({std::move(name), result_, inputs.problem.motion});
}

void Contact::restore(std::int32_t state) {
    require_started();
    const Saved& back = saved_.at(state);
    controlled([&](Control& control) { open_->restore(back.name, control); });
    result_ = back.result;
    inputs.restore_estimates(back.motion);
}

void Contact::forget(std::int32_t state) {
    require_started();
    const Saved& saved = saved_.at(state);
    controlled([&](Control& control) { open_->forget(saved.name, control); });
    saved_.forget(state);
}

const Result& Contact::result() const {
    if (!result_)
        throw StatusError(StatusCode::failed_precondition, no_result,
                          "There are no results yet; call contactd_step first.");
    return *result_;
}

void Contact::require(SolutionField field) const {
    const SolutionFields& fields = result().fields;
    if (std::ranges::find(fields, field) == fields.end())
        throw StatusError(StatusCode::failed_precondition, no_result,
                          "The last step did not return this array; request it with contactd_want before the step.");
}

const IcUses& Contact::ics() const {
    require_started();
    return open_->ics();
}

std::vector<StripFrame> Contact::frames(const Section& section) {
    const Grid& grid = inputs.problem.grid;
    return controlled(
        [&](Control& control) { return backend_->frames(section, grid.ny, grid.dy, settings_, control); });
}

std::int32_t Contact::step_number() const {
    require_started();
    return result_ ? static_cast<std::int32_t>(result_->reply.step) : 0;
}

}  // namespace contactd::c
