#include "service.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>

#include "contactd/proto/codec.hpp"
#include "contactd/proto/ic_part.hpp"
#include "contactd/proto/schema.hpp"
#include "contactd/version.hpp"
#include "ics/builder_programs.hpp"
#include "ics/ic_export.hpp"
#include "ics/ic_list.hpp"
#include "ics/store_folder.hpp"
#include "jobs/job_reports.hpp"
#include "operation/about.hpp"
#include "sessions/session_methods.hpp"
#include "solves/contact_solve.hpp"
#include "solves/contact_subsurface.hpp"

namespace contactd::server {

using nlohmann::json;
using proto::Status;
using proto::StatusCode;
using proto::StatusError;

namespace {

const Status& stopping_status() {
    static const Status status{
        StatusCode::unavailable, "The daemon is ending.", std::string(proto::reason::stopping), {}, 0};
    return status;
}

IcStore open_store(const Config& config, Counters& counters) {
    return IcStore(config.store.folder, [&counters](const std::string& sentence) {
        ++counters.tables_set_aside;
        spdlog::warn("store: {}", sentence);
    });
}

IcService::Settings ic_settings(const Config& config) {
    const auto& builds = config.builds;
    return {{builds.launcher, builds.program, builds.environment, builds.max_memory_bytes,
             std::chrono::seconds(builds.stall_seconds), std::chrono::seconds(builds.max_seconds)},
            builds.concurrent,
            config.store.memory_budget_bytes,
            config.store.disk_budget_bytes,
            {builds.max_failures, std::chrono::seconds(builds.quarantine_seconds)}};
}

template <class Entries>
std::vector<std::string> names_of(const Entries& entries) {
    std::vector<std::string> names;
    for (const auto& [name, entry] : entries) names.push_back(name);
    return names;
}

double seconds_since(Call::Clock::time_point start) {
    return std::chrono::duration<double>(Call::Clock::now() - start).count();
}

constexpr const char* grid_limit = " (limits.max_grid_elements)";

/// `field` is where `params` stand. Throws where one side alone has more elements than a grid may.
long long elements_of(const json& params, std::size_t most, const std::string& field = "") {
    long long elements = 1;
    for (const char* side : {"nx", "ny"}) {
        const auto count = params.at("grid").at(side).get<long long>();
        if (count > static_cast<long long>(most))
            throw proto::invalid_field(
                field + "grid." + side,
                "is " + std::to_string(count) + "; nx times ny is at most " + std::to_string(most) + grid_limit,
                proto::reason::limit_exceeded);
        elements *= count;  // each at most 4e6
    }
    return elements;
}

/// Grids are limited before anything the size of a grid is made of them. `params` has passed its schema.
void check_grid_limit(const json& params, std::size_t most) {
    const long long elements = elements_of(params, most);
    if (elements > static_cast<long long>(most))
        throw proto::invalid_field("grid.nx",
                                   "times ny is " + std::to_string(elements) + " elements; at most " +
                                       std::to_string(most) + " are allowed" + grid_limit,
                                   proto::reason::limit_exceeded);
}

void check_grid_limits(const json& problems, std::size_t most) {
    long long elements = 0;  // at most 1000 times 1.6e13
    for (std::size_t n = 0; n < problems.size(); ++n)
        elements += elements_of(problems[n], most, "problems[" + std::to_string(n) + "].");
    if (elements > static_cast<long long>(most))
        throw proto::invalid_field("problems",
                                   "have " + std::to_string(elements) + " elements together; at most " +
                                       std::to_string(most) + " are allowed" + grid_limit,
                                   proto::reason::limit_exceeded);
}

/// Of what has passed check_grid_limit.
std::size_t elements_in(const json& params) {
    return static_cast<std::size_t>(elements_of(params, max_grid_elements));
}

/// Bytes of the arrays in a result of contact.solve: element division, pressure, tractions and, with friction, slip.
std::size_t result_bytes(const json& params) {
    const std::size_t per_element = params.contains("friction") ? 1 + 5 * sizeof(double) : 1 + 3 * sizeof(double);
    return per_element * elements_in(params);
}

/// What could not be sent need not be solved. Lists have no size that is known before; they are checked when they go.
void check_answer_fits(const std::vector<const json*>& problems, const Call& call, const proto::Limits& limits) {
    if (call.request.arrays == proto::ArrayEncoding::list) return;
    std::size_t total = 0, largest = 0;
    for (const json* problem : problems) {
        total += result_bytes(*problem);
        largest = std::max(largest, elements_in(*problem) * sizeof(double));
    }
    const auto refuse = [](std::size_t is, const char* what, std::size_t limit, const char* name) {
        throw proto::invalid_field("grid.nx",
                                   "and ny make an answer with " + std::to_string(is) + " bytes " + what +
                                       "; at most " + std::to_string(limit) + " are allowed (limits." + name +
                                       "): take larger elements, or fewer problems at once",
                                   proto::reason::answer_too_large);
    };
    if (largest > limits.max_frame_bytes) refuse(largest, "in one frame", limits.max_frame_bytes, "max_frame_bytes");
    if (total > limits.max_message_bytes) refuse(total, "of arrays", limits.max_message_bytes, "max_message_bytes");
}

}  // namespace

Service::Service(const Config& config)
    : config_(config),
      open_calls_({config.max_queue, config.max_queue_per_client, config.max_queue_bytes,
                   config.security.per_user.open_requests}),
      methods_{
          {"server.info", {&Service::server_info, true}},
          {"server.health", {&Service::server_health, true}},
          {"server.describe", {&Service::server_describe, true}},
          {"server.metrics", {&Service::server_metrics, true}},
          {"health.watch", {&Service::health_watch, true, true}},
          {"ic.get", {&Service::ic_get, false}},
          {"ic.export", {&Service::ic_export, false}},
          {"ic.list", {&Service::ic_list, false}},
          {"ic.delete", {&Service::ic_delete, false}},
          {"contact.solve", {&Service::contact_solve, false, true, proto::Priority::normal, "solve"}},
          {"contact.solve_many", {&Service::contact_solve_many, false, true, proto::Priority::low, "solve"}},
          {"contact.subsurface", {&Service::contact_subsurface, false, true, proto::Priority::normal, "subsurface"}},
          {"session.open", {&Service::session_open, false}},
          {"session.step", {&Service::session_step, false, true, proto::Priority::high, "step"}},
          {"session.info", {&Service::session_info, false, true, proto::Priority::high}},
          {"session.save", {&Service::session_save, false, true, proto::Priority::high}},
          {"session.restore", {&Service::session_restore, false, true, proto::Priority::high}},
          {"session.forget", {&Service::session_forget, false, true, proto::Priority::high}},
          {"session.close", {&Service::session_close, true}},
          {"session.list", {&Service::session_list, true}},
          {"job.list", {&Service::job_list, true}},
          {"job.cancel", {&Service::job_cancel, true}},
          {"request.cancel", {&Service::request_cancel, true}}},
      request_metrics_(names_of(methods_)),
      ics_(ic_settings(config), open_store(config, counters_), jobs_, counters_),
      influences_(config.store.influence_budget_bytes),
      sessions_(config.sessions),
      workers_(config.workers) {
    count_store(counters_, config.store.folder);
    for (const std::string& problem : building_problems(config)) spdlog::warn("{}", problem);
}

bool Service::is_quick(const std::string& method) const {
    const auto entry = methods_.find(method);
    return entry == methods_.end() || entry->second.is_quick;
}

bool Service::counts(const std::string& method) const {
    const auto entry = methods_.find(method);
    return entry != methods_.end() && entry->second.counts;
}

proto::Priority Service::priority_of(const std::string& method) const {
    const auto entry = methods_.find(method);
    return entry == methods_.end() ? proto::Priority::normal : entry->second.priority;
}

void Service::handle(CallPtr call) {
    const auto entry = methods_.find(call->request.method);
    const Method method = entry == methods_.end() ? nullptr : entry->second.method;
    if (is_quick(call->request.method)) return run(method, call);
    if (stopping_) return call->fail(stopping_status());
    if (entry->second.job) job_of(call, entry->second.job, jobs_);
    Turn turn = turn_of(call);
    workers_.post(std::move(turn), [this, method, call = std::move(call)] {
        call->check_deadline();
        if (!call->answered()) run(method, call);
    });
}

void Service::drop_abandoned() {
    workers_.drop_abandoned();
    ics_.drop_abandoned();
}

void Service::run(Method method, const CallPtr& call) {
    try {
        proto::check_params(call->request.method, call->request.params);
        if (is_quick(call->request.method)) proto::check_frames_used(call->request.params, call->request.frames);
        (this->*method)(call);
    } catch (const std::exception& error) {
        const Status status = status_of(error);
        if (status.code == StatusCode::internal) spdlog::error("{}: {}", call->request.method, error.what());
        call->fail(status);
    }
}

void Service::begin_drain() {
    stopping_ = true;
    health_.set(HealthState::stopping);
}

void Service::begin_stop() {
    begin_drain();
    for (const auto& job : jobs_.all()) job->cancel();
}

void Service::finish_stop() {
    ics_.stop(stopping_status());
    workers_.stop();
}

const Status& Service::stop_status() {
    return stopping_status();
}

void Service::server_info(const CallPtr& call) {
    json limits = proto::to_json(config_.limits);
    limits["max_grid_elements"] = config_.max_grid_elements;
    limits["max_queue"] = config_.max_queue;
    limits["max_queue_per_client"] = config_.max_queue_per_client;
    limits["max_queue_bytes"] = config_.max_queue_bytes;
    limits["max_sessions"] = config_.sessions.max_sessions;
    limits["max_session_bytes"] = config_.sessions.max_bytes;
    limits["max_session_states"] = config_.sessions.max_states;
    limits["max_lease_seconds"] = config_.sessions.max_lease_seconds;
    const IcCache::Usage cache = ics_.cache_usage();
    call->succeed({{"version", version()},
                   {"commit", commit()},
                   {"protocol", proto::protocol_version},
                   {"protocol_versions", proto::protocol_versions},
                   {"libraries", all_library_versions()},
                   {"limits", limits},
                   {"counters",
                    {{"requests", counters_.requests.load()},
                     {"requests_failed", counters_.requests_failed.load()},
                     {"solves", counters_.solves.load()},
                     {"builds_started", counters_.builds_started.load()},
                     {"builds_finished", counters_.builds_finished.load()},
                     {"builds_failed", counters_.builds_failed.load()},
                     {"builds_cancelled", counters_.builds_cancelled.load()},
                     {"builds_joined", counters_.builds_joined.load()},
                     {"memory_hits", counters_.memory_hits.load()},
                     {"disk_hits", counters_.disk_hits.load()},
                     {"closed_form", counters_.closed_form.load()},
                     {"tables_set_aside", counters_.tables_set_aside.load()}}},
                   {"cache", {{"tables", cache.entries}, {"bytes", cache.bytes}, {"budget_bytes", cache.budget_bytes}}},
                   {"queue",
                    {{"solves_waiting", workers_.waiting()},
                     {"solves_running", workers_.running()},
                     {"builds_waiting", ics_.builds_waiting()},
                     {"builds_running", ics_.builds_running()}}},
                   {"uptime_seconds", seconds_since(started_)}});
}

void Service::server_health(const CallPtr& call) {
    json warnings = json::array();
    if (std::string problem = ics_.store_problem(); !problem.empty()) warnings.push_back(std::move(problem));
    for (std::string& problem : building_problems(config_)) warnings.push_back(std::move(problem));
    call->succeed({{"state", name_of(health_.state())}, {"warnings", std::move(warnings)}});
}

void Service::health_watch(const CallPtr& call) {
    health_.watch(call);
}

void Service::server_describe(const CallPtr& call) {
    call->succeed(proto::openrpc());
}

void Service::ic_get(const CallPtr& call) {
    proto::check_frames_used(call->request.params, call->request.frames);
    check_grid_limit(call->request.params, config_.max_grid_elements);
    const IcSpec spec = proto::decode_ic_spec(call->request.params);
    validate(spec);
    const proto::IcPart part = proto::decode_ic_part(call->request.params, spec.ny);
    if (call->request.arrays == proto::ArrayEncoding::frame) proto::check_size(part, spec.nx, config_.limits);
    const auto done = [call, spec, part](const IcAnswer& answer) {
        guarded(call, [&] {
            proto::ArrayWriter arrays(call->request.arrays);
            const IcTable table = table_of(answer, spec);
            if (!std::all_of(table.values.begin(), table.values.end(), [](double v) { return std::isfinite(v); }))
                throw proto::invalid_field("material.G",
                                           "and grid.dx make coefficients that are beyond a double's range");
            const json result = proto::encode_ic_part_reply(
                {answer.key, answer.origin, spec, table, answer.record->evidence}, part, arrays);
            call->succeed(result, arrays.take_frames());
        });
    };
    ics_.request(spec, {done, [call](const Status& status) { call->fail(status); },
                        [call](const Job& job, const JobProgress& progress) { call->progress(to_json(job, progress)); },
                        turn_of(call)});
}

void Service::ic_export(const CallPtr& call) {
    proto::check_frames_used(call->request.params, call->request.frames);
    check_grid_limit(call->request.params, config_.max_grid_elements);
    start_export(call, ics_, workers_, config_.limits.max_frame_bytes);
}

void Service::ic_list(const CallPtr& call) {
    proto::check_frames_used(call->request.params, call->request.frames);
    answer_ic_list(call, ics_);
}

void Service::ic_delete(const CallPtr& call) {
    proto::check_frames_used(call->request.params, call->request.frames);
    answer_ic_delete(call, ics_);
}

void Service::contact_solve(const CallPtr& call) {
    check_grid_limit(call->request.params, config_.max_grid_elements);
    check_answer_fits({&call->request.params}, *call, config_.limits);
    ++counters_.solves;
    start_solve(call, solve_tools());
}

void Service::contact_solve_many(const CallPtr& call) {
    check_grid_limits(call->request.params.at("problems"), config_.max_grid_elements);
    std::vector<const json*> problems;
    for (const json& problem : call->request.params.at("problems")) problems.push_back(&problem);
    check_answer_fits(problems, *call, config_.limits);
    counters_.solves += static_cast<long long>(call->request.params.at("problems").size());
    start_solve_many(call, solve_tools(), config_.workers, config_.limits);
}

void Service::contact_subsurface(const CallPtr& call) {
    check_grid_limit(call->request.params, config_.max_grid_elements);
    answer_subsurface(call, jobs_, config_.limits);
}

void Service::session_open(const CallPtr& call) {
    check_grid_limit(call->request.params, config_.max_grid_elements);
    open_session(call, solve_tools(), sessions_);
}

void Service::session_step(const CallPtr& call) {
    ++counters_.solves;
    step_session(call, solve_tools(), sessions_);
}

void Service::session_info(const CallPtr& call) {
    tell_session(call, solve_tools(), sessions_);
}

void Service::session_save(const CallPtr& call) {
    save_session(call, solve_tools(), sessions_);
}

void Service::session_restore(const CallPtr& call) {
    restore_session(call, solve_tools(), sessions_);
}

void Service::session_forget(const CallPtr& call) {
    forget_state(call, solve_tools(), sessions_);
}

void Service::session_close(const CallPtr& call) {
    close_session(call, sessions_);
}

void Service::session_list(const CallPtr& call) {
    list_sessions(call, sessions_);
}

void Service::job_list(const CallPtr& call) {
    json jobs = json::array();
    for (const auto& job : jobs_.all()) {
        const JobProgress progress = job->progress();
        json entry = {{"job", job->name},
                      {"kind", job->kind},
                      {"state", job->running() ? "running" : "queued"},
                      {"stage", progress.stage},
                      {"fraction", progress.fraction},
                      {"callers", job->callers()},
                      {"seconds", seconds_since(job->created)}};
        if (progress.seconds_left) entry["seconds_left"] = *progress.seconds_left;
        jobs.push_back(std::move(entry));
    }
    call->succeed({{"jobs", std::move(jobs)}});
}

void Service::job_cancel(const CallPtr& call) {
    const std::string name = call->request.params.at("job");
    const auto job = jobs_.find(name);
    if (!job)
        throw StatusError(StatusCode::not_found, proto::reason::job_unknown,
                          "There is no job " + json(name).dump() + "; job.list names those that wait or run.");
    job->cancel();
    drop_abandoned();
    call->succeed({{"job", name}});
}

void Service::request_cancel(const CallPtr& call) {
    const std::string id = call->request.params.at("id");
    const auto open = open_calls_.find(call->client(), id);
    if (open.empty())
        throw StatusError(StatusCode::not_found, proto::reason::request_unknown,
                          "No request of this client with the id " + json(id).dump() + " waits for an answer.");
    for (const CallPtr& cancelled : open)
        cancelled->fail({StatusCode::cancelled,
                         "The request was cancelled by its client.",
                         std::string(proto::reason::request_cancelled),
                         {},
                         0});
    drop_abandoned();
    call->succeed({{"id", id}});
}

}  // namespace contactd::server
