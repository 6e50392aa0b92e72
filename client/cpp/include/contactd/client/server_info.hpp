// Describes status reports of the daemon, with the names of docs/protocol.md.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "contactd/grid.hpp"
#include "contactd/ic_reply.hpp"
#include "contactd/message_limits.hpp"

namespace contactd::client {

/// Holds limits of a message, of the queue and of sessions.
struct ServerLimits : MessageLimits {
    std::size_t max_grid_elements = 0;      ///< elements of one grid, offsets of one table
    std::int64_t max_queue = 0;             ///< requests that may wait for an answer
    std::int64_t max_queue_per_client = 0;  ///< limit for requests from one socket
    std::size_t max_queue_bytes = 0;        ///< bytes of the messages whose requests wait for an answer
    std::int64_t max_sessions = 0;
    std::size_t max_session_bytes = 0;    ///< bytes of all sessions and their saved states together
    std::int64_t max_session_states = 0;  ///< saved states of one session
    double max_lease_seconds = 0;         ///< longest lease of a session
};

/// Counts since the start.
struct ServerCounters {
    std::int64_t requests = 0;         ///< answered
    std::int64_t requests_failed = 0;  ///< answered with another status than OK
    std::int64_t solves = 0;           ///< contact problems solved
    std::int64_t builds_started = 0, builds_finished = 0, builds_failed = 0, builds_cancelled = 0;
    std::int64_t builds_joined = 0;                                ///< requests that joined a running build
    std::int64_t memory_hits = 0, disk_hits = 0, closed_form = 0;  ///< returned tables by origin
    std::int64_t tables_set_aside = 0;                             ///< damaged ones
};

/// Tables in memory.
struct CacheUse {
    std::int64_t tables = 0;
    std::size_t bytes = 0, budget_bytes = 0;  ///< current and allowed size
};

/// Holds numbers of waiting and running solves and builds.
struct QueueLengths {
    std::int64_t solves_waiting = 0, solves_running = 0;
    std::int64_t builds_waiting = 0, builds_running = 0;
};

struct ServerInfo {
    std::string version;                           ///< of contactd
    std::string commit;                            ///< of its sources
    int protocol = 0;                              ///< version of its answers
    std::vector<int> protocol_versions;            ///< supported versions, oldest first
    std::map<std::string, std::string> libraries;  ///< their versions by name
    ServerLimits limits;
    ServerCounters counters;
    CacheUse cache;
    QueueLengths queue;
    double uptime_seconds = 0;  ///< since its start
};

/// Holds cumulative observations of a histogram up to a bound.
struct MetricBucket {
    double le = 0;  ///< the bound
    std::int64_t count = 0;
};

/// Holds the value of a metric for a combination of labels.
struct MetricSample {
    std::map<std::string, std::string> labels;  ///< their values by name
    double value = 0;                           ///< of a counter or a gauge
    std::int64_t count = 0;                     ///< number of observations of a histogram
    double sum = 0;                             ///< their sum
    std::vector<MetricBucket> buckets;
};

/// Describes a metric of the daemon, as docs/operations.md lists it and Prometheus reads it.
struct Metric {
    std::string name;  ///< with its unit
    std::string type;  ///< "counter", "gauge" or "histogram"
    std::string help;  ///< description
    std::vector<MetricSample> samples;
};

/// Describes a waiting or running job of the daemon.
struct Job {
    std::string job;                              ///< its name
    std::string kind;                             ///< "build", "solve", "subsurface" or "step"
    std::string state;                            ///< "queued" or "running"
    std::string stage;                            ///< empty while queued
    double fraction = 0;                          ///< 0..1, an estimate
    int callers = 0;                              ///< requests that wait for it
    double seconds = 0;                           ///< since it was queued
    std::optional<double> seconds_left{};         ///< last estimate of the remaining time of a build
    std::optional<std::uint64_t> memory_bytes{};  ///< estimated largest memory of a build
    std::vector<std::string> users{};  ///< users of waiting requests: names of keys, IP addresses, or uid:NUMBER
    std::string description{};         ///< description of the build or solve in words
};

/// Describes a session. Its name is not listed, because any client with the name can use the session.
struct SessionSummary {
    double age_seconds = 0;     ///< since it was opened
    double idle_seconds = 0;    ///< since its last request ended, 0 during one
    double lease_seconds = 0;   ///< idle time after which it ends
    std::int64_t step = 0;      ///< number of its last step
    std::int64_t states = 0;    ///< saved ones
    std::size_t bytes = 0;      ///< counted towards limits.max_session_bytes, including saved states
    std::int64_t elements = 0;  ///< of its grid
};

/// Describes a table in the daemon's store.
struct StoredIc {
    std::string key;                       ///< argument of delete_ic
    int nx = 0, ny = 0;                    ///< offsets along x and y
    std::size_t bytes = 0;                 ///< of its file
    std::optional<IcEvidence> evidence{};  ///< how it was made, if requested and its file can be read
};

/// Describes a table whose builds failed too often. It and larger ones with its key are not built again for now.
struct QuarantinedIc {
    std::string key;      ///< argument of delete_ic, which ends the quarantine
    int nx = 0, ny = 0;   ///< offsets along x and y
    int failures = 0;     ///< builds that failed
    std::string message;  ///< message of the last failure
    double seconds = 0;   ///< until the next build is allowed
};

/// Describes one of the last solves of the requesting user.
struct RecentSolve {
    std::int64_t number = 0;     ///< argument of recent_pressures; counts the solves of all users since the start
    std::string method;          ///< requested method
    std::string id;              ///< of the request
    double at = 0;               ///< when it ended (s since 1970)
    double seconds = 0;          ///< time from its start to its end
    std::optional<Grid> grid{};  ///< grid of a contact; empty for wheels on rails
    std::int64_t elements = 0;   ///< elements of its grid; for wheels on rails of all patches
    std::int64_t patches = 0;    ///< number of grids: one, or for wheels on rails one per place of contact
    bool converged = false;      ///< whether every solver reached its tolerance
    int iterations = 0;          ///< iterations of the normal and the tangential solvers together
    double residual = 0;         ///< largest value that a solver compared with its tolerance
    std::array<double, 3>
        forces{};     ///< Fx, Fy, Fn on the upper body; for wheels Fx, Fy, Fz on the rails, in track coordinates (N)
    double pmax = 0;  ///< (N/mm^2)
    bool has_pressures = false;  ///< whether recent_pressures can return them
};

/// Holds the pressures on a grid of a solve, rounded to single precision. Arrays have shape [ny, nx].
struct RecentPatch {
    Grid grid;                                      ///< for wheels on rails in contact coordinates (mm)
    std::vector<double> pressure{};                 ///< (N/mm^2)
    std::vector<unsigned char> element_division{};  ///< 0 exterior, 1 adhesion, 2 slip
};

}  // namespace contactd::client
