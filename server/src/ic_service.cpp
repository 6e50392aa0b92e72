#include "ic_service.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "contactd/error.hpp"
#include "contactd/half_space.hpp"
#include "contactd/ic_family.hpp"
#include "contactd/version.hpp"
#include "store_folder.hpp"

namespace contactd::server {

using proto::Status;
using proto::StatusCode;

/// One table being fetched, and everybody who waits for it.
struct IcService::Flight {
    IcSpec spec;  // dimensionless
    std::string key;
    std::shared_ptr<Job> job;  // null until it is known that a build is needed
    std::vector<IcCaller> callers;

    bool serves(const std::string& wanted, const IcSpec& other) const {
        return key == wanted && spec.nx >= other.nx && spec.ny >= other.ny && !(job && job->cancelled());
    }
};

namespace {

Status failure(StatusCode code, std::string_view reason, std::string message) {
    return {code, std::move(message), std::string(reason), {}, 0};
}

/// Notes what a build took, and what the store holds afterwards.
class BuildClock {
   public:
    BuildClock(Counters& counters, const std::filesystem::path& folder) : counters_(counters), folder_(folder) {}
    ~BuildClock() {
        const auto spent = std::chrono::steady_clock::now() - start_;
        counters_.build_milliseconds += std::chrono::duration_cast<std::chrono::milliseconds>(spent).count();
        count_store(counters_, folder_);
    }
    BuildClock(const BuildClock&) = delete;
    BuildClock& operator=(const BuildClock&) = delete;

   private:
    Counters& counters_;
    const std::filesystem::path& folder_;
    const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

IcRecord closed_form(const IcSpec& dimensionless_spec) {
    IcRecord record{dimensionless_spec, half_space_table(dimensionless_spec), {}, {}};
    record.evidence.source = name_of(IcSource::analytic);
    record.evidence.version = "contactd " + version();
    return record;
}

}  // namespace

void validate_body(const IcSpec& spec, const std::string& name) {
    try {
        validate(spec);
    } catch (const InvalidArgument& error) {
        const std::string& field = error.field();
        constexpr std::string_view prefix = "material";
        if (!field.starts_with(prefix)) throw;
        throw InvalidArgument(name + field.substr(prefix.size()), std::string(error.what()).substr(field.size() + 1));
    }
}

IcTable table_of(const IcAnswer& answer, const IcSpec& request) {
    const IcTable table = table_for(*answer.record, request.material.nu);
    return scaled(cropped(table, request.nx, request.ny), request.dx / request.material.G);
}

IcService::IcService(Settings settings, IcStore store, JobTable& jobs, Counters& counters)
    : settings_(std::move(settings)),
      store_(std::move(store)),
      jobs_(jobs),
      counters_(counters),
      cache_(settings_.memory_budget_bytes),
      builders_(settings_.concurrent_builds) {
    if (const int swept = store_.sweep()) spdlog::warn("swept {} left-over files from the store", swept);
}

IcService::~IcService() {
    stop(failure(StatusCode::unavailable, proto::reason::stopping, "The daemon is ending."));
}

void IcService::request(const IcSpec& spec, IcCaller caller) {
    const std::string key = ic_key(spec);
    if (auto record = cache_.find(key, spec.nx, spec.ny)) {
        ++counters_.memory_hits;
        return answer(caller, key, std::move(record), "memory");
    }
    if (spec.source == IcSource::analytic) {
        auto record = std::make_shared<const IcRecord>(closed_form(dimensionless(spec)));
        cache_.insert(key, record);
        ++counters_.closed_form;
        return answer(caller, key, std::move(record), "closed_form");
    }
    bool opened = false;
    const FlightPtr flight = join_or_open(spec, key, caller, opened);
    if (opened) look_up(flight);
}

void IcService::answer(const IcCaller& caller, const std::string& key, IcCache::Record record, const char* origin) {
    caller.done({std::move(record), key, origin});
}

IcService::FlightPtr IcService::join_or_open(const IcSpec& spec, const std::string& key, IcCaller& caller,
                                             bool& opened) {
    const std::scoped_lock lock(mutex_);
    const auto serving =
        std::find_if(flights_.begin(), flights_.end(), [&](const FlightPtr& f) { return f->serves(key, spec); });
    if (serving != flights_.end()) {
        Flight& flight = **serving;
        if (flight.job) {
            ++flight.job->callers;
            caller.progress(*flight.job, flight.job->progress());
        }
        flight.callers.push_back(std::move(caller));
        ++counters_.builds_joined;
        return *serving;
    }
    auto flight = std::make_shared<Flight>(Flight{dimensionless(spec), key, nullptr, {}});
    flight->callers.push_back(std::move(caller));
    flights_.push_back(flight);
    opened = true;
    return flight;
}

void IcService::look_up(const FlightPtr& flight) {
    // A flight that landed between our look into the cache and opening this one has left its table in the cache.
    if (auto record = cache_.find(flight->key, flight->spec.nx, flight->spec.ny)) {
        ++counters_.memory_hits;
        return land(flight, std::move(record), "memory");
    }
    try {
        if (auto record = store_.find(flight->spec)) {
            ++counters_.disk_hits;
            return land(flight, std::make_shared<const IcRecord>(std::move(*record)), "disk");
        }
    } catch (const std::exception& error) {
        spdlog::error("store: {}", error.what());
        return crash(flight, failure(StatusCode::internal, proto::reason::unexpected, error.what()));
    }
    if (!queue_build(flight)) crash(flight, stop_status_);
}

bool IcService::queue_build(const FlightPtr& flight) {
    const std::scoped_lock lock(mutex_);
    if (stopping_) return false;
    flight->job = jobs_.create("build", [this, waiting = std::weak_ptr(flight)] {
        if (const FlightPtr known = waiting.lock()) cancel_queued(known);
    });
    flight->job->callers = static_cast<int>(flight->callers.size());
    for (const IcCaller& caller : flight->callers) caller.progress(*flight->job, flight->job->progress());
    // A build goes on for the cache when its callers have gone.
    Turn turn = flight->callers.empty() ? Turn{} : flight->callers.front().turn;
    turn.abandoned = nullptr;
    builders_.post(std::move(turn), [this, flight] { build(flight); });
    return true;
}

Status IcService::cancelled_status() {
    const std::scoped_lock lock(mutex_);
    return stopping_ ? stop_status_
                     : failure(StatusCode::cancelled, proto::reason::job_cancelled, "The build was cancelled.");
}

void IcService::cancel_queued(const FlightPtr& flight) {
    if (flight->job->running()) return;  // the builder thread notices by itself
    ++counters_.builds_cancelled;
    crash(flight, cancelled_status());
}

void IcService::build(const FlightPtr& flight) {
    Job& job = *flight->job;
    if (job.cancelled()) return;  // while it was queued; its callers know
    const BuildClock clock(counters_, store_.folder());
    try {
        job.set_running();
        ++counters_.builds_started;
        spdlog::info("{} starts: key {} extent {} x {}", job.name, flight->key, flight->spec.nx, flight->spec.ny);
        const auto output = store_.path_of(flight->spec);
        run_builder(settings_.command, flight->spec, output, job, [&](const JobProgress& progress) {
            const std::scoped_lock lock(mutex_);
            for (const IcCaller& caller : flight->callers) caller.progress(job, progress);
        });
        auto record = std::make_shared<const IcRecord>(read_ic_file(output));
        store_.remove_covered_by(flight->spec);
        ++counters_.builds_finished;
        spdlog::info("{} finished", job.name);
        land(flight, std::move(record), "built");
    } catch (const Cancelled&) {
        ++counters_.builds_cancelled;
        spdlog::info("{} cancelled", job.name);
        crash(flight, cancelled_status());
    } catch (const std::exception& error) {
        ++counters_.builds_failed;
        spdlog::error("{} failed: {}", job.name, error.what());
        crash(flight, failure(StatusCode::internal, proto::reason::build_failed, error.what()));
    }
}

std::vector<IcCaller> IcService::close(const FlightPtr& flight) {
    const std::scoped_lock lock(mutex_);
    std::erase(flights_, flight);
    if (flight->job) flight->job->end();
    return std::exchange(flight->callers, {});
}

void IcService::land(const FlightPtr& flight, IcCache::Record record, const char* origin) {
    cache_.insert(flight->key, record);  // first, so that who comes now finds it there
    for (const IcCaller& caller : close(flight)) answer(caller, flight->key, record, origin);
}

void IcService::crash(const FlightPtr& flight, const Status& status) {
    for (const IcCaller& caller : close(flight)) caller.failed(status);
}

void IcService::stop(const Status& status) {
    std::vector<FlightPtr> flights;
    {
        const std::scoped_lock lock(mutex_);
        stopping_ = true;
        stop_status_ = status;
        flights = flights_;
    }
    for (const FlightPtr& flight : flights)
        if (flight->job) flight->job->cancel();  // answers those who wait for a queued build, so not under the lock
    builders_.stop();
    for (const FlightPtr& flight : flights) crash(flight, status);
}

}  // namespace contactd::server
