#include "health.hpp"

#include <utility>

namespace contactd::server {
namespace {

void tell(Call& call, HealthState state) {
    const std::string_view name = name_of(state);
    call.progress({{"stage", "watch"}, {"fraction", 0}, {"state", name}});
    if (state == HealthState::stopping) call.succeed({{"state", name}});
}

}  // namespace

std::string_view name_of(HealthState state) {
    return state == HealthState::serving ? "serving" : "stopping";
}

HealthState Health::state() const {
    const std::scoped_lock lock(mutex_);
    return state_;
}

void Health::set(HealthState state) {
    const std::scoped_lock lock(mutex_);
    if (std::exchange(state_, state) == state) return;
    std::erase_if(watchers_, [](const CallPtr& call) { return call->answered(); });
    for (const CallPtr& call : watchers_) tell(*call, state);
    if (state == HealthState::stopping) watchers_.clear();
}

void Health::watch(const CallPtr& call) {
    const std::scoped_lock lock(mutex_);
    std::erase_if(watchers_, [](const CallPtr& known) { return known->answered(); });
    tell(*call, state_);
    if (!call->answered()) watchers_.push_back(call);
}

std::string Health::not_ready() const {
    if (state() == HealthState::stopping) return "The daemon is shutting down.";
    if (!listening_) return "The daemon is starting.";
    return {};  // Without its store, it still answers from memory and by builds.
}

}  // namespace contactd::server
