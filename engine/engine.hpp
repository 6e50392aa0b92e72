// The daemon's work without its messages, as a library: tables, operators that are kept between solves, solves, and the
// steps of a simulation. It has no sockets and no messages; threads and a folder of tables only once a table is wanted
// that is not known in closed form.
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
    std::filesystem::path store_folder;                         ///< of the tables that finite elements made
    std::size_t influence_budget_bytes = std::size_t{1} << 28;  ///< of operators that are kept between solves
    std::size_t most_patch_elements = 200'000;                  ///< of a patch between wheel and rail
    IcService::Settings tables{};
    bool keeps_building = false;                          ///< an abandoned build goes on for the store
    std::size_t most_patch_bytes = std::size_t{1} << 32;  ///< of a patch's coefficients, where its rows differ
};

/// Safe to use from several threads at once. What waits, waits in the thread that calls, and ends when its observer
/// says so.
class Engine {
   public:
    explicit Engine(EngineSettings settings);
    ~Engine();

    /// Throws InvalidArgument, Cancelled, StoreError, and StatusError where a table cannot be had.
    SolveReply solve(const ContactProblem& problem, Observer& observer);
    /// The table of one body (mm^3/N). Throws as solve.
    IcReply table(const IcSpec& spec, Observer& observer);
    /// The steps of a simulation. Throws as solve.
    std::unique_ptr<ContactSteps> open(SessionSpec spec, Observer& observer);
    /// One of them; see ContactSteps::solve.
    ContactSolution solve(ContactSteps& steps, const StepState& before, const ContactSteps::Overlay& overlay,
                          Observer& observer);

    /// A wheel on its rail. Bodies are half-spaces in closed form; profiles and operators are kept for the next step
    /// with an equal set-up. Throws InvalidArgument naming "setup.track.gauge", "state.position.z", ..., and Cancelled.
    WheelRailSolution solve(const WheelRailSetup& setup, const WheelRailState& state, Observer& observer);
    /// Both wheels, and the roll at which each has its force. Throws the same, naming "setup.", "left." (where that has
    /// a set-up of its own), and "state.left_rail.y", ...
    WheelsetSolution solve(const WheelsetSetup& setup, const WheelsetState& state, Observer& observer);
    /// The same within the tolerances, from where a step before has ended. `estimates` become those for the next step,
    /// and mean nothing where this throws.
    WheelsetSolution solve(const WheelsetSetup& setup, const WheelsetState& state, WheelsetEstimates& estimates,
                           Observer& observer);
    /// The steps of a wheel on its rail. Throws the same.
    std::unique_ptr<WheelRailSteps> open(const WheelRailSessionSpec& spec, const Observer& observer = {});
    /// One of them; see WheelRailSteps::solve. Throws the same, naming "friction.mu", too.
    WheelRailSolution solve(WheelRailSteps& steps, const StepState& before, const WheelRailStepInput& input,
                            StepState& after, Observer& observer);
    /// The search for contacts alone. Throws the same, naming "states[i].position.z".
    std::vector<WheelRailGeometry> locate(const WheelRailSetup& setup, std::span<const WheelRailState> states,
                                          Observer& observer);

    // For those who cannot wait: first the tables, then the solve with them.
    /// Service of tables by finite elements; opens the store when it is first asked for. Throws StoreError.
    IcService& tables();
    /// Solves a valid problem, whose tables are at hand.
    SolveReply solve(const ContactProblem& problem, const IcAnswers& ics, Observer& observer);
    std::unique_ptr<ContactSteps> open(SessionSpec spec, const IcAnswers& ics, const Observer& observer = {});

    JobTable& jobs() { return jobs_; }
    EngineCounters& counters() { return counters_; }
    const InfluenceCache& influences() const { return influences_; }
    /// Gives back operators beyond their budget that nobody has used for a while. Returns when to ask again.
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
    IcCache closed_forms_;  // of those who wait, and of wheels on rails
    PreparedContacts wheels_on_rails_;
    std::mutex mutex_;  // guards what follows
    std::unique_ptr<IcService> tables_;
};

}  // namespace contactd::engine
