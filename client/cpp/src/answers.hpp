// Reads status reports of the daemon from replies that have passed their schemas.
#pragma once

#include <nlohmann/json.hpp>

#include "contactd/client/server_info.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/proto/grid.hpp"

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
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(QuarantinedIc, key, nx, ny, failures, message, seconds)

inline void from_json(const nlohmann::json& source, StoredIc& table) {
    source["key"].get_to(table.key);
    source["nx"].get_to(table.nx);
    source["ny"].get_to(table.ny);
    source["bytes"].get_to(table.bytes);
    if (source.contains("evidence")) table.evidence = proto::decode_evidence(source["evidence"]);
}

inline void from_json(const nlohmann::json& source, RecentSolve& solve) {
    source["number"].get_to(solve.number);
    source["method"].get_to(solve.method);
    source["id"].get_to(solve.id);
    source["at"].get_to(solve.at);
    source["seconds"].get_to(solve.seconds);
    if (source.contains("grid")) solve.grid = proto::decode_grid(source["grid"]);
    source["elements"].get_to(solve.elements);
    source["patches"].get_to(solve.patches);
    source["converged"].get_to(solve.converged);
    source["iterations"].get_to(solve.iterations);
    source["residual"].get_to(solve.residual);
    source["forces"].get_to(solve.forces);
    source["pmax"].get_to(solve.pmax);
    source["has_pressures"].get_to(solve.has_pressures);
}

/// Throws StatusError for arrays that do not match their grids.
inline std::vector<RecentPatch> read_patches(const nlohmann::json& source, const proto::Frames& frames) {
    std::vector<RecentPatch> patches;
    for (const nlohmann::json& patch : source) {
        const Grid grid = proto::decode_grid(patch["grid"]);
        const std::vector<std::size_t> shape{static_cast<std::size_t>(grid.ny), static_cast<std::size_t>(grid.nx)};
        patches.push_back({grid, proto::read_array(patch["pressure"], frames, shape, "pressure"),
                           proto::read_byte_array(patch["element_division"], frames, shape, "element_division")});
    }
    return patches;
}

inline void from_json(const nlohmann::json& source, Job& job) {
    source["job"].get_to(job.job);
    source["kind"].get_to(job.kind);
    source["state"].get_to(job.state);
    source["stage"].get_to(job.stage);
    source["fraction"].get_to(job.fraction);
    source["callers"].get_to(job.callers);
    source["seconds"].get_to(job.seconds);
    if (source.contains("seconds_left")) job.seconds_left = source["seconds_left"].get<double>();
    if (source.contains("users")) source["users"].get_to(job.users);
    if (source.contains("description")) source["description"].get_to(job.description);
    if (source.contains("memory_bytes")) job.memory_bytes = source["memory_bytes"].get<std::uint64_t>();
}

}  // namespace contactd::client
