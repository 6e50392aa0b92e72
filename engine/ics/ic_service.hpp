// Provides influence coefficients on request: from the memory cache, the store, a closed form, or a build shared by all
// requests.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "contactd/ic_store.hpp"
#include "contactd/proto/status.hpp"
#include "engine/ics/cache/ic_cache.hpp"
#include "ic_builds.hpp"

namespace contactd::engine {

/// Holds a dimensionless record that covers the request, and its origin.
struct IcAnswer {
    std::shared_ptr<const IcRecord> record;
    std::string key;
    std::string origin;  ///< "closed_form", "memory", "disk" or "built"
    TableOwner owner{};  ///< the user who imported the table, if it serves only this user

    /// Returns the key of the table in caches.
    std::string cache_key() const { return owner.empty() ? key : key + " of " + owner; }
};

/// Holds callbacks of a request, called from any thread. `done` or `failed` is called exactly once.
struct IcCaller {
    std::function<void(const IcAnswer&)> done;
    std::function<void(const proto::Status&)> failed;
    std::function<void(const Job&, const JobProgress&)> progress;
    QueueTicket ticket{};  ///< for a build that this caller requests first; reports whether the caller still waits

    bool has_gone() const { return ticket.abandoned && ticket.abandoned(); }
};

class IcService {
   public:
    struct Settings {
        BuilderCommand command;
        int concurrent_builds = 1;
        std::size_t memory_budget_bytes = 0;  ///< for tables in memory, and for those that wait for the disk
        std::uintmax_t disk_budget_bytes = 0;
        BuildQuarantine::Settings quarantine = {};
        bool shares_imported_tables = false;  ///< true if imported tables serve all users
        LogSink log = {};
        /// Returns whether a user may build tables; empty: all may. Existing tables serve all users.
        std::function<bool(const std::string& user)> may_build = {};
    };

    IcService(Settings settings, IcStore store, JobTable& jobs, EngineCounters& counters);
    ~IcService();

    /// Answers `caller` now or later. Takes up to some milliseconds (disk, closed form), so do not call it in the I/O
    /// thread.
    void request(const IcSpec& spec, IcCaller caller);

    /// Lets callers that no longer wait release their resources; their tables are built anyway.
    void drop_abandoned();

    /// Stores a table imported by `user`, a record of stored_record() that does not exist yet: for this user only, or
    /// for all users if imported tables are shared. Throws StoreError.
    void keep_imported(IcRecord record, const std::string& user);
    /// Returns the table on disk that serves this user without a build, if any.
    std::optional<IcRecord> stored_for(const IcSpec& spec, const std::string& user);

    /// Ends running builds, whose callers get `status`. No build starts afterwards.
    void stop(const proto::Status& status);

    struct Forgotten {
        int tables = 0;
        bool failures = false;
    };
    /// Removes the tables of a key from disk and memory, except those imported by other users, and forgets its failed
    /// builds. Throws StoreError.
    Forgotten forget(const std::string& key, const std::string& user);
    /// Returns all files of the store that serve this user. Throws StoreError.
    std::vector<StoredTable> stored(const std::string& user) const;

    const IcStore& store() const { return resilient_store_.store(); }
    std::vector<BuildQuarantine::Entry> quarantined() { return builds_.quarantine().entries(); }
    /// Returns the reason why the store cannot be used, as a sentence; empty if it can.
    std::string store_problem() const { return resilient_store_.problem(); }
    IcCache::Usage cache_usage() const { return cache_.usage(); }
    int builds_waiting() const { return builds_.waiting(); }
    int builds_running() const { return builds_.running(); }

   private:
    struct RequestInFlight;
    using RequestPtr = std::shared_ptr<RequestInFlight>;

    void answer(const IcCaller& caller, const std::string& key, IcCache::Record record, const char* origin);
    TableOwner owner_of(const std::string& user) const;
    bool answer_imported(const IcSpec& spec, const std::string& key, const IcCaller& caller);
    RequestPtr join_or_open(const IcSpec& spec, const std::string& key, IcCaller& caller, bool& opened);
    void look_up(const RequestPtr& request);
    bool deny_build(const RequestPtr& request);
    bool queue_build(const RequestPtr& request);
    void report(const RequestPtr& request, const JobProgress& progress);
    std::vector<std::string> keys_in_flight();
    std::vector<std::string> users_of(const std::weak_ptr<RequestInFlight>& request);
    void cancel_queued(const RequestPtr& request);
    void complete(const RequestPtr& request, IcCache::Record record, const char* origin);
    void fail(const RequestPtr& request, const proto::Status& status);
    std::vector<IcCaller> close(const RequestPtr& request);
    proto::Status cancelled_status();

    const Settings settings_;
    const EngineLog log_;
    ResilientStore resilient_store_;
    JobTable& jobs_;
    EngineCounters& counters_;
    IcCache cache_;
    std::mutex mutex_;                   // guards the members below
    std::vector<RequestPtr> in_flight_;  // looking up, queued or building
    bool stopping_ = false;
    proto::Status stop_status_;
    IcBuilds builds_;  // is destroyed first, because its threads use everything above
};

}  // namespace contactd::engine
