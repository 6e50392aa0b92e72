// Implements states of an instance, and its derivatives.
#include <algorithm>
#include <cmath>

#include "instance.hpp"

namespace contactd::fmu {
namespace {

bool same_parameters(std::span<const Variable> list, const Values& one, const Values& other) {
    for (std::size_t at = 0; at < list.size(); ++at)
        if (list[at].role == Role::parameter && (one[at] != other[at] || one.text(at) != other.text(at))) return false;
    return true;
}

std::size_t place_of(std::span<const Variable> list, const std::vector<std::size_t>& places, std::uint32_t reference,
                     const char* which) {
    const auto found = std::ranges::find(places, reference);
    if (found != places.end()) return static_cast<std::size_t>(found - places.begin());
    std::string names;
    for (const std::size_t place : places) names += (names.empty() ? "" : ", ") + std::string(list[place].name);
    throw Failure(Status::discard,
                  (reference < list.size() ? std::string(list[reference].name) : std::to_string(reference)) +
                      " has no derivative as " + which + "; those that have one are " + names + ".");
}

}  // namespace

std::unique_ptr<State> Instance::state() {
    return std::make_unique<State>(State{phase_, values_, model_ ? model_->carried() : Carried{}});
}

void Instance::set_state(const State& state) {
    const bool runs = state.phase == Phase::stepping || state.phase == Phase::terminated;
    if (runs)
        start(state.values, state.carried, !model_ || !same_parameters(kind_.variables, values_, state.values));
    else
        model_.reset();
    values_ = state.values;
    phase_ = state.phase;
    set_back_ = runs;
}

std::vector<double> Instance::derivative(std::span<const std::uint32_t> of, std::span<const std::uint32_t> by,
                                         std::span<const double> seed) {
    require(Phase::stepping, "A derivative");
    const DerivativePlaces& places = model_->derivative_places();
    std::vector<std::size_t> rows, columns;
    for (const std::uint32_t one : of) rows.push_back(place_of(kind_.variables, places.of, one, "an output"));
    for (const std::uint32_t one : by) columns.push_back(place_of(kind_.variables, places.by, one, "an input"));
    const std::vector<double> all = model_->derivatives();
    std::vector<double> answer(of.size(), 0);
    for (std::size_t row = 0; row < rows.size(); ++row)
        for (std::size_t column = 0; column < columns.size(); ++column) {
            const double one = all[rows[row] * places.by.size() + columns[column]];
            if (std::isnan(one))
                throw Failure(Status::discard, std::string(kind_.variables[of[row]].name) + " has no derivative by " +
                                                   std::string(kind_.variables[by[column]].name) +
                                                   " here: derivatives require contact, friction and convergence.");
            answer[row] += one * seed[column];
        }
    return answer;
}

}  // namespace contactd::fmu
