#include "influence_cache.hpp"

#include <algorithm>
#include <iterator>

namespace contactd::server {

bool InfluenceCache::find(const std::string& key, ContactInfluence& found) {
    const std::scoped_lock lock(mutex_);
    const auto entry = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.key == key; });
    if (entry == entries_.end()) return false;
    entries_.splice(entries_.begin(), entries_, entry);
    found = entry->influence;
    return true;
}

ContactInfluence InfluenceCache::of(const std::string& key, const Make& make) {
    ContactInfluence influence;
    if (find(key, influence)) return influence;
    influence = make();  // not under the lock; two solves may make the same, and the later one is kept
    const std::size_t bytes = influence.bytes();
    if (bytes > budget_) return influence;
    const std::scoped_lock lock(mutex_);
    std::erase_if(entries_, [&](const Entry& entry) {
        if (entry.key != key) return false;
        bytes_ -= entry.bytes;
        return true;
    });
    while (bytes_ + bytes > budget_) {
        bytes_ -= entries_.back().bytes;
        entries_.pop_back();
    }
    entries_.push_front({key, influence, bytes});
    bytes_ += bytes;
    return influence;
}

InfluenceCache::Usage InfluenceCache::usage() const {
    const std::scoped_lock lock(mutex_);
    return {entries_.size(), bytes_, budget_};
}

std::string influence_key(const ContactProblem& problem, const std::string& upper_key, const std::string& lower_key) {
    std::string key = upper_key + ' ' + lower_key;
    const auto add = [&](double value) {
        const auto* bytes = reinterpret_cast<const char*>(&value);
        key.append(bytes, sizeof value);
    };
    const auto [sx, sy] = step_of(problem);
    const auto [upper, lower] = problem.bodies.materials();
    for (const double value : {upper.G, upper.nu, lower.G, lower.nu, problem.grid.dx, problem.grid.dy, sx, sy})
        add(value);
    add(problem.grid.nx);
    add(problem.grid.ny);
    return key;
}

}  // namespace contactd::server
