// Implements server.* and health.watch: information about the daemon.
#include <chrono>
#include <string>
#include <utility>

#include "access/method_access.hpp"
#include "all_methods.hpp"
#include "collect_metrics.hpp"
#include "contactd/proto/schema.hpp"
#include "contactd/version.hpp"
#include "operation/builder_programs.hpp"
#include "operation/versions.hpp"

namespace contactd::server {

using nlohmann::json;

namespace {

void info(const CallPtr& call, const DaemonParts& parts) {
    json limits = proto::to_json(parts.config.limits);
    limits["max_grid_elements"] = parts.config.max_grid_elements;
    limits["max_queue"] = parts.config.max_queue;
    limits["max_queue_per_client"] = parts.config.max_queue_per_client;
    limits["max_queue_bytes"] = parts.config.max_queue_bytes;
    limits["max_sessions"] = parts.config.sessions.max_sessions;
    limits["max_session_bytes"] = parts.config.sessions.max_bytes;
    limits["max_session_states"] = parts.config.sessions.max_states;
    limits["max_lease_seconds"] = parts.config.sessions.max_lease_seconds;
    const Counters& counters = parts.counters;
    const engine::EngineCounters& done = parts.engine.counters();
    const engine::IcCache::Usage cache = parts.ics.cache_usage();
    call->succeed({{"version", version()},
                   {"commit", commit()},
                   {"protocol", proto::protocol_version},
                   {"protocol_versions", proto::protocol_versions},
                   {"libraries", parts.host.libraries},
                   {"limits", limits},
                   {"counters",
                    {{"requests", counters.requests.load()},
                     {"requests_failed", counters.requests_failed.load()},
                     {"solves", counters.solves.load()},
                     {"builds_started", done.builds_started.load()},
                     {"builds_finished", done.builds_finished.load()},
                     {"builds_failed", done.builds_failed.load()},
                     {"builds_cancelled", done.builds_cancelled.load()},
                     {"builds_joined", done.builds_joined.load()},
                     {"memory_hits", done.memory_hits.load()},
                     {"disk_hits", done.disk_hits.load()},
                     {"closed_form", done.closed_form.load()},
                     {"tables_set_aside", done.tables_set_aside.load()}}},
                   {"cache", {{"tables", cache.entries}, {"bytes", cache.bytes}, {"budget_bytes", cache.budget_bytes}}},
                   {"queue",
                    {{"solves_waiting", parts.workers.waiting()},
                     {"solves_running", parts.workers.running()},
                     {"builds_waiting", parts.ics.builds_waiting()},
                     {"builds_running", parts.ics.builds_running()}}},
                   {"uptime_seconds", std::chrono::duration<double>(Call::Clock::now() - parts.started).count()}});
}

void health(const CallPtr& call, const DaemonParts& parts) {
    json warnings = json::array();
    if (std::string problem = parts.ics.store_problem(); !problem.empty()) warnings.push_back(std::move(problem));
    for (std::string& problem : building_problems(parts.config)) warnings.push_back(std::move(problem));
    call->succeed({{"state", name_of(parts.health.state())}, {"warnings", std::move(warnings)}});
}

void describe(const CallPtr& call, const DaemonParts& parts) {
    const MethodRules& rules = parts.config.methods;
    const bool holds_for_all = rules.disabled.empty() && rules.allowed_users.empty();
    call->succeed(holds_for_all ? proto::openrpc() : described_for(rules, call->user(), proto::openrpc()));
}

void metrics(const CallPtr& call, const DaemonParts& parts) {
    call->succeed(server::to_json(collect_metrics(parts, false)));
}

void watch(const CallPtr& call, const DaemonParts& parts) {
    parts.health.watch(call);
}

void config(const CallPtr& call, const DaemonParts& parts) {
    call->succeed({{"config", public_part(parts.config)}});
}

}  // namespace

void add_server_methods(MethodTable& methods) {
    methods.add({.name = "server.info", .is_immediate = true, .handle = info});
    methods.add({.name = "server.health", .is_immediate = true, .handle = health});
    methods.add({.name = "server.describe", .is_immediate = true, .handle = describe});
    methods.add({.name = "server.metrics", .is_immediate = true, .handle = metrics});
    methods.add({.name = "server.config", .is_immediate = true, .handle = config});
    methods.add({.name = "health.watch", .is_immediate = true, .counts = true, .handle = watch});
}

}  // namespace contactd::server
