#include "ic_builds.hpp"

#include <chrono>
#include <format>
#include <optional>
#include <thread>
#include <utility>

#include "contactd/error.hpp"
#include "contactd/fields/axis.hpp"
#include "contactd/fields/ic_spec.hpp"
#include "engine/ics/store/store_folder.hpp"

namespace contactd::engine {

using proto::Status;
using proto::StatusCode;

namespace {

constexpr auto lock_sign_interval = std::chrono::seconds(1);
/// Time for a sign of life to become visible on other machines, in addition to the silence that counts as a stall.
constexpr auto lock_sign_delay = std::chrono::seconds(5);
constexpr auto default_timeout = std::chrono::seconds(60);

/// Records the cost of a build and the resulting size of the store.
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

/// Summarises a built table and its accuracy, for the log.
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

IcBuilds::IcBuilds(Settings settings, ResilientStore& resilient_store, EngineCounters& counters, const EngineLog& log)
    : settings_(std::move(settings)),
      resilient_store_(resilient_store),
      counters_(counters),
      log_(log),
      quarantine_(settings_.quarantine),
      builders_(settings_.concurrent) {}

void IcBuilds::queue(QueueTicket ticket, TableBuild build) {
    builders_.post(std::move(ticket), [this, build = std::move(build)] { run(build); });
}

void IcBuilds::run(const TableBuild& build) {
    Job& job = *build.job;
    if (job.cancelled()) return;  // It was cancelled in the queue; its callers have been answered.
    try {
        // End the job before the end is reported, so that later requests already count this build.
        std::optional<BuildClock> clock(std::in_place, counters_, resilient_store_.store().folder());
        job.set_running();
        TableLock lock(resilient_store_.store().lock_of(build.key));
        wait_for_lock(build, lock);
        // While this build waited for its turn, another build of this or another daemon may have built the table.
        if (auto found = resilient_store_.find(build.spec)) {
            ++counters_.disk_hits;
            clock.reset();
            return build.done(std::make_shared<const IcRecord>(std::move(*found)), "disk");
        }
        ++counters_.builds_started;
        log_.info(std::format("{} starts: key {} extent {} x {}", job.name, build.key, build.spec.nx, build.spec.ny));
        auto record = run_builder(build, lock);
        quarantine_.note_success(build.key, build.spec);
        ++counters_.builds_finished;
        log_.info(std::format("{} finished after {:.2f} s: {}", job.name, clock->seconds(), summary(record->evidence)));
        clock.reset();
        build.done(std::move(record), "built");
    } catch (const Cancelled&) {
        ++counters_.builds_cancelled;
        log_.info(std::format("{} cancelled", job.name));
        build.cancelled();
    } catch (const InvalidArgument& error) {  // Is found before the build and as quickly the next time.
        fail(build, status_of(error));
    } catch (const BuilderUnusable& error) {
        fail(build, failure(StatusCode::internal, proto::reason::build_failed, error.what()));
    } catch (const BuilderOutOfMemory& error) {
        Status status = failure(StatusCode::resource_exhausted, proto::reason::build_out_of_memory, error.what());
        if (error.field().empty())
            quarantine_.note_failure(build.key, build.spec, status);
        else  // Is found before the build and as quickly the next time.
            status.violations.push_back({error.field(), error.what()});
        fail(build, status);
    } catch (const std::exception& error) {
        const Status status = failure(StatusCode::internal, proto::reason::build_failed, error.what());
        quarantine_.note_failure(build.key, build.spec, status);
        fail(build, status);
    }
}

/// Waits while another process builds a table with this key. If locks do not work, or the holder shows no sign of life,
/// the build continues without the lock. At worst, the table is built twice.
void IcBuilds::wait_for_lock(const TableBuild& build, TableLock& lock) {
    constexpr auto interval = std::chrono::milliseconds(100);
    const auto stall = settings_.command.stall;
    const auto timeout = (stall.count() > 0 ? stall : default_timeout) + lock_sign_delay;
    auto sign = lock.sign();
    auto changed = std::chrono::steady_clock::now();
    for (bool waited = false;; waited = true) {
        if (lock.try_lock() != TableLock::State::busy) return;
        if (!waited) build.report({"waiting", 0, 0, 0});
        if (build.job->cancelled()) throw Cancelled("The build was cancelled.");
        std::this_thread::sleep_for(interval);
        const auto now = std::chrono::steady_clock::now();
        if (const auto latest = lock.sign(); latest != sign) {
            sign = latest;
            changed = now;
        }
        if (now - changed < timeout) continue;
        log_.warn(std::format("{} no longer waits for the process that holds {}", build.job->name,
                              resilient_store_.store().lock_of(build.key).string()));
        return;
    }
}

ResilientStore::Record IcBuilds::run_builder(const TableBuild& build, const TableLock& lock) {
    const auto output = resilient_store_.store().path_to_write(build.key, build.spec.nx, build.spec.ny);
    auto next_sign = std::chrono::steady_clock::now();
    const auto give_sign = [&] {
        if (std::chrono::steady_clock::now() < next_sign) return;
        next_sign += lock_sign_interval;
        lock.give_sign();
    };
    resilient_store_.store().problem();  // Creates a folder that was removed.
    const BuiltTable built =
        engine::run_builder(settings_.command, build.spec, output, *build.job, build.report, give_sign);
    if (!built.bytes.empty()) return resilient_store_.keep_unsaved(from_ic_file(built.bytes, output), built.problem);
    auto record = std::make_shared<const IcRecord>(read_ic_file(output));
    resilient_store_.note_stored(build.spec, build.keys_in_use());
    return record;
}

void IcBuilds::fail(const TableBuild& build, const Status& status) {
    ++counters_.builds_failed;
    log_.error(std::format("{} failed: {}", build.job->name, status.message));
    build.failed(status);
}

}  // namespace contactd::engine
