#include "service.hpp"

#include <functional>
#include <string>
#include <utility>

#include "access/method_access.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/proto/schema.hpp"
#include "engine/ics/store/store_folder.hpp"
#include "jobs/job_reports.hpp"
#include "methods/all_methods.hpp"
#include "methods/costs/costs.hpp"
#include "operation/builder_programs.hpp"

namespace contactd::server {

using proto::Status;
using proto::StatusCode;

namespace {

const Status& stopping_status() {
    static const Status status{
        StatusCode::unavailable, "The daemon is shutting down.", std::string(proto::reason::stopping), {}, 0};
    return status;
}

/// Empty if all users may build tables.
std::function<bool(const std::string&)> builders_of(const MethodRules& rules) {
    if (!rules.allowed_users.contains(MethodRules::builds)) return {};
    return [&rules](const std::string& user) { return is_allowed(rules, MethodRules::builds, user); };
}

engine::EngineSettings engine_settings(const Config& config, const Host& host) {
    const auto& builds = config.builds;
    return {config.store.folder,
            config.store.influence_budget_bytes,
            config.max_grid_elements,
            {{builds.launcher, builds.program, builds.environment, builds.max_memory_bytes,
              std::chrono::seconds(builds.stall_seconds), std::chrono::seconds(builds.max_seconds)},
             builds.concurrent,
             config.store.memory_budget_bytes,
             config.store.disk_budget_bytes,
             {builds.max_failures, std::chrono::seconds(builds.quarantine_seconds)},
             config.store.share_imported_tables,
             host.log,
             builders_of(config.methods)},
            true,
            config.max_work_bytes};
}

/// Small answers are sent immediately, or wait in the outbox, which counts them.
void count(Answer& answer, WorkBudget& budget) {
    constexpr std::size_t large = 1 << 16;
    std::size_t bytes = answer.envelope.size();
    for (const auto& frame : answer.frames) bytes += frame.size();
    if (bytes >= large) answer.counted = budget.count(static_cast<double>(bytes));
}

}  // namespace

Service::Service(const Config& config, Host host)
    : host_(std::move(host)),
      open_calls_({config.max_queue, config.max_queue_per_client, config.max_queue_bytes,
                   config.security.per_user.open_requests}),
      methods_(all_methods()),
      request_metrics_(methods_.names()),
      engine_(engine_settings(config, host_)),
      sessions_(config.sessions),
      recent_solves_(config.recent_solves),
      budget_(config.max_work_bytes, workers_),
      parts_{config,           host_,          open_calls_, counters_,      request_metrics_, health_,  engine_,
             engine_.tables(), engine_.jobs(), sessions_,   recent_solves_, file_runs_,       workers_, budget_},
      workers_(config.workers, config.spin) {
    engine::count_store(engine_.counters(), config.store.folder);
    for (const std::string& problem : building_problems(config)) engine::EngineLog(host_.log).warn(problem);
}

Service::~Service() {
    workers_.stop();
    budget_.close();
}

CallPtr Service::open(const Route& route, proto::Request request, Call::Clock::time_point received,
                      OpenCalls::Admission admission, Call::Post post) {
    const Method* method = methods_.find(request.method);
    if (method && method->counts && admission.number == 0) admission = open_calls_.admit(route, request.bytes);
    const auto priority = request.priority.value_or(method ? method->priority : proto::Priority::normal);
    auto call = std::make_shared<Call>(route, std::move(request), received, priority, parts_.config.limits,
                                       [post = std::move(post), admission, &budget = budget_](Answer answer) {
                                           if (!answer.is_progress) answer.number = admission.number;
                                           count(answer, budget);
                                           post(std::move(answer));
                                       });
    if (admission.number != 0 && !open_calls_.attach(admission.number, call)) return nullptr;
    return call;
}

void Service::handle(CallPtr call) {
    const Method* method = methods_.find(call->request.method);
    if (const auto denied = refusal(parts_.config.methods, call->request.method, call->user()))
        return call->fail(*denied);
    if (!method || method->is_immediate) return run(method, call);
    if (stopping_) return call->fail(stopping_status());
    if (method->job) job_of(call, method->job, engine_.jobs());
    auto work = [this, method, call] {
        call->check_deadline();
        if (!call->answered()) run(method, call);
    };
    if (method->queue) return method->queue(call, parts_);
    const SessionPtr session = method->in_session_order ? session_of(call) : nullptr;
    if (is_at_once(*method, call)) {
        if (!session) return work();
        if (session->try_run(work, workers_)) return;
    }
    if (session && method->job) call->is_large = is_large(session->step_seconds);
    if (session) return session->enqueue(ticket_of(call), std::move(work), workers_);
    workers_.post(ticket_of(call), std::move(work));
}

/// Returns whether the calling thread may do small work: it waits anyway, or no other request is open.
bool Service::is_at_once(const Method& method, const CallPtr& call) {
    return method.is_small && (host_.callers_wait || open_calls_.count() <= 1) && method.is_small(call, parts_);
}

SessionPtr Service::session_of(const CallPtr& call) {
    const auto& params = call->request.params;
    const auto name = params.find("session");
    if (name == params.end() || !name->is_string()) return nullptr;  // The schema reports the error.
    return sessions_.find_open(name->get_ref<const std::string&>());
}

/// Runs `work`. An exception becomes the answer of the call.
void Service::attempt(const CallPtr& call, const std::function<void()>& work) {
    try {
        work();
    } catch (const std::exception& error) {
        const Status status = status_of(error);
        if (status.code == StatusCode::internal)
            engine::EngineLog(host_.log).error(call->request.method + ": " + error.what());
        call->fail(status);
    }
}

void Service::run(const Method* method, const CallPtr& call) {
    attempt(call, [&] {
        proto::check_params(call->request.method, call->request.params);  // throws for an unknown method
        if (method->is_immediate) proto::check_frames_used(call->request.params, call->request.frames);
        begin(*method, call);
    });
}

/// Runs the work now, or when its memory is free.
void Service::begin(const Method& method, const CallPtr& call) {
    if (method.cost == nullptr) return method.handle(call, parts_);
    const WorkCost cost = method.cost(call->request.params, parts_.config);
    check_cost(cost, parts_.config);
    call->is_large = is_large(cost.seconds);
    std::function<void()> work = [this, &method, call] {
        call->check_deadline();
        if (!call->answered()) attempt(call, [&] { method.handle(call, parts_); });
    };
    // Large work returns to the queue, where it leaves a worker to small work.
    if (call->is_large) work = [this, call, work] { workers_.post(ticket_of(call), work); };
    budget_.enter(call, cost.bytes, std::move(work));
}

void Service::begin_drain() {
    stopping_ = true;
    health_.set(HealthState::stopping);
}

void Service::begin_stop() {
    begin_drain();
    for (const auto& job : engine_.jobs().all()) job->cancel();
}

void Service::finish_stop() {
    engine_.tables().stop(stopping_status());
    workers_.stop();
    budget_.close();
}

const Status& Service::stop_status() {
    return stopping_status();
}

}  // namespace contactd::server
