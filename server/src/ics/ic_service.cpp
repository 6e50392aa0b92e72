#include "ic_service.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <utility>

#include "contactd/error.hpp"
#include "contactd/half_space.hpp"
#include "contactd/ic_family.hpp"
#include "contactd/version.hpp"
#include "ic_flight.hpp"

namespace contactd::server {

using proto::Status;
using proto::StatusCode;

namespace {

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
      keeper_(std::move(store), {settings_.disk_budget_bytes, settings_.memory_budget_bytes}),
      jobs_(jobs),
      counters_(counters),
      cache_(settings_.memory_budget_bytes),
      quarantine_(settings_.quarantine),
      builders_(settings_.concurrent_builds) {}

IcService::~IcService() {
    stop(failure(StatusCode::unavailable, proto::reason::stopping, "The daemon is ending."));
}

void IcService::request(const IcSpec& spec, IcCaller caller) {
    const std::string key = ic_key(spec);
    for (const IcCache::Record& stored : keeper_.recover()) cache_.insert(ic_key(stored->spec), stored);
    if (auto record = cache_.find(key, spec.nx, spec.ny)) {
        ++counters_.memory_hits;
        keeper_.note_use(key, *record);
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
        if (flight.job) caller.progress(*flight.job, flight.job->progress());
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
        keeper_.note_use(flight->key, *record);
        return land(flight, std::move(record), "memory");
    }
    if (auto record = keeper_.find(flight->spec)) {
        ++counters_.disk_hits;
        return land(flight, std::make_shared<const IcRecord>(std::move(*record)), "disk");
    }
    if (const auto refusal = quarantine_.refusal(flight->key, flight->spec)) return crash(flight, *refusal);
    if (!queue_build(flight)) crash(flight, stop_status_);
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

int IcService::callers_of(const std::weak_ptr<Flight>& flight) {
    const FlightPtr known = flight.lock();
    if (!known) return 0;
    const std::scoped_lock lock(mutex_);
    return static_cast<int>(std::count_if(known->callers.begin(), known->callers.end(),
                                          [](const IcCaller& caller) { return !caller.has_gone(); }));
}

void IcService::drop_abandoned() {
    std::vector<IcCaller> gone;
    {
        const std::scoped_lock lock(mutex_);
        for (const FlightPtr& flight : flights_) {
            const auto first = std::stable_partition(flight->callers.begin(), flight->callers.end(),
                                                     [](const IcCaller& caller) { return !caller.has_gone(); });
            std::move(first, flight->callers.end(), std::back_inserter(gone));
            flight->callers.erase(first, flight->callers.end());
        }
    }
    const Status status = failure(StatusCode::cancelled, proto::reason::request_cancelled, "Nobody waits any more.");
    for (const IcCaller& caller : gone) caller.failed(status);
}

std::vector<std::string> IcService::keys_in_flight() {
    const std::scoped_lock lock(mutex_);
    std::vector<std::string> keys;
    for (const FlightPtr& flight : flights_) keys.push_back(flight->key);
    return keys;
}

IcService::Forgotten IcService::forget(const std::string& key) {
    Forgotten forgotten{keeper_.remove(key), quarantine_.forget(key)};
    cache_.remove(key);
    return forgotten;
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
