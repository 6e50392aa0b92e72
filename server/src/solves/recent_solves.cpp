#include "recent_solves.hpp"

#include <algorithm>
#include <cmath>

#include "contactd/proto/status.hpp"

namespace contactd::server {
namespace {

constexpr std::size_t bytes_per_element = sizeof(float) + sizeof(ElementState), bytes_per_patch = 128;

RecentSolve begin(const Call& call, RecentSolves::Clock::time_point begun) {
    RecentSolve solve;
    solve.user = call.user();
    solve.method = call.request.method;
    solve.id = call.request.id;
    solve.at = std::chrono::system_clock::now();
    solve.seconds = std::chrono::duration<double>(RecentSolves::Clock::now() - begun).count();
    solve.converged = true;
    return solve;
}

void add_evidence(RecentSolve& solve, const ContactSolution& solution) {
    const ContactEvidence& evidence = solution.evidence;
    solve.iterations += evidence.normal.iterations;
    if (evidence.tangential) solve.iterations += evidence.tangential->iterations;
    for (const auto& solver : {std::optional(evidence.normal), evidence.tangential, evidence.outer, evidence.force})
        if (solver) solve.residual = std::max(solve.residual, solver->residual);
    solve.pmax = std::max(solve.pmax, solution.pmax);
}

/// Holds the results of a solve on one grid.
struct Part {
    const Grid& grid;
    const ContactSolution& solution;
};

void add_pressures(RecentSolve& solve, const std::vector<Part>& parts, std::size_t max_bytes) {
    std::size_t bytes = 0;
    for (const auto& [grid, solution] : parts) {
        solve.elements += grid.size();
        bytes += bytes_per_patch + bytes_per_element * grid.size();
        // Missing arrays cannot be kept.
        if (solution.pressure.size() != grid.size() || solution.element_division.size() != grid.size())
            bytes = max_bytes + 1;
    }
    solve.patches = parts.size();
    if (parts.empty() || bytes > max_bytes) return;
    auto patches = std::make_shared<std::vector<RecentPatch>>();
    patches->reserve(parts.size());
    for (const auto& [grid, solution] : parts)
        patches->push_back({grid, {solution.pressure.begin(), solution.pressure.end()}, solution.element_division});
    solve.pressures = std::move(patches);
    solve.pressures_bytes = bytes;
}

void add_wheel(RecentSolve& solve, const WheelRailSolution& solution, std::vector<Part>& parts) {
    solve.converged = solve.converged && solution.converged();
    const Wrench& track = solution.forces.track;
    solve.forces = {solve.forces[0] + track.Fx, solve.forces[1] + track.Fy, solve.forces[2] + track.Fz};
    for (const WheelRailPatch& patch : solution.patches) {
        add_evidence(solve, patch.solution);
        parts.push_back({patch.place.grid, patch.solution});
    }
}

/// Returns whether JSON can represent all its numbers, which are then finite.
bool can_be_reported(const RecentSolve& solve) {
    const auto& [x, y, z] = solve.forces;
    return std::isfinite(solve.residual + solve.pmax + x + y + z);
}

}  // namespace

void RecentSolves::add(const Call& call, Clock::time_point begun, const ContactSolution& solution, const Grid& grid) {
    if (limits_.count == 0) return;
    RecentSolve solve = begin(call, begun);
    solve.converged = solution.converged();
    solve.forces = {solution.forces.Fx, solution.forces.Fy, solution.forces.Fn};
    solve.grid = grid;
    add_evidence(solve, solution);
    add_pressures(solve, {{grid, solution}}, limits_.max_bytes);
    keep(std::move(solve));
}

void RecentSolves::add(const Call& call, Clock::time_point begun, const WheelRailSolution& solution) {
    if (limits_.count == 0) return;
    RecentSolve solve = begin(call, begun);
    std::vector<Part> parts;
    add_wheel(solve, solution, parts);
    add_pressures(solve, parts, limits_.max_bytes);
    keep(std::move(solve));
}

void RecentSolves::add(const Call& call, Clock::time_point begun, const WheelsetSolution& solution) {
    if (limits_.count == 0) return;
    RecentSolve solve = begin(call, begun);
    std::vector<Part> parts;
    add_wheel(solve, solution.left, parts);
    add_wheel(solve, solution.right, parts);
    solve.converged = solution.converged();
    add_pressures(solve, parts, limits_.max_bytes);
    keep(std::move(solve));
}

void RecentSolves::keep(RecentSolve solve) {
    if (!can_be_reported(solve)) return;
    const std::scoped_lock lock(mutex_);
    solve.number = ++count_;
    bytes_ += solve.pressures_bytes;
    solves_.push_back(std::move(solve));
    if (solves_.size() > limits_.count) {
        bytes_ -= solves_.front().pressures_bytes;
        solves_.pop_front();
    }
    for (auto oldest = solves_.begin(); bytes_ > limits_.max_bytes && oldest != solves_.end(); ++oldest) {
        bytes_ -= oldest->pressures_bytes;
        oldest->pressures_bytes = 0;
        oldest->pressures.reset();
    }
}

std::vector<RecentSolve> RecentSolves::of(const std::string& user) const {
    const std::scoped_lock lock(mutex_);
    std::vector<RecentSolve> found;
    std::copy_if(solves_.rbegin(), solves_.rend(), std::back_inserter(found),
                 [&](const RecentSolve& solve) { return solve.user == user; });
    return found;
}

RecentPressures RecentSolves::pressures(const std::string& user, std::uint64_t number) const {
    const std::scoped_lock lock(mutex_);
    for (const RecentSolve& solve : solves_)
        if (solve.number == number && solve.user == user && solve.pressures) return solve.pressures;
    throw proto::StatusError(proto::StatusCode::not_found, proto::reason::solve_unknown,
                             "The pressures of solve " + std::to_string(number) +
                                 " are not available, or no longer; call solves.recent for the solves that have them.");
}

}  // namespace contactd::server
