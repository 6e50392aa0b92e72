#include "rail_history.hpp"

#include <utility>

#include "problem/problem.hpp"

namespace contactd::cases {
namespace {

enum Previous { go_on = 0, from_pressures = 1, again = 3 };

}  // namespace

RailHistory::SharedEstimates RailHistory::start_of(const Given& given, Model model, const WheelRailState& state) const {
    // Simplified models have no tractions to start from. The last case only provides the start of the search for the
    // height.
    if (model != Model::full) return end_;
    const bool is_steady = state.motion == WheelRailMotion::steady_rolling;
    const bool has_estimate = given.digits.estimate != 0;
    const int previous = given.digits.previous;
    // Tractions are a history only if the step is not steady.
    if (is_steady) return has_estimate ? end_ : nullptr;
    if (previous == from_pressures && end_) refuse_history_of_pressures();
    if (previous == go_on) return end_;
    if (previous == again) return before_;
    if (!has_estimate || !end_) return nullptr;
    WheelRailEstimates start = *end_;
    start.patches.clear();
    return std::make_shared<const WheelRailEstimates>(std::move(start));
}

std::size_t RailHistory::elements() const {
    std::size_t count = 0;
    if (end_)
        for (const WheelRailEstimates::Patch& patch : end_->patches) count += patch.grid.size();
    return count;
}

WheelRailSolution RailHistory::solve(const Given& given, Model model, const WheelRailState& state,
                                     const std::function<WheelRailSolution(WheelRailEstimates&)>& solve) {
    SharedEstimates start = start_of(given, model, state);
    const auto next = start ? std::make_shared<WheelRailEstimates>(*start) : std::make_shared<WheelRailEstimates>();
    WheelRailSolution solution = solve(*next);
    before_ = std::move(start);
    end_ = next;
    return solution;
}

}  // namespace contactd::cases
