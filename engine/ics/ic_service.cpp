#include "ic_service.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "contactd/closed_form_record.hpp"
#include "contactd/error.hpp"
#include "contactd/ic_family.hpp"
#include "contactd/strip_frames.hpp"
#include "description.hpp"

namespace contactd::engine {

using proto::Status;
using proto::StatusCode;

namespace {

Status request_abandoned() {
    return failure(StatusCode::cancelled, proto::reason::request_cancelled,
                   "The request was abandoned because its caller disconnected.");
}

/// Ends work in the thread of a request when the request is abandoned.
class WhileRequested final : public Observer {
   public:
    explicit WhileRequested(const IcCaller& caller) : caller_(caller) {}
    bool cancelled() const override { return caller_.has_gone(); }

   private:
    const IcCaller& caller_;
};

}  // namespace

/// Holds a table being fetched and the callers waiting for it.
struct IcService::RequestInFlight {
    IcSpec spec;  // dimensionless
    std::string key;
    std::shared_ptr<Job> job;  // is null until a build is needed
    std::vector<IcCaller> callers;
    std::string description{};  // describes the first caller's request, with its lengths

    bool serves(const std::string& request, const IcSpec& other) const {
        return key == request && spec.nx >= other.nx && spec.ny >= other.ny && !(job && job->cancelled());
    }
};

IcService::IcService(Settings settings, IcStore store, JobTable& jobs, EngineCounters& counters)
    : settings_(std::move(settings)),
      log_(settings_.log),
      resilient_store_(std::move(store), {settings_.disk_budget_bytes, settings_.memory_budget_bytes}, log_),
      jobs_(jobs),
      counters_(counters),
      cache_(settings_.memory_budget_bytes),
      builds_({settings_.command, settings_.concurrent_builds, settings_.quarantine}, resilient_store_, counters_,
              log_) {}

IcService::~IcService() {
    stop(failure(StatusCode::unavailable, proto::reason::stopping,
                 "No more tables are built because the service is closing."));
}

void IcService::request(const IcSpec& spec, IcCaller caller) {
    const std::string key = ic_key(spec);
    for (const IcCache::Record& stored : resilient_store_.recover()) cache_.insert(ic_key(stored->spec), stored);
    if (auto record = cache_.find(key, spec.nx, spec.ny)) {
        ++counters_.memory_hits;
        resilient_store_.note_use(key, *record);
        return answer(caller, key, std::move(record), "memory");
    }
    if (spec.source == IcSource::analytic) {
        const WhileRequested observer(caller);
        IcCache::Record record;
        try {
            record = std::make_shared<const IcRecord>(closed_form_record(spec, observer));
        } catch (const Cancelled&) {
            return caller.failed(request_abandoned());
        }
        cache_.insert(key, record);
        ++counters_.closed_form;
        return answer(caller, key, std::move(record), "closed_form");
    }
    if (answer_imported(spec, key, caller)) return;
    (void)strip_frames(spec);  // Reports a bad section in the request's lengths; the build uses strips of 1.
    bool opened = false;
    const RequestPtr request = join_or_open(spec, key, caller, opened);
    if (opened) look_up(request);
}

void IcService::answer(const IcCaller& caller, const std::string& key, IcCache::Record record, const char* origin) {
    caller.done({std::move(record), key, origin, {}});
}

TableOwner IcService::owner_of(const std::string& user) const {
    return settings_.shares_imported_tables ? TableOwner() : user;
}

/// Prefers tables that the daemon has built to tables that the caller has imported.
bool IcService::answer_imported(const IcSpec& spec, const std::string& key, const IcCaller& caller) {
    const TableOwner owner = owner_of(caller.ticket.user);
    if (owner.empty() || resilient_store_.may_have(spec, {})) return false;
    IcAnswer found{nullptr, key, "memory", owner};
    found.record = cache_.find(found.cache_key(), spec.nx, spec.ny);
    if (found.record) {
        ++counters_.memory_hits;
    } else if (auto stored = resilient_store_.find(spec, owner)) {
        ++counters_.disk_hits;
        found.origin = "disk";
        found.record = std::make_shared<const IcRecord>(std::move(*stored));
        cache_.insert(found.cache_key(), found.record);
    }
    if (!found.record) return false;
    resilient_store_.note_use(key, *found.record, owner);
    caller.done(found);
    return true;
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
    auto request =
        std::make_shared<RequestInFlight>(RequestInFlight{dimensionless(spec), key, nullptr, {}, description(spec)});
    request->callers.push_back(std::move(caller));
    in_flight_.push_back(request);
    opened = true;
    return request;
}

void IcService::look_up(const RequestPtr& request) {
    // A request completed since the cache was searched has stored its table there.
    if (auto record = cache_.find(request->key, request->spec.nx, request->spec.ny)) {
        ++counters_.memory_hits;
        resilient_store_.note_use(request->key, *record);
        return complete(request, std::move(record), "memory");
    }
    if (auto record = resilient_store_.find(request->spec)) {
        ++counters_.disk_hits;
        return complete(request, std::make_shared<const IcRecord>(std::move(*record)), "disk");
    }
    if (const auto refusal = builds_.quarantine().refusal(request->key, request->spec)) return fail(request, *refusal);
    if (!deny_build(request) && !queue_build(request)) fail(request, stop_status_);
}

/// Refuses callers that may not build. Returns true if no caller is left and the request has ended.
bool IcService::deny_build(const RequestPtr& request) {
    if (!settings_.may_build) return false;
    std::vector<IcCaller> denied;
    bool is_empty = false;
    {
        const std::scoped_lock lock(mutex_);
        std::vector<IcCaller>& callers = request->callers;
        const auto first = std::stable_partition(callers.begin(), callers.end(), [this](const IcCaller& caller) {
            return settings_.may_build(caller.ticket.user);
        });
        std::move(first, callers.end(), std::back_inserter(denied));
        callers.erase(first, callers.end());
        is_empty = callers.empty();
        if (is_empty) std::erase(in_flight_, request);
    }
    const Status status = failure(proto::StatusCode::permission_denied, proto::reason::build_denied,
                                  "This table does not exist yet, and you are not among the users who may build tables "
                                  "(methods.allowed_users, builds).");
    for (const IcCaller& caller : denied) caller.failed(status);
    return is_empty;
}

/// Returns false if no more builds may begin.
bool IcService::queue_build(const RequestPtr& request) {
    const std::scoped_lock lock(mutex_);
    if (stopping_) return false;
    const std::weak_ptr waiting(request);
    JobOrigin origin{"build", request->description, [this, waiting] { return users_of(waiting); }};
    request->job = jobs_.create(std::move(origin), [this, waiting] {
        if (const RequestPtr known = waiting.lock()) cancel_queued(known);
    });
    for (const IcCaller& caller : request->callers) caller.progress(*request->job, request->job->progress());
    // A build continues for the cache after its callers have gone.
    QueueTicket ticket = request->callers.empty() ? QueueTicket{} : request->callers.front().ticket;
    ticket.abandoned = nullptr;
    builds_.queue(std::move(ticket),
                  {request->spec, request->key, request->job,
                   [this, request](const JobProgress& progress) { report(request, progress); },
                   [this, request](IcCache::Record record, const char* origin_of_it) {
                       complete(request, std::move(record), origin_of_it);
                   },
                   [this, request](const Status& status) { fail(request, status); },
                   [this, request] { fail(request, cancelled_status()); }, [this] { return keys_in_flight(); }});
    return true;
}

void IcService::report(const RequestPtr& request, const JobProgress& progress) {
    request->job->set_progress(progress);
    const std::scoped_lock lock(mutex_);
    for (const IcCaller& caller : request->callers) caller.progress(*request->job, progress);
}

Status IcService::cancelled_status() {
    const std::scoped_lock lock(mutex_);
    return stopping_ ? stop_status_
                     : failure(StatusCode::cancelled, proto::reason::job_cancelled, "The build was cancelled.");
}

void IcService::cancel_queued(const RequestPtr& request) {
    if (request->job->running()) return;  // The builder's thread detects the cancellation itself.
    ++counters_.builds_cancelled;
    fail(request, cancelled_status());
}

std::vector<IcCaller> IcService::close(const RequestPtr& request) {
    const std::scoped_lock lock(mutex_);
    std::erase(in_flight_, request);
    if (request->job) request->job->end();
    return std::exchange(request->callers, {});
}

void IcService::complete(const RequestPtr& request, IcCache::Record record, const char* origin) {
    cache_.insert(request->key, record);  // Must come first, so that new callers find it there.
    for (const IcCaller& caller : close(request)) answer(caller, request->key, record, origin);
}

void IcService::fail(const RequestPtr& request, const Status& status) {
    for (const IcCaller& caller : close(request)) caller.failed(status);
}

std::vector<std::string> IcService::users_of(const std::weak_ptr<RequestInFlight>& request) {
    std::vector<std::string> users;
    const RequestPtr known = request.lock();
    if (!known) return users;
    const std::scoped_lock lock(mutex_);
    for (const IcCaller& caller : known->callers)
        if (!caller.has_gone()) users.push_back(caller.ticket.user);
    return users;
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
    const Status status = request_abandoned();
    for (const IcCaller& caller : gone) caller.failed(status);
}

std::vector<std::string> IcService::keys_in_flight() {
    const std::scoped_lock lock(mutex_);
    std::vector<std::string> keys;
    for (const RequestPtr& request : in_flight_) keys.push_back(request->key);
    return keys;
}

IcService::Forgotten IcService::forget(const std::string& key, const std::string& user) {
    const TableOwner owner = owner_of(user);
    Forgotten forgotten{resilient_store_.remove(key, owner), builds_.quarantine().forget(key)};
    cache_.remove(key);
    cache_.remove(IcAnswer{nullptr, key, "", owner}.cache_key());
    return forgotten;
}

std::vector<StoredTable> IcService::stored(const std::string& user) const {
    std::vector<StoredTable> tables = store().list();
    std::erase_if(tables, [&](const StoredTable& table) { return !table.owner.empty() && table.owner != user; });
    return tables;
}

std::optional<IcRecord> IcService::stored_for(const IcSpec& spec, const std::string& user) {
    if (auto built = resilient_store_.find(spec)) return built;
    const TableOwner owner = owner_of(user);
    return owner.empty() ? std::nullopt : resilient_store_.find(spec, owner);
}

void IcService::keep_imported(IcRecord record, const std::string& user) {
    if (const std::string problem = store().problem(); !problem.empty()) throw StoreError(problem);
    const TableOwner owner = owner_of(user);
    const std::string key = ic_key(record.spec);
    const IcAnswer answer{std::make_shared<const IcRecord>(std::move(record)), key, "file", owner};
    if (owner.empty()) builds_.quarantine().forget(key);  // Earlier failed builds are no longer relevant.
    const auto [nx, ny] = extent_of(answer.record->tables);
    write_ic_file(store().path_to_write(key, nx, ny, owner), *answer.record);
    resilient_store_.note_stored(answer.record->spec, keys_in_flight(), owner);
    cache_.insert(answer.cache_key(), answer.record);
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
        if (request->job) request->job->cancel();  // Answers callers of a queued build; called without the lock.
    builds_.stop();
    for (const RequestPtr& request : in_flight) fail(request, status);
}

}  // namespace contactd::engine
