#include "session_methods.hpp"

#include <string>
#include <utility>

#include "ics/problem_tables.hpp"

namespace contactd::server {

using nlohmann::json;

namespace {

SessionPtr session_of(const CallPtr& call, SessionTable& sessions) {
    return sessions.find(call->request.params["session"].get_ref<const std::string&>());
}

/// Answers with what `work` returns, when the session's turn comes, unless it has been closed by then or nobody waits
/// any more.
void in_turn(const CallPtr& call, const SolveTools& tools, SessionTable& sessions, std::function<json(Session&)> work) {
    proto::check_frames_used(call->request.params, call->request.frames);
    session_of(call, sessions)
        ->take_turn(
            turn_of(call),
            [call, work = std::move(work)](Session& session) {
                guarded(call, [&] {
                    if (call->answered()) return;
                    if (session.closed()) throw session_unknown();
                    call->succeed(work(session));
                });
            },
            tools.workers);
}

void finish_open(const CallPtr& call, SessionSpec spec, std::chrono::duration<double> lease, const IcAnswers& ics,
                 const SolveTools& tools, SessionTable& sessions) {
    if (call->answered()) return;
    ContactInfluence influence = influence_of({spec.setup, spec.load}, ics, tools.influences);
    SessionReply reply;
    reply.lease_seconds = lease.count();
    reply.bytes = session_bytes(spec.setup);
    reply.ics = uses_of(spec.setup, ics);
    reply.session = sessions.add(std::make_shared<Session>(std::move(spec), lease, ics, std::move(influence)));
    // Nobody knows the name of a session whose opening came too late.
    if (!call->succeed(proto::encode_session_reply(reply))) sessions.remove(reply.session);
}

}  // namespace

void open_session(const CallPtr& call, const SolveTools& tools, SessionTable& sessions) {
    SessionSpec spec = proto::decode_session_spec(call->request.params, call->request.frames);
    proto::check_frames_used(call->request.params, call->request.frames);
    const auto lease = sessions.lease(spec.lease_seconds);
    check_opening({spec.setup, spec.load});
    sessions.check_room(session_bytes(spec.setup));  // before a build is started for it
    const auto specs = specs_of(spec.setup);
    const bool needs = needs_tables(spec.setup);
    auto prepare = [call, spec = std::move(spec), lease, tools, &sessions](const IcAnswers& ics) {
        tools.workers.post(turn_of(call), [call, spec, lease, ics, tools, &sessions] {
            guarded(call, [&] { finish_open(call, spec, lease, ics, tools, sessions); });
        });
    };
    if (!needs) return prepare({});
    fetch_pair(call, tools.ics, specs, prepare, [call](const proto::Status& status) { call->fail(status); });
}

void step_session(const CallPtr& call, const SolveTools& tools, SessionTable& sessions) {
    session_of(call, sessions)
        ->take_turn(turn_of(call), [call, tools](Session& session) { session.step(call, tools); }, tools.workers);
}

void tell_session(const CallPtr& call, const SolveTools& tools, SessionTable& sessions) {
    in_turn(call, tools, sessions, [](Session& session) -> json {
        const ContactProblem& problem = session.opened;
        SessionInfo info;
        info.step = session.state()->step;
        info.lease_seconds = session.lease.count();
        info.states = session.states();
        info.bytes = session.bytes();
        info.grid = problem.grid;
        if (problem.friction)
            info.motion = std::holds_alternative<Rolling>(problem.motion) ? MotionKind::rolling : MotionKind::shift;
        info.ics = uses_of(problem, session.ics());
        return proto::encode_session_info(info);
    });
}

void save_session(const CallPtr& call, const SolveTools& tools, SessionTable& sessions) {
    in_turn(call, tools, sessions, [&sessions](Session& session) -> json {
        const long long step = session.state()->step;
        return {{"state", sessions.save(session)}, {"step", step}};
    });
}

void restore_session(const CallPtr& call, const SolveTools& tools, SessionTable& sessions) {
    in_turn(call, tools, sessions, [call](Session& session) -> json {
        SessionStatePtr state = session.saved(call->request.params["state"].get_ref<const std::string&>());
        const long long step = state->step;
        session.set_state(std::move(state));
        return {{"step", step}};
    });
}

void forget_state(const CallPtr& call, const SolveTools& tools, SessionTable& sessions) {
    in_turn(call, tools, sessions, [call](Session& session) -> json {
        return {{"states", session.forget(call->request.params["state"].get_ref<const std::string&>())}};
    });
}

void close_session(const CallPtr& call, SessionTable& sessions) {
    const SessionPtr session = sessions.remove(call->request.params["session"].get_ref<const std::string&>());
    call->succeed({{"step", session->state()->step}});
}

void list_sessions(const CallPtr& call, const SessionTable& sessions) {
    const auto now = Session::Clock::now();
    json list = json::array();
    for (const SessionPtr& session : sessions.all())
        list.push_back({{"age_seconds", std::chrono::duration<double>(now - session->created).count()},
                        {"idle_seconds", session->idle(now).count()},
                        {"lease_seconds", session->lease.count()},
                        {"step", session->state()->step},
                        {"states", session->states()},
                        {"bytes", session->bytes()},
                        {"elements", session->opened.grid.size()}});
    call->succeed({{"sessions", std::move(list)}, {"bytes", sessions.bytes()}});
}

}  // namespace contactd::server
