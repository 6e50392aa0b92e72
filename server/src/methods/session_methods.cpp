// Implements session.*: the steps of a simulation.
#include <string>
#include <utility>

#include "all_methods.hpp"
#include "engine/ics/problem_tables.hpp"
#include "handlers.hpp"
#include "jobs/job_reports.hpp"
#include "methods/costs/cost_parts.hpp"
#include "methods/costs/costs.hpp"
#include "methods/costs/request_limits.hpp"
#include "sessions/below_wheel_rail.hpp"

namespace contactd::server {

using nlohmann::json;

namespace {

const std::string& name_in(const CallPtr& call) {
    return call->request.params["session"].get_ref<const std::string&>();
}

const std::string& state_in(const CallPtr& call) {
    return call->request.params["state"].get_ref<const std::string&>();
}

/// The cost of opening is that of a step, because it allocates the memory of a step.
WorkCost cost_of_opening(const json& params, const Config& config) {
    const json* wheel_rail = member(params, "wheelrail");
    return wheel_rail != nullptr ? cost_of_wheel_rail(*wheel_rail, config) : cost_of_solve(params, config);
}

double step_seconds(const CallPtr& call, const DaemonParts& parts) {
    return cost_of_opening(call->request.params, parts.config).seconds;
}

void finish_open(const CallPtr& call, SessionSpec spec, std::chrono::duration<double> lease,
                 const engine::IcAnswers& ics, const DaemonParts& parts) {
    if (call->answered()) return;
    const CallObserver observer(call);
    SessionReply reply;
    reply.lease_seconds = lease.count();
    reply.bytes = session_bytes(spec.setup);
    reply.ics = engine::uses_of(spec.setup, ics);
    SessionTable& sessions = parts.sessions;
    reply.session = sessions.add(std::make_shared<Session>(
        simulation_of(parts.engine.open(std::move(spec), ics, observer)), lease, step_seconds(call, parts)));
    // The client does not get the name of a session that was opened too late, so it is closed.
    if (!call->succeed(proto::encode_session_reply(reply))) sessions.remove(reply.session);
}

/// Half-spaces in closed form need no build.
void open_wheel_rail(const CallPtr& call, const DaemonParts& parts) {
    const proto::Request& request = call->request;
    const WheelRailSessionSpec spec =
        below_wheel_rail([&] { return proto::decode_wheel_rail_session_spec(request.params, request.frames); });
    proto::check_frames_used(request.params, request.frames);
    const auto lease = parts.sessions.lease(spec.lease_seconds);
    SessionReply reply;
    reply.lease_seconds = lease.count();
    reply.bytes = session_bytes(spec.setup);
    parts.sessions.check_room(reply.bytes);
    const CallObserver observer(call);
    auto steps = below_wheel_rail([&] { return parts.engine.open(spec, observer); });
    reply.session = parts.sessions.add(
        std::make_shared<Session>(simulation_of(std::move(steps)), lease, step_seconds(call, parts)));
    if (!call->succeed(proto::encode_session_reply(reply))) parts.sessions.remove(reply.session);
}

/// Answers when the session is ready. Waits for a build and reports its progress, like contact.solve.
void open(const CallPtr& call, const DaemonParts& parts) {
    if (proto::is_of_wheel_rail(call->request.params)) return open_wheel_rail(call, parts);
    SessionSpec spec = proto::decode_session_spec(call->request.params, call->request.frames);
    proto::check_frames_used(call->request.params, call->request.frames);
    const auto lease = parts.sessions.lease(spec.lease_seconds);
    engine::check_opening({spec.setup, spec.load});
    parts.sessions.check_room(session_bytes(spec.setup));  // is checked before a build starts for it
    const auto specs = engine::specs_of(spec.setup);
    const bool needs = engine::needs_tables(spec.setup);
    auto prepare = [call, spec = std::move(spec), lease, &parts](const engine::IcAnswers& ics) {
        const double bytes = cost_of_opening(call->request.params, parts.config).bytes;
        parts.budget.enter(call, bytes, [call, spec, lease, ics, &parts] {
            parts.workers.post(ticket_of(call), [call, spec, lease, ics, &parts] {
                guarded(call, [&] { finish_open(call, spec, lease, ics, parts); });
            });
        });
    };
    if (!needs) return prepare({});
    call->work.reset();  // a build may take hours
    engine::fetch_pair(
        parts.ics, specs,
        {prepare, [call](const proto::Status& status) { call->fail(status); }, reports_to(call), ticket_of(call)});
}

void step(const CallPtr& call, const DaemonParts& parts) {
    ++parts.counters.solves;
    const SessionPtr session = parts.sessions.find(name_in(call));
    if (call->answered()) return;
    const std::shared_ptr<Job> job = job_of(call, "step", parts.jobs);
    Reporter reporter(call, job);
    const auto check_rest = [&] { proto::check_frames_used(call->request.params, call->request.frames); };
    const auto send = [&](const StepAnswer& answer) {
        job->end();
        return call->succeed_with(*answer.text, answer.frames);
    };
    session->step({call->request.params, call, job, [&](const JobProgress& p) { reporter.report(p); }, check_rest, send,
                   parts.recent_solves},
                  parts.engine);
}

bool is_small_step(const CallPtr& call, const DaemonParts& parts) {
    const auto& params = call->request.params;
    const auto name = params.find("session");
    if (name == params.end() || !name->is_string()) return false;
    const SessionPtr session = parts.sessions.find_open(name->get_ref<const std::string&>());
    return session && session->simulation().is_small();
}

SessionPtr session_of(const CallPtr& call, const DaemonParts& parts) {
    proto::check_frames_used(call->request.params, call->request.frames);
    return parts.sessions.find(name_in(call));
}

void session_info(const CallPtr& call, const DaemonParts& parts) {
    const SessionPtr session = session_of(call, parts);
    SessionInfo reply = session->simulation().common();
    reply.step = session->step_number();
    reply.lease_seconds = session->lease.count();
    reply.states = session->states();
    reply.bytes = session->bytes();
    call->succeed(proto::encode_session_info(reply));
}

void save(const CallPtr& call, const DaemonParts& parts) {
    const SessionPtr session = session_of(call, parts);
    const long long step = session->step_number();
    call->succeed({{"state", parts.sessions.save(*session)}, {"step", step}});
}

void restore(const CallPtr& call, const DaemonParts& parts) {
    const SessionPtr session = session_of(call, parts);
    SessionStatePtr state = session->saved(state_in(call));
    const long long step = state->last->step;
    session->set_state(std::move(state));
    call->succeed({{"step", step}});
}

void forget(const CallPtr& call, const DaemonParts& parts) {
    const SessionPtr session = session_of(call, parts);
    call->succeed({{"states", session->forget(state_in(call))}});
}

void close(const CallPtr& call, const DaemonParts& parts) {
    const SessionPtr session = parts.sessions.remove(name_in(call));
    call->succeed({{"step", session->step_number()}});
}

void list(const CallPtr& call, const DaemonParts& parts) {
    const auto now = Session::Clock::now();
    json sessions = json::array();
    for (const SessionPtr& session : parts.sessions.all())
        sessions.push_back({{"age_seconds", std::chrono::duration<double>(now - session->created).count()},
                            {"idle_seconds", session->idle(now).count()},
                            {"lease_seconds", session->lease.count()},
                            {"step", session->step_number()},
                            {"states", session->states()},
                            {"bytes", session->bytes()},
                            {"elements", session->elements()}});
    call->succeed({{"sessions", std::move(sessions)}, {"bytes", parts.sessions.bytes()}});
}

}  // namespace

void add_session_methods(MethodTable& methods) {
    constexpr auto high = proto::Priority::high;
    methods.add({.name = "session.open", .cost = cost_of_opening, .handle = open});
    methods.add({.name = "session.step",
                 .in_session_order = true,
                 .priority = high,
                 .job = "step",
                 .is_small = is_small_step,
                 .handle = step});
    methods.add({.name = "session.info", .in_session_order = true, .priority = high, .handle = session_info});
    methods.add({.name = "session.step_many", .priority = high, .queue = queue_steps});
    methods.add({.name = "session.save", .in_session_order = true, .priority = high, .handle = save});
    methods.add({.name = "session.restore", .in_session_order = true, .priority = high, .handle = restore});
    methods.add({.name = "session.forget", .in_session_order = true, .priority = high, .handle = forget});
    methods.add({.name = "session.close", .is_immediate = true, .handle = close});
    methods.add({.name = "session.list", .is_immediate = true, .handle = list});
}

}  // namespace contactd::server
