// Represents the simulation of a session: a contact, or a wheel on its rail.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "contactd/proto/session.hpp"
#include "engine/engine.hpp"
#include "jobs/job_reports.hpp"
#include "solves/recent_solves.hpp"

namespace contactd::server {

/// Holds the answer to a step, kept for a repeated request.
struct StepAnswer {
    std::size_t request = 0;                  ///< hash of the request
    std::shared_ptr<const std::string> text;  ///< the result, as JSON
    proto::Frames frames;
};

/// A requested step.
struct StepRequest {
    const nlohmann::json& params;  ///< parameters of session.step, which have passed their schema
    const CallPtr& call;           ///< holds their frames
    const std::shared_ptr<Job>& job;
    std::function<void(const JobProgress&)> report;
    std::function<void()> check_rest;             ///< checks the request after the step's own fields were read
    std::function<bool(const StepAnswer&)> send;  ///< returns false when no client waits for the answer any more
    RecentSolves& recent;
};

/// Non-const functions may be used in the order of its session only.
class Simulation {
   public:
    virtual ~Simulation() = default;

    /// Returns the initial state: the data from which the first step starts.
    virtual engine::StepState start() const = 0;

    struct Solved {
        std::string text;  ///< the result, as JSON
        engine::StepState after;
    };
    /// Solves the step after `before`. Throws as the engine, and StatusError for a step of the other kind.
    virtual Solved solve(const engine::StepState& before, const StepRequest& request, proto::ArrayWriter& arrays,
                         Observer& observer, engine::Engine& engine) = 0;

    /// Returns the part of the set-up that session.info reports.
    virtual SessionInfo common() const = 0;
    /// Returns the number of elements of the patches of the step that led to `state`.
    virtual std::size_t elements(const engine::StepState& state) const = 0;
    /// Returns whether a step takes about as long as waking a thread.
    virtual bool is_small() const = 0;
    virtual std::size_t bytes() const = 0;  ///< approximate memory, including the state before the first step
    virtual std::size_t state_bytes(const engine::StepState& state) const = 0;  ///< of each state
};

/// Returns the approximate memory of a session of `setup`.
std::size_t session_bytes(const ContactSetup& setup);
std::size_t session_bytes(const WheelRailSetup& setup);

std::unique_ptr<Simulation> simulation_of(std::unique_ptr<engine::ContactSteps> steps);
std::unique_ptr<Simulation> simulation_of(std::unique_ptr<engine::WheelRailSteps> steps);

}  // namespace contactd::server
