#include "influence_cache.hpp"

#include <utility>

namespace contactd::engine {

CachedInfluence InfluenceCache::of(const std::string& key, const Make& make) {
    const auto any = [](const ContactInfluence&) { return true; };
    if (auto found = influences_.find(key, any)) return {*std::move(found)};
    if (auto found = found_beyond(key)) return *std::move(found);
    ContactInfluence influence = make();  // Two solves may create the same operators; the later ones are cached.
    const std::size_t bytes = influence.bytes();
    if (bytes <= budget_) {
        influences_.insert(key, influence, bytes, any);
        return {std::move(influence)};
    }
    CachedInfluence cached{std::move(influence), OperatorUse{false, bytes, budget_}};
    {
        const std::scoped_lock lock(mutex_);
        beyond_ = Beyond{key, cached, Clock::now()};
    }
    cached.use->made = true;
    return cached;
}

std::optional<CachedInfluence> InfluenceCache::found_beyond(const std::string& key) {
    const std::scoped_lock lock(mutex_);
    if (!beyond_ || beyond_->key != key) return std::nullopt;
    beyond_->used = Clock::now();
    return beyond_->cached;
}

InfluenceCache::Clock::time_point InfluenceCache::forget_unused(Clock::time_point now) {
    std::optional<Beyond> forgotten;  // is destroyed after the lock is released, because it may be large
    const std::scoped_lock lock(mutex_);
    if (!beyond_) return Clock::time_point::max();
    if (beyond_->cached.influence.current.use_count() > 1) beyond_->used = now;
    if (now < beyond_->used + longest_unused) return beyond_->used + longest_unused;
    forgotten = std::exchange(beyond_, std::nullopt);
    return Clock::time_point::max();
}

InfluenceCache::Usage InfluenceCache::usage() const {
    Usage usage = influences_.usage();
    const std::scoped_lock lock(mutex_);
    if (beyond_) {
        ++usage.entries;
        usage.bytes += beyond_->cached.use->bytes;
    }
    return usage;
}

std::string operator_warning(const OperatorUse& use) {
    return "The operators of this problem take " + std::to_string(use.bytes) +
           " bytes, but store.influence_budget_bytes is " + std::to_string(use.budget_bytes) +
           ". Beyond this budget only the operators used last are kept, so alternating problems recompute theirs each "
           "time. Increase the budget in this case.";
}

std::vector<std::string> operator_warnings(const std::optional<OperatorUse>& use) {
    if (!use || !use->made) return {};
    return {operator_warning(*use)};
}

std::string influence_key(const ContactProblem& problem, const std::string& upper_key, const std::string& lower_key) {
    std::string key = upper_key + ' ' + lower_key;
    const auto add = [&](double value) {
        const auto* bytes = reinterpret_cast<const char*>(&value);
        key.append(bytes, sizeof value);
    };
    const auto [sx, sy, velocity] = rolling_of_operators(problem);
    const auto [upper, lower] = problem.bodies.materials();
    for (const double value : {upper.G, upper.nu, lower.G, lower.nu, problem.grid.dx, problem.grid.dy, sx, sy})
        add(value);
    add(problem.grid.nx);
    add(problem.grid.ny);
    for (const Body* body : {&problem.bodies.upper, &problem.bodies.lower}) {
        if (!body->viscoelastic) continue;
        add(body == &problem.bodies.upper ? 1 : 2);
        add(body->viscoelastic->f);
        add(body->viscoelastic->tau * velocity);
    }
    // Products do not depend on the position of strips, but each position is checked once against its section.
    if (problem.columns && problem.bodies.any_uniform())
        for (const StripFrame& frame : problem.columns->frames)
            for (const double value : {frame.y, frame.z, frame.angle}) add(value);
    return key;
}

}  // namespace contactd::engine
