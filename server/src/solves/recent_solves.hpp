// Keeps the last solves: their summaries, and pressures within a memory budget.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "config/config.hpp"
#include "contactd/contact.hpp"
#include "contactd/wheel_rail_solution.hpp"
#include "jobs/call.hpp"

namespace contactd::server {

/// Holds pressures on one grid, shape [ny, nx], in single precision, which is sufficient for a picture.
struct RecentPatch {
    Grid grid;
    std::vector<float> pressure;  ///< (N/mm^2)
    std::vector<ElementState> element_division;
};
using RecentPressures = std::shared_ptr<const std::vector<RecentPatch>>;

struct RecentSolve {
    std::uint64_t number = 0;  ///< counts all solves since the start
    std::string user;          ///< the only user that may read it
    std::string method, id;    ///< of the request
    std::chrono::system_clock::time_point at;
    double seconds = 0;
    std::size_t elements = 0, patches = 0;
    bool converged = false;
    int iterations = 0;
    double residual = 0;              ///< the largest
    std::array<double, 3> forces{};   ///< Fx, Fy, Fn on the upper body; of wheels Fx, Fy, Fz on the rails
    double pmax = 0;                  ///< (N/mm^2)
    std::optional<Grid> grid;         ///< of a contact
    RecentPressures pressures;        ///< null without pressures, or without memory for them
    std::size_t pressures_bytes = 0;  ///< what these take, about
};

/// Thread-safe. A solve costs an entry and, if there is memory, a copy of its pressures.
class RecentSolves {
   public:
    using Clock = Call::Clock;

    explicit RecentSolves(RecentSolvesLimits limits) : limits_(limits) {}

    // Adds a solve that has just ended, before its answer is sent.
    void add(const Call& call, Clock::time_point begun, const ContactSolution& solution, const Grid& grid);
    void add(const Call& call, Clock::time_point begun, const WheelRailSolution& solution);
    void add(const Call& call, Clock::time_point begun, const WheelsetSolution& solution);

    /// Returns the solves of a user, the latest first.
    std::vector<RecentSolve> of(const std::string& user) const;
    /// Returns the pressures of a solve. Throws StatusError (SOLVE_UNKNOWN) if the user has no solve of that number, or
    /// its pressures are not available.
    RecentPressures pressures(const std::string& user, std::uint64_t number) const;

   private:
    void keep(RecentSolve solve);

    const RecentSolvesLimits limits_;
    mutable std::mutex mutex_;  // guards the members below
    std::deque<RecentSolve> solves_;
    std::uint64_t count_ = 0;
    std::size_t bytes_ = 0;  // of pressures
};

}  // namespace contactd::server
