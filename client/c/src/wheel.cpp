#include "wheel.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <map>
#include <string>
#include <utility>

#include "contactd/error.hpp"
#include "field_types.hpp"
#include "results.hpp"

namespace contactd::c {
namespace {

Roots input_roots() {
    static const std::array roots{&type_of_wheel_input()};
    return roots;
}

StatusError not_brought() {
    return {StatusCode::failed_precondition, no_result,
            "The last solve did not return this array; request it with contactd_want before the solve."};
}

}  // namespace

Wheel::Wheel(const Connection& connection) : CancellableHandle(connection, input_roots(), results_of_wheels()) {}

OpenWheel& Wheel::open_for(const WheelRailSetup& setup, bool transient) {
    if (!open_) open_ = backend_->open_wheel(settings_);
    if (open_->goes_on_with(setup)) return *open_;
    if (transient && moved_)
        throw InvalidArgument("setup",
                              "differs from that of the previous solve, so its tractions cannot be continued; solve "
                              "with state.motion steady_rolling first, or create another wheel");
    saved_.clear();
    return *open_;
}

void Wheel::solve(Which which) {
    OpenWheel& open = open_for_inputs();
    WheelInput input = inputs;
    input.again = which == Which::again;
    take(controlled([&](Control& control) {
        control.timeout = effective_timeout();
        return open.solve(input, control);
    }));
}

std::vector<std::exception_ptr> Wheel::solve_many(std::span<Wheel* const> wheels, int threads) {
    std::vector<std::exception_ptr> failures(wheels.size());
    const auto attempt = [&](std::size_t i, const auto& act) {
        try {
            act(*wheels[i]);
        } catch (...) {
            failures[i] = std::current_exception();
        }
    };
    // One message has one user.
    std::map<std::pair<const Backend*, std::filesystem::path>, std::vector<std::size_t>> together;
    for (std::size_t i = 0; i < wheels.size(); ++i)
        together[{wheels[i]->backend_.get(), wheels[i]->settings_.own_key}].push_back(i);
    for (const auto& [where, members] : together) {
        std::deque<Controlled> controls;
        std::vector<WheelCall> calls;
        std::vector<std::size_t> called;
        for (const std::size_t i : members)
            attempt(i, [&](Wheel& wheel) {
                OpenWheel& open = wheel.open_for_inputs();
                Control& control = controls.emplace_back(wheel).control;
                control.timeout = wheel.effective_timeout();
                calls.push_back({open, wheel.inputs, control});
                called.push_back(i);
            });
        std::vector<WheelResult> results = where.first->solve_many(calls, threads);
        for (std::size_t k = 0; k < called.size(); ++k)
            attempt(called[k], [&](Wheel& wheel) {
                if (const auto* failure = std::get_if<std::exception_ptr>(&results[k]))
                    std::rethrow_exception(*failure);
                wheel.take(std::get<WheelRailSolution>(std::move(results[k])));
            });
    }
    return failures;
}

std::int32_t Wheel::save() {
    OpenWheel& open = open_for(inputs.setup, false);
    std::string name = controlled([&](Control& control) {
        control.timeout = effective_timeout();
        return open.save(inputs.setup, control);
    });
    return saved_.add({std::move(name), result_});
}

void Wheel::restore(std::int32_t state) {
    const Saved& back = saved_.at(state);
    controlled([&](Control& control) { open_->restore(back.name, control); });
    result_ = back.result;
}

void Wheel::forget(std::int32_t state) {
    const Saved& saved = saved_.at(state);
    controlled([&](Control& control) { open_->forget(saved.name, control); });
    saved_.forget(state);
}

void Wheel::take(WheelRailSolution solution) {
    moved_ = true;
    take({std::move(solution), inputs.fields, inputs.gap, inputs.state.position.roll});
}

void Wheel::take(Result result) {
    result_ = std::make_shared<const Result>(std::move(result));
    const WheelRailSolution& found = result_->solution;
    for (const std::string& warning : found.warnings) warn(warning);
    for (std::size_t i = 0; i < found.patches.size(); ++i)
        for (const std::string& warning : found.patches[i].solution.warnings)
            if (std::ranges::find(found.warnings, warning) == found.warnings.end())
                warn("patches[" + std::to_string(i) + "]: " + warning);
}

const Wheel::Result& Wheel::result() const {
    if (!result_)
        throw StatusError(StatusCode::failed_precondition, no_result,
                          "There are no results yet; call contactd_wheel_solve first.");
    return *result_;
}

const WheelRailSolution& Wheel::solution() const {
    return result().solution;
}

void Wheel::require(SolutionField field) const {
    const SolutionFields& fields = result().fields;
    if (std::find(fields.begin(), fields.end(), field) == fields.end()) throw not_brought();
}

void Wheel::require_gap() const {
    if (!result().gap) throw not_brought();
}

}  // namespace contactd::c
