// How IcService has a table built: its turn among builds of this daemon and others, the builder, what its end means.
#include <algorithm>
#include <chrono>
#include <format>
#include <thread>
#include <utility>

#include "contactd/error.hpp"
#include "engine/ics/store/store_folder.hpp"
#include "request_in_flight.hpp"

namespace contactd::engine {

using proto::Status;
using proto::StatusCode;

namespace {

constexpr auto lock_sign_interval = std::chrono::seconds(1);
/// What a sign may need to be seen on another machine, beyond the silence that is taken for a stall.
constexpr auto lock_sign_delay = std::chrono::seconds(5);
constexpr auto default_patience = std::chrono::seconds(60);

/// Notes what a build took, and what the store holds afterwards.
class BuildClock {
   public:
    BuildClock(EngineCounters& counters, const std::filesystem::path& folder) : counters_(counters), folder_(folder) {}
    ~BuildClock() {
        const auto spent = std::chrono::steady_clock::now() - start_;
        counters_.build_milliseconds += std::chrono::duration_cast<std::chrono::milliseconds>(spent).count();
        count_store(counters_, folder_);
    }
    BuildClock(const BuildClock&) = delete;
    BuildClock& operator=(const BuildClock&) = delete;
    double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

   private:
    EngineCounters& counters_;
    const std::filesystem::path& folder_;
    const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// What was built and how good it is, for the log.
std::string summary(const IcEvidence& evidence) {
    std::string text = std::format("{} unknowns", evidence.dofs);
    if (!evidence.family_nu.empty()) text += std::format(" and fewer, {} tables", evidence.family_nu.size());
    text += ", solver " + evidence.solver;
    if (evidence.solver != name_of(Solver::direct)) {
        text += ", iterations";
        for (const LoadCaseEvidence& load_case : evidence.load_cases)
            text += std::format(" {} {}", name_of(load_case.load), load_case.iterations);
    }
    const auto add = [&](const char* name, const std::optional<ComponentError>& error) {
        if (error) text += std::format("{} {:.1e}", name, error->largest);
    };
    add(evidence.errors_estimated ? "; estimated errors xx" : "; errors xx", evidence.errors.xx);
    add(", yy", evidence.errors.yy);
    add(", zz", evidence.errors.zz);
    if (evidence.modelling_error) text += std::format("; modelling error {:.1e}", *evidence.modelling_error);
    if (evidence.interpolation_error) text += std::format(", interpolation {:.1e}", *evidence.interpolation_error);
    for (const std::string& warning : evidence.warnings) text += "; " + warning;
    return text;
}

}  // namespace

bool IcService::queue_build(const RequestPtr& request) {
    const std::scoped_lock lock(mutex_);
    if (stopping_) return false;
    const std::weak_ptr waiting(request);
    JobOrigin origin{"build", request->description, [this, waiting] { return users_of(waiting); }};
    request->job = jobs_.create(std::move(origin), [this, waiting] {
        if (const RequestPtr known = waiting.lock()) cancel_queued(known);
    });
    for (const IcCaller& caller : request->callers) caller.progress(*request->job, request->job->progress());
    // A build goes on for the cache when its callers have gone.
    Turn turn = request->callers.empty() ? Turn{} : request->callers.front().turn;
    turn.abandoned = nullptr;
    builders_.post(std::move(turn), [this, request] { build(request); });
    return true;
}

Status IcService::cancelled_status() {
    const std::scoped_lock lock(mutex_);
    return stopping_ ? stop_status_
                     : failure(StatusCode::cancelled, proto::reason::job_cancelled, "The build was cancelled.");
}

void IcService::cancel_queued(const RequestPtr& request) {
    if (request->job->running()) return;  // the builder thread notices by itself
    ++counters_.builds_cancelled;
    fail(request, cancelled_status());
}

void IcService::build(const RequestPtr& request) {
    Job& job = *request->job;
    if (job.cancelled()) return;  // while it was queued; its callers know
    const BuildClock clock(counters_, keeper_.store().folder());
    try {
        job.set_running();
        TableLock lock(keeper_.store().lock_of(request->key));
        wait_for_turn(request, lock);
        // While this build waited for its turn, another one, of this daemon or of another, may have made the table.
        if (auto found = keeper_.find(request->spec)) {
            ++counters_.disk_hits;
            return complete(request, std::make_shared<const IcRecord>(std::move(*found)), "disk");
        }
        ++counters_.builds_started;
        log_.info(std::format("{} starts: key {} extent {} x {}", job.name, request->key, request->spec.nx,
                              request->spec.ny));
        auto record = run_build(request, lock);
        quarantine_.note_success(request->key, request->spec);
        ++counters_.builds_finished;
        log_.info(std::format("{} finished after {:.2f} s: {}", job.name, clock.seconds(), summary(record->evidence)));
        complete(request, std::move(record), "built");
    } catch (const Cancelled&) {
        ++counters_.builds_cancelled;
        log_.info(std::format("{} cancelled", job.name));
        fail(request, cancelled_status());
    } catch (const InvalidArgument& error) {  // known before anything was built, and as quickly the next time
        fail_build(request, status_of(error));
    } catch (const BuilderUnusable& error) {
        fail_build(request, failure(StatusCode::internal, proto::reason::build_failed, error.what()));
    } catch (const BuilderOutOfMemory& error) {
        Status status = failure(StatusCode::resource_exhausted, proto::reason::build_out_of_memory, error.what());
        if (error.field().empty())
            quarantine_.note_failure(request->key, request->spec, status);
        else  // known before anything was built, and as quickly the next time
            status.violations.push_back({error.field(), error.what()});
        fail_build(request, status);
    } catch (const std::exception& error) {
        const Status status = failure(StatusCode::internal, proto::reason::build_failed, error.what());
        quarantine_.note_failure(request->key, request->spec, status);
        fail_build(request, status);
    }
}

/// Waits while somebody else builds a table with this key. Where locks do not work, and when the
/// holder gives no sign of life any more, the build goes on without: at worst it is done twice.
void IcService::wait_for_turn(const RequestPtr& request, TableLock& lock) {
    constexpr auto interval = std::chrono::milliseconds(100);
    const auto stall = settings_.command.stall;
    const auto patience = (stall.count() > 0 ? stall : default_patience) + lock_sign_delay;
    auto sign = lock.sign();
    auto changed = std::chrono::steady_clock::now();
    for (bool waited = false;; waited = true) {
        if (lock.try_lock() != TableLock::State::busy) return;
        if (!waited) report(request, {"waiting", 0, 0, 0});
        if (request->job->cancelled()) throw Cancelled("The build was cancelled.");
        std::this_thread::sleep_for(interval);
        const auto now = std::chrono::steady_clock::now();
        if (const auto latest = lock.sign(); latest != sign) {
            sign = latest;
            changed = now;
        }
        if (now - changed < patience) continue;
        log_.warn(std::format("{} does not wait any longer for whoever holds {}", request->job->name,
                              keeper_.store().lock_of(request->key).string()));
        return;
    }
}

IcCache::Record IcService::run_build(const RequestPtr& request, const TableLock& lock) {
    const auto output = keeper_.store().path_to_write(request->key, request->spec.nx, request->spec.ny);
    auto next_sign = std::chrono::steady_clock::now();
    const auto give_sign = [&] {
        if (std::chrono::steady_clock::now() < next_sign) return;
        next_sign += lock_sign_interval;
        lock.give_sign();
    };
    keeper_.store().problem();  // makes a folder that was removed
    const BuiltTable built = run_builder(
        settings_.command, request->spec, output, *request->job,
        [&](const JobProgress& progress) { report(request, progress); }, give_sign);
    if (!built.bytes.empty()) return keeper_.keep_unsaved(from_ic_file(built.bytes, output), built.problem);
    auto record = std::make_shared<const IcRecord>(read_ic_file(output));
    keeper_.note_stored(request->spec, keys_in_flight());
    return record;
}

void IcService::report(const RequestPtr& request, const JobProgress& progress) {
    request->job->set_progress(progress);
    const std::scoped_lock lock(mutex_);
    for (const IcCaller& caller : request->callers) caller.progress(*request->job, progress);
}

void IcService::fail_build(const RequestPtr& request, const Status& status) {
    ++counters_.builds_failed;
    log_.error(std::format("{} failed: {}", request->job->name, status.message));
    fail(request, status);
}

}  // namespace contactd::engine
