#include "wheel.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "contactd/error.hpp"
#include "results.hpp"
#include "wheel_fields.hpp"

namespace contactd::c {
namespace {

Roots input_roots() {
    static const std::array roots{&type_of_wheel_input()};
    return roots;
}

/// A solve that began anew each time would not be what was asked for.
void check_steady(const WheelRailState& state) {
    if (state.motion != WheelRailMotion::steady_rolling)
        throw InvalidArgument("state.motion",
                              "is not steady_rolling; a wheel of this interface carries no tractions from solve to "
                              "solve. Steps that go on from each other are those of sessions, in C++ and Python");
}

StatusError not_brought() {
    return {StatusCode::failed_precondition, no_result,
            "The last solve did not bring this array along; contactd_want asks for it before."};
}

}  // namespace

Wheel::Wheel(const Connection& connection) : CancellableHandle(connection, input_roots(), results_of_wheels()) {}

void Wheel::solve() {
    check_steady(inputs.state);
    if (!open_) open_ = backend_->open_wheel(settings_);
    Result result{{}, inputs.fields, inputs.gap, inputs.state.position.roll};
    result.solution = controlled([&](Control& control) {
        control.timeout = effective_timeout();
        return open_->solve(inputs, control);
    });
    take(std::move(result));
}

void Wheel::take(Result result) {
    result_ = std::move(result);
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
                          "There are no results yet; contactd_wheel_solve makes them.");
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
