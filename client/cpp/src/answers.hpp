// What the daemon says of itself, read from replies that have passed their schemas.
#pragma once

#include <nlohmann/json.hpp>

#include "contactd/client/server_info.hpp"

namespace contactd::client {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ServerLimits, max_frame_bytes, max_frames, max_message_bytes, max_array_elements,
                                   max_grid_elements, max_queue, max_queue_per_client, max_queue_bytes, max_sessions,
                                   max_session_bytes, max_session_states, max_lease_seconds)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ServerCounters, requests, requests_failed, solves, builds_started, builds_finished,
                                   builds_failed, builds_cancelled, builds_joined, memory_hits, disk_hits, closed_form,
                                   tables_set_aside)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CacheUse, tables, bytes, budget_bytes)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(QueueLengths, solves_waiting, solves_running, builds_waiting, builds_running)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ServerInfo, version, commit, protocol, protocol_versions, libraries, limits,
                                   counters, cache, queue, uptime_seconds)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(MetricBucket, le, count)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(MetricSample, labels, value, count, sum, buckets)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Metric, name, type, help, samples)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SessionSummary, age_seconds, idle_seconds, lease_seconds, step, states, bytes,
                                   elements)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(StoredIc, key, nx, ny, bytes)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(QuarantinedIc, key, nx, ny, failures, message, seconds)

inline void from_json(const nlohmann::json& source, Job& job) {
    source["job"].get_to(job.job);
    source["kind"].get_to(job.kind);
    source["state"].get_to(job.state);
    source["stage"].get_to(job.stage);
    source["fraction"].get_to(job.fraction);
    source["callers"].get_to(job.callers);
    source["seconds"].get_to(job.seconds);
    if (source.contains("seconds_left")) job.seconds_left = source["seconds_left"].get<double>();
    if (source.contains("memory_bytes")) job.memory_bytes = source["memory_bytes"].get<std::uint64_t>();
}

}  // namespace contactd::client
