#include "collect_metrics.hpp"

#include <prometheus/metric_family.h>

#include "contactd/version.hpp"
#include "engine/ics/store/store_folder.hpp"
#include "operation/versions.hpp"

namespace contactd::server {
namespace {

double number(const Counters::Count& count) {
    return static_cast<double>(count.load());
}

template <class T>
double number(T count) {
    return static_cast<double>(count);
}

prometheus::MetricFamily build_info() {
    auto info = gauge("contactd_build_info", "Version and commit of the daemon; the value is always 1.", 1);
    info.metric.front().label = {{"version", version()}, {"commit", commit()}};
    return info;
}

MetricFamilies counted(const Counters& own, const engine::EngineCounters& c) {
    return {
        counter("contactd_requests_received_total", "Messages received, answered or not.", number(own.requests)),
        gauge("contactd_open_requests", "Requests that wait for their answer.", number(own.open_requests)),
        gauge("contactd_connections", "Connections of clients.", number(own.connections)),
        gauge("contactd_outbox_bytes", "Bytes of answers queued for clients that do not read.",
              number(own.outbox_bytes)),
        counter("contactd_solves_total", "Contact problems solved, by whether every solver reached its tolerance.",
                "converged", {{"true", number(c.solves_converged)}, {"false", number(c.solves_not_converged)}}),
        counter("contactd_solver_iterations_total", "Iterations of the solvers.", "solver",
                {{"normal", number(c.normal_iterations)}, {"tangential", number(c.tangential_iterations)}}),
        counter("contactd_builds_started_total", "Builders started.", number(c.builds_started)),
        counter("contactd_builds_total", "Builds that ended.", "outcome",
                {{"finished", number(c.builds_finished)},
                 {"failed", number(c.builds_failed)},
                 {"cancelled", number(c.builds_cancelled)}}),
        counter("contactd_build_seconds_total", "Time that builds took, all outcomes together.",
                number(c.build_milliseconds) / 1000),
        counter("contactd_builds_joined_total", "Requests that joined a running build.", number(c.builds_joined)),
        counter(
            "contactd_tables_found_total", "Tables of influence coefficients that needed no build.", "origin",
            {{"memory", number(c.memory_hits)}, {"disk", number(c.disk_hits)}, {"closed_form", number(c.closed_form)}}),
        counter("contactd_store_tables_set_aside_total", "Damaged tables moved to the quarantine folder.",
                number(c.tables_set_aside)),
        gauge("contactd_store_tables", "Tables in the store.", number(c.store_tables)),
        gauge("contactd_store_bytes", "Bytes of the tables in the store.", number(c.store_bytes)),
    };
}

void append(MetricFamilies& all, MetricFamilies more) {
    all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace

MetricFamilies collect_metrics(const DaemonParts& parts, bool look_at_store) {
    if (look_at_store) engine::count_store(parts.engine.counters(), parts.config.store.folder);
    MetricFamilies all{build_info()};
    append(all, parts.request_metrics.collect());
    append(all, counted(parts.counters, parts.engine.counters()));
    const engine::IcCache::Usage tables = parts.ics.cache_usage();
    const engine::InfluenceCache::Usage operators = parts.engine.influences().usage();
    const bool store_usable = parts.ics.store_problem().empty() &&
                              (!look_at_store || engine::store_problem(parts.config.store.folder).empty());
    append(all,
           {gauge("contactd_ready", "1 if requests are accepted.", parts.health.not_ready().empty() ? 1 : 0),
            gauge("contactd_store_usable", "1 if the store's folder is readable and writable.", store_usable ? 1 : 0),
            gauge("contactd_uptime_seconds", "Time since the start.",
                  std::chrono::duration<double>(Call::Clock::now() - parts.started).count()),
            gauge("contactd_workers", "Worker threads.", number(parts.config.workers)),
            gauge("contactd_workers_busy", "Worker threads that are busy.", number(parts.workers.running())),
            gauge("contactd_queue_length", "Work that waits for a thread.", "queue",
                  {{"solves", number(parts.workers.waiting())}, {"builds", number(parts.ics.builds_waiting())}}),
            gauge("contactd_builds_running", "Builders running now.", number(parts.ics.builds_running())),
            gauge("contactd_sessions", "Open sessions.", number(parts.sessions.all().size())),
            gauge("contactd_session_bytes", "Approximate memory of sessions and their saved states.",
                  number(parts.sessions.bytes())),
            gauge("contactd_cache_entries", "Entries of the caches in memory: tables, and transformed pairs of tables.",
                  "cache", {{"tables", number(tables.entries)}, {"influences", number(operators.entries)}}),
            gauge("contactd_cache_bytes", "Memory of the caches.", "cache",
                  {{"tables", number(tables.bytes)}, {"influences", number(operators.bytes)}}),
            gauge("contactd_cache_budget_bytes", "Memory that the caches may take.", "cache",
                  {{"tables", number(tables.budget_bytes)}, {"influences", number(operators.budget_bytes)}})});
    append(all, process_metrics());
    return all;
}

}  // namespace contactd::server
