// session.*: the steps of a simulation.
#include <string>
#include <utility>

#include "all_methods.hpp"
#include "ics/problem_tables.hpp"
#include "request_limits.hpp"

namespace contactd::server {

using nlohmann::json;

namespace {

const std::string& name_in(const CallPtr& call) {
    return call->request.params["session"].get_ref<const std::string&>();
}

const std::string& state_in(const CallPtr& call) {
    return call->request.params["state"].get_ref<const std::string&>();
}

void finish_open(const CallPtr& call, SessionSpec spec, std::chrono::duration<double> lease, const IcAnswers& ics,
                 InfluenceCache& influences, SessionTable& sessions) {
    if (call->answered()) return;
    ContactInfluence influence = influence_of({spec.setup, spec.load}, ics, influences);
    SessionReply reply;
    reply.lease_seconds = lease.count();
    reply.bytes = session_bytes(spec.setup);
    reply.ics = uses_of(spec.setup, ics);
    reply.session = sessions.add(std::make_shared<Session>(std::move(spec), lease, ics, std::move(influence)));
    // Nobody knows the name of a session whose opening came too late.
    if (!call->succeed(proto::encode_session_reply(reply))) sessions.remove(reply.session);
}

/// Answers when the session is ready: a build is awaited, and reported, as by contact.solve.
void open(const CallPtr& call, const DaemonParts& parts) {
    check_grid_limit(call->request.params, parts.config.max_grid_elements);
    SessionSpec spec = proto::decode_session_spec(call->request.params, call->request.frames);
    proto::check_frames_used(call->request.params, call->request.frames);
    const auto lease = parts.sessions.lease(spec.lease_seconds);
    check_opening({spec.setup, spec.load});
    parts.sessions.check_room(session_bytes(spec.setup));  // before a build is started for it
    const auto specs = specs_of(spec.setup);
    const bool needs = needs_tables(spec.setup);
    auto prepare = [call, spec = std::move(spec), lease, &parts](const IcAnswers& ics) {
        parts.workers.post(turn_of(call), [call, spec, lease, ics, &parts] {
            guarded(call, [&] { finish_open(call, spec, lease, ics, parts.influences, parts.sessions); });
        });
    };
    if (!needs) return prepare({});
    fetch_pair(call, parts.ics, specs, prepare, [call](const proto::Status& status) { call->fail(status); });
}

void step(const CallPtr& call, const DaemonParts& parts) {
    ++parts.counters.solves;
    parts.sessions.find(name_in(call))->step(call, parts.solve_tools());
}

SessionPtr session_of(const CallPtr& call, const DaemonParts& parts) {
    proto::check_frames_used(call->request.params, call->request.frames);
    return parts.sessions.find(name_in(call));
}

void info(const CallPtr& call, const DaemonParts& parts) {
    const SessionPtr session = session_of(call, parts);
    const ContactProblem& problem = session->opened;
    SessionInfo told;
    told.step = session->state()->step;
    told.lease_seconds = session->lease.count();
    told.states = session->states();
    told.bytes = session->bytes();
    told.grid = problem.grid;
    if (problem.friction)
        told.motion = std::holds_alternative<Rolling>(problem.motion) ? MotionKind::rolling : MotionKind::shift;
    told.ics = uses_of(problem, session->ics());
    call->succeed(proto::encode_session_info(told));
}

void save(const CallPtr& call, const DaemonParts& parts) {
    const SessionPtr session = session_of(call, parts);
    const long long step = session->state()->step;
    call->succeed({{"state", parts.sessions.save(*session)}, {"step", step}});
}

void restore(const CallPtr& call, const DaemonParts& parts) {
    const SessionPtr session = session_of(call, parts);
    SessionStatePtr state = session->saved(state_in(call));
    const long long step = state->step;
    session->set_state(std::move(state));
    call->succeed({{"step", step}});
}

void forget(const CallPtr& call, const DaemonParts& parts) {
    const SessionPtr session = session_of(call, parts);
    call->succeed({{"states", session->forget(state_in(call))}});
}

void close(const CallPtr& call, const DaemonParts& parts) {
    const SessionPtr session = parts.sessions.remove(name_in(call));
    call->succeed({{"step", session->state()->step}});
}

void list(const CallPtr& call, const DaemonParts& parts) {
    const auto now = Session::Clock::now();
    json sessions = json::array();
    for (const SessionPtr& session : parts.sessions.all())
        sessions.push_back({{"age_seconds", std::chrono::duration<double>(now - session->created).count()},
                            {"idle_seconds", session->idle(now).count()},
                            {"lease_seconds", session->lease.count()},
                            {"step", session->state()->step},
                            {"states", session->states()},
                            {"bytes", session->bytes()},
                            {"elements", session->opened.grid.size()}});
    call->succeed({{"sessions", std::move(sessions)}, {"bytes", parts.sessions.bytes()}});
}

}  // namespace

void add_session_methods(MethodTable& methods) {
    constexpr auto high = proto::Priority::high;
    methods.add({.name = "session.open", .handle = open});
    methods.add({.name = "session.step", .takes_turn = true, .priority = high, .job = "step", .handle = step});
    methods.add({.name = "session.info", .takes_turn = true, .priority = high, .handle = info});
    methods.add({.name = "session.save", .takes_turn = true, .priority = high, .handle = save});
    methods.add({.name = "session.restore", .takes_turn = true, .priority = high, .handle = restore});
    methods.add({.name = "session.forget", .takes_turn = true, .priority = high, .handle = forget});
    methods.add({.name = "session.close", .is_quick = true, .handle = close});
    methods.add({.name = "session.list", .is_quick = true, .handle = list});
}

}  // namespace contactd::server
