#include "ic_service.hpp"

#include <algorithm>
#include <utility>

#include "contactd/closed_form_record.hpp"
#include "contactd/column_frames.hpp"
#include "contactd/error.hpp"
#include "contactd/ic_family.hpp"
#include "request_in_flight.hpp"

namespace contactd::engine {

using proto::Status;
using proto::StatusCode;

namespace {

Status nobody_waits() {
    return failure(StatusCode::cancelled, proto::reason::request_cancelled, "Nobody waits any more.");
}

/// Ends what is made while it is waited for, when nobody waits any more.
class WhileWanted final : public Observer {
   public:
    explicit WhileWanted(const IcCaller& caller) : caller_(caller) {}
    bool cancelled() const override { return caller_.has_gone(); }

   private:
    const IcCaller& caller_;
};

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

IcService::IcService(Settings settings, IcStore store, JobTable& jobs, Counters& counters)
    : settings_(std::move(settings)),
      log_(settings_.log),
      keeper_(std::move(store), {settings_.disk_budget_bytes, settings_.memory_budget_bytes}, log_),
      jobs_(jobs),
      counters_(counters),
      cache_(settings_.memory_budget_bytes),
      quarantine_(settings_.quarantine),
      builders_(settings_.concurrent_builds) {}

IcService::~IcService() {
    stop(failure(StatusCode::unavailable, proto::reason::stopping, "No more tables are made here."));
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
        const WhileWanted observer(caller);
        IcCache::Record record;
        try {
            record = std::make_shared<const IcRecord>(closed_form_record(spec, observer));
        } catch (const Cancelled&) {
            return caller.failed(nobody_waits());
        }
        cache_.insert(key, record);
        ++counters_.closed_form;
        return answer(caller, key, std::move(record), "closed_form");
    }
    (void)column_frames(spec);  // tells of a bad section in the lengths of the request; what is built has columns of 1
    bool opened = false;
    const RequestPtr request = join_or_open(spec, key, caller, opened);
    if (opened) look_up(request);
}

void IcService::answer(const IcCaller& caller, const std::string& key, IcCache::Record record, const char* origin) {
    caller.done({std::move(record), key, origin});
}

IcService::RequestPtr IcService::join_or_open(const IcSpec& spec, const std::string& key, IcCaller& caller,
                                              bool& opened) {
    const std::scoped_lock lock(mutex_);
    const auto serving =
        std::find_if(in_flight_.begin(), in_flight_.end(), [&](const RequestPtr& r) { return r->serves(key, spec); });
    if (serving != in_flight_.end()) {
        RequestInFlight& request = **serving;
        if (request.job) caller.progress(*request.job, request.job->progress());
        request.callers.push_back(std::move(caller));
        ++counters_.builds_joined;
        return *serving;
    }
    auto request = std::make_shared<RequestInFlight>(RequestInFlight{dimensionless(spec), key, nullptr, {}});
    request->callers.push_back(std::move(caller));
    in_flight_.push_back(request);
    opened = true;
    return request;
}

void IcService::look_up(const RequestPtr& request) {
    // A request that was completed between our look into the cache and opening this one has left its table in the
    // cache.
    if (auto record = cache_.find(request->key, request->spec.nx, request->spec.ny)) {
        ++counters_.memory_hits;
        keeper_.note_use(request->key, *record);
        return complete(request, std::move(record), "memory");
    }
    if (auto record = keeper_.find(request->spec)) {
        ++counters_.disk_hits;
        return complete(request, std::make_shared<const IcRecord>(std::move(*record)), "disk");
    }
    if (const auto refusal = quarantine_.refusal(request->key, request->spec)) return fail(request, *refusal);
    if (!queue_build(request)) fail(request, stop_status_);
}

std::vector<IcCaller> IcService::close(const RequestPtr& request) {
    const std::scoped_lock lock(mutex_);
    std::erase(in_flight_, request);
    if (request->job) request->job->end();
    return std::exchange(request->callers, {});
}

void IcService::complete(const RequestPtr& request, IcCache::Record record, const char* origin) {
    cache_.insert(request->key, record);  // first, so that who comes now finds it there
    for (const IcCaller& caller : close(request)) answer(caller, request->key, record, origin);
}

void IcService::fail(const RequestPtr& request, const Status& status) {
    for (const IcCaller& caller : close(request)) caller.failed(status);
}

int IcService::callers_of(const std::weak_ptr<RequestInFlight>& request) {
    const RequestPtr known = request.lock();
    if (!known) return 0;
    const std::scoped_lock lock(mutex_);
    return static_cast<int>(std::count_if(known->callers.begin(), known->callers.end(),
                                          [](const IcCaller& caller) { return !caller.has_gone(); }));
}

void IcService::drop_abandoned() {
    std::vector<IcCaller> gone;
    {
        const std::scoped_lock lock(mutex_);
        for (const RequestPtr& request : in_flight_) {
            const auto first = std::stable_partition(request->callers.begin(), request->callers.end(),
                                                     [](const IcCaller& caller) { return !caller.has_gone(); });
            std::move(first, request->callers.end(), std::back_inserter(gone));
            request->callers.erase(first, request->callers.end());
        }
    }
    const Status status = nobody_waits();
    for (const IcCaller& caller : gone) caller.failed(status);
}

std::vector<std::string> IcService::keys_in_flight() {
    const std::scoped_lock lock(mutex_);
    std::vector<std::string> keys;
    for (const RequestPtr& request : in_flight_) keys.push_back(request->key);
    return keys;
}

IcService::Forgotten IcService::forget(const std::string& key) {
    Forgotten forgotten{keeper_.remove(key), quarantine_.forget(key)};
    cache_.remove(key);
    return forgotten;
}

void IcService::stop(const Status& status) {
    std::vector<RequestPtr> in_flight;
    {
        const std::scoped_lock lock(mutex_);
        stopping_ = true;
        stop_status_ = status;
        in_flight = in_flight_;
    }
    for (const RequestPtr& request : in_flight)
        if (request->job) request->job->cancel();  // answers those who wait for a queued build, so not under the lock
    builders_.stop();
    for (const RequestPtr& request : in_flight) fail(request, status);
}

}  // namespace contactd::engine
