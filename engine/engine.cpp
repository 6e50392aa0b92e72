#include "engine/engine.hpp"

#include <chrono>
#include <condition_variable>
#include <utility>

#include "contactd/closed_form_record.hpp"
#include "contactd/ic_family.hpp"
#include "contactd/solve_contact.hpp"
#include "contactd/status.hpp"
#include "contactd/strip_frames.hpp"
#include "engine/ics/problem_tables.hpp"
#include "engine/steps/forces_on_grids.hpp"

namespace contactd::engine {
namespace {

using namespace std::chrono_literals;

/// Holds one request for a table and the thread that waits for its answer.
class Awaited {
   public:
    IcCaller caller(const std::shared_ptr<Awaited>& self, const Observer& observer) const {
        return {[self](const IcAnswer& answer) { self->settle(answer, {}); },
                [self](const Status& status) { self->settle({}, status); },
                [self](const Job& job, const JobProgress& progress) { self->hear(job, progress); },
                {.client = {}, .abandoned = [self] { return self->given_up(); }, .user = std::string(observer.user())}};
    }

    /// Throws StatusError if there is no table, and Cancelled. The build ends with its last caller, unless it
    /// `keeps_building`.
    IcAnswer wait(JobTable& jobs, Observer& observer, bool keeps_building) {
        std::unique_lock lock(mutex_);
        while (!changed_.wait_for(lock, 50ms, [this] { return settled_; })) {
            const JobProgress last = progress_;
            const std::string job = job_;
            lock.unlock();
            if (!job.empty()) tell(last, observer);
            if (observer.cancelled()) give_up(jobs, keeps_building ? "" : job);
            lock.lock();
        }
        if (!status_.ok()) throw StatusError(status_);
        return answer_;
    }

   private:
    void settle(IcAnswer answer, Status status) {
        const std::scoped_lock lock(mutex_);
        answer_ = std::move(answer);
        status_ = std::move(status);
        settled_ = true;
        changed_.notify_all();
    }
    void hear(const Job& job, const JobProgress& progress) {
        const std::scoped_lock lock(mutex_);
        job_ = job.name;
        progress_ = progress;
    }
    static void tell(const JobProgress& last, Observer& observer) {
        Progress progress{last.stage, last.fraction, last.iteration, last.residual};
        progress.seconds_left = last.seconds_left;
        observer.on_progress(progress);
    }
    [[noreturn]] void give_up(JobTable& jobs, const std::string& job) {
        {
            const std::scoped_lock lock(mutex_);
            given_up_ = true;
        }
        const auto running = jobs.find(job);
        if (running && running->callers() == 0) running->cancel();
        throw Cancelled();
    }
    bool given_up() const {
        const std::scoped_lock lock(mutex_);
        return given_up_;
    }

    mutable std::mutex mutex_;
    std::condition_variable changed_;
    bool settled_ = false, given_up_ = false;
    IcAnswer answer_;
    Status status_;
    std::string job_;
    JobProgress progress_;
};

}  // namespace

Engine::Engine(EngineSettings settings)
    : settings_(std::move(settings)),
      influences_(settings_.influence_budget_bytes),
      closed_forms_(settings_.tables.memory_budget_bytes),
      wheels_on_rails_([this](const ContactProblem& problem, const PatchStrips& strips, Observer& observer) {
          return patch_influence(problem, strips, observer);
      }) {}

Engine::~Engine() = default;

IcService& Engine::tables() {
    const std::scoped_lock lock(mutex_);
    if (!tables_) {
        if (settings_.store_folder.empty())
            throw StoreError("There is no folder for tables: set CONTACTD_STORE or HOME.");
        const EngineLog log(settings_.tables.log);
        IcStore store(settings_.store_folder, [this, log](const std::string& sentence) {
            ++counters_.tables_set_aside;
            log.warn("store: " + sentence);
        });
        tables_ = std::make_unique<IcService>(settings_.tables, std::move(store), jobs_, counters_);
    }
    return *tables_;
}

// --- tables ----------------------------------------------------------------------------------------------------------

IcAnswer Engine::fetch(const IcSpec& spec, Observer& observer) {
    observer.throw_if_cancelled();
    if (spec.source == IcSource::analytic) {
        const std::string key = ic_key(spec);
        if (auto known = closed_forms_.find(key, spec.nx, spec.ny)) return {std::move(known), key, "memory"};
        auto made = std::make_shared<const IcRecord>(closed_form_record(spec, observer));
        closed_forms_.insert(key, made);
        ++counters_.closed_form;
        return {std::move(made), key, "closed_form"};
    }
    const auto awaited = std::make_shared<Awaited>();
    tables().request(spec, awaited->caller(awaited, observer));
    return awaited->wait(jobs_, observer, settings_.keeps_building);
}

IcAnswers Engine::fetch(const ContactSetup& setup, Observer& observer) {
    IcAnswers answers;
    if (!needs_tables(setup)) return answers;
    const auto specs = specs_of(setup);
    if (specs[0]) answers[0] = fetch(*specs[0], observer);
    if (specs[1]) answers[1] = serves_both(answers[0], specs) ? answers[0] : fetch(*specs[1], observer);
    return answers;
}

IcReply Engine::table(const IcSpec& spec, Observer& observer) {
    validate(spec);
    // Reports an invalid section in the lengths of the request before anything is built.
    std::vector<StripFrame> frames = strip_frames(spec);
    const IcAnswer answer = fetch(spec, observer);
    return {
        answer.key,       answer.origin, spec, table_for(*answer.record, spec, 1, observer), answer.record->evidence,
        std::move(frames)};
}

// --- solves ----------------------------------------------------------------------------------------------------------

void Engine::count(const ContactSolution& solution) {
    ++(solution.converged() ? counters_.solves_converged : counters_.solves_not_converged);
    counters_.normal_iterations += solution.evidence.normal.iterations;
    if (solution.evidence.tangential) counters_.tangential_iterations += solution.evidence.tangential->iterations;
}

SolveReply Engine::solve(const ContactProblem& problem, Observer& observer) {
    check(problem);
    return solve(problem, fetch(problem, observer), observer);
}

SolveReply Engine::solve(const ContactProblem& problem, const IcAnswers& ics, Observer& observer) {
    SolveReply reply;
    const CachedInfluence cached = influence_of(problem, ics, influences_, observer);
    reply.solution = solve_contact(problem, cached.influence, observer);
    extrapolate_on_grids(problem, reply.solution, influences_, observer);
    count(reply.solution);
    reply.ics = uses_of(problem, ics);
    reply.operators = cached.use;
    for (std::string& warning : operator_warnings(cached.use)) reply.solution.warnings.push_back(std::move(warning));
    return reply;
}

std::unique_ptr<ContactSteps> Engine::open(SessionSpec spec, Observer& observer) {
    check_opening({spec.setup, spec.load});
    const IcAnswers ics = fetch(spec.setup, observer);
    return open(std::move(spec), ics, observer);
}

std::unique_ptr<ContactSteps> Engine::open(SessionSpec spec, const IcAnswers& ics, const Observer& observer) {
    CachedInfluence cached = influence_of({spec.setup, spec.load}, ics, influences_, observer);
    return std::make_unique<ContactSteps>(std::move(spec), ics, std::move(cached));
}

ContactSolution Engine::solve(ContactSteps& steps, const StepState& before, const ContactSteps::Overlay& overlay,
                              Observer& observer) {
    ContactSolution solution = steps.solve(before, overlay, influences_, observer);
    count(solution);
    return solution;
}

}  // namespace contactd::engine
