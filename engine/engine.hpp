// Provides the work of the daemon without its messages, as a library: tables, operators kept between solves, solves,
// and steps of a simulation. It has no sockets and no messages. It starts threads and opens a folder of tables only
// when a table without a closed form is needed.
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "contactd/contact.hpp"
#include "contactd/observer.hpp"
#include "contactd/patch_influence.hpp"
#include "contactd/solve_reply.hpp"
#include "engine/ics/cache/influence_cache.hpp"
#include "engine/ics/ic_service.hpp"
#include "engine/jobs/job.hpp"
#include "engine/operation/engine_counters.hpp"
#include "engine/operation/engine_log.hpp"
#include "engine/steps/contact_steps.hpp"
#include "engine/steps/wheel_rail_steps.hpp"
#include "engine/wheel_rail/prepared_contacts.hpp"

namespace contactd::engine {

struct EngineSettings {
    std::filesystem::path store_folder;                         ///< contains the tables by finite elements
    std::size_t influence_budget_bytes = std::size_t{1} << 28;  ///< limits the operators kept between solves
    std::size_t most_patch_elements = 200'000;                  ///< limits a patch between wheel and rail
    IcService::Settings tables{};
    bool keeps_building = false;                          ///< an abandoned build continues for the store
    std::size_t most_patch_bytes = std::size_t{1} << 32;  ///< limits the coefficients of a patch with different rows
};

/// Can be used from several threads at once. Calls block the calling thread and end when their observer cancels them.
class Engine {
   public:
    explicit Engine(EngineSettings settings);
    ~Engine();

    /// Solves a problem. Throws InvalidArgument, Cancelled, StoreError, and StatusError if a table is not available.
    SolveReply solve(const ContactProblem& problem, Observer& observer);
    /// Returns the table of one body (mm^3/N). Throws as solve.
    IcReply table(const IcSpec& spec, Observer& observer);
    /// Opens the steps of a simulation. Throws as solve.
    std::unique_ptr<ContactSteps> open(SessionSpec spec, Observer& observer);
    /// Solves one step; see ContactSteps::solve.
    ContactSolution solve(ContactSteps& steps, const StepState& before, const ContactSteps::Overlay& overlay,
                          Observer& observer);

    /// Solves a wheel on its rail. Bodies are half-spaces in closed form. Profiles and operators are kept for the next
    /// step with an equal set-up. Throws InvalidArgument naming "setup.track.gauge", "state.position.z", ..., and
    /// Cancelled.
    WheelRailSolution solve(const WheelRailSetup& setup, const WheelRailState& state, Observer& observer);
    /// Does the same within the tolerances, starting from the end of the previous step. `estimates` become those for
    /// the next step, and are undefined if this throws.
    WheelRailSolution solve(const WheelRailSetup& setup, const WheelRailState& state, WheelRailEstimates& estimates,
                            Observer& observer);
    /// Solves both wheels, and finds the roll at which each has its force. Throws the same, naming "setup.", "left."
    /// (if that has its own set-up), and "state.left_rail.y", ...
    WheelsetSolution solve(const WheelsetSetup& setup, const WheelsetState& state, Observer& observer);
    /// Does the same within the tolerances, starting from the end of the previous step. `estimates` are updated for the
    /// next step, and are undefined if this throws.
    WheelsetSolution solve(const WheelsetSetup& setup, const WheelsetState& state, WheelsetEstimates& estimates,
                           Observer& observer);
    /// Opens the steps of a wheel on its rail. Throws the same.
    std::unique_ptr<WheelRailSteps> open(const WheelRailSessionSpec& spec, const Observer& observer = {});
    /// Solves one step; see WheelRailSteps::solve. Throws the same, and also names "friction.mu".
    WheelRailSolution solve(WheelRailSteps& steps, const StepState& before, const WheelRailStepInput& input,
                            StepState& after, Observer& observer);
    /// Searches for contacts without solving them. Throws the same, naming "states[i].position.z".
    std::vector<WheelRailGeometry> locate(const WheelRailSetup& setup, std::span<const WheelRailState> states,
                                          Observer& observer);

    // For callers that must not block: first the tables, then the solve with them.
    /// Returns the service of tables by finite elements, and opens the store at the first call. Throws StoreError.
    IcService& tables();
    /// Solves a valid problem with the given tables.
    SolveReply solve(const ContactProblem& problem, const IcAnswers& ics, Observer& observer);
    std::unique_ptr<ContactSteps> open(SessionSpec spec, const IcAnswers& ics, const Observer& observer = {});

    JobTable& jobs() { return jobs_; }
    EngineCounters& counters() { return counters_; }
    const InfluenceCache& influences() const { return influences_; }
    /// Frees operators beyond their budget that have not been used for a while. Returns the time of the next call.
    InfluenceCache::Clock::time_point forget_unused(InfluenceCache::Clock::time_point now) {
        return influences_.forget_unused(now);
    }

   private:
    IcAnswer fetch(const IcSpec& spec, Observer& observer);
    IcAnswers fetch(const ContactSetup& setup, Observer& observer);
    void count(const ContactSolution& solution);
    void count(const WheelRailSolution& solution);
    PreparedContacts::Contact wheel_on_rail(const WheelRailSetup& setup, const Observer& observer);
    ContactInfluence sections_influence(const ContactProblem& problem, const PatchStrips& strips, Observer& observer);
    ContactInfluence patch_influence(const ContactProblem& problem, const PatchStrips& strips, Observer& observer);

    const EngineSettings settings_;
    EngineCounters counters_;
    JobTable jobs_;
    InfluenceCache influences_;
    RotatedPatches rotated_patches_;
    IcCache closed_forms_;  // Holds tables for waiting callers and for wheels on rails.
    PreparedContacts wheels_on_rails_;
    std::mutex mutex_;  // guards the members below
    std::unique_ptr<IcService> tables_;
};

}  // namespace contactd::engine
