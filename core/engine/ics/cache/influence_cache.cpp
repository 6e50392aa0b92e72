#include "influence_cache.hpp"

namespace contactd::engine {

ContactInfluence InfluenceCache::of(const std::string& key, const Make& make) {
    const auto any = [](const ContactInfluence&) { return true; };
    if (auto found = influences_.find(key, any)) return *std::move(found);
    ContactInfluence influence = make();  // two solves may make the same, and the later one is kept
    influences_.insert(key, influence, influence.bytes(), any);
    return influence;
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
    // Products do not depend on where columns lie, but whether they are those of a section is looked at once for each.
    if (problem.columns && problem.bodies.any_prism())
        for (const ColumnFrame& frame : problem.columns->frames)
            for (const double value : {frame.y, frame.z, frame.angle}) add(value);
    return key;
}

}  // namespace contactd::engine
