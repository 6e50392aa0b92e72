// session.*: the steps of a simulation.
#include "sessions/session_methods.hpp"
#include "all_methods.hpp"
#include "request_limits.hpp"

namespace contactd::server {
namespace {

void open(const CallPtr& call, const DaemonParts& parts) {
    check_grid_limit(call->request.params, parts.config.max_grid_elements);
    open_session(call, parts.solve_tools(), parts.sessions);
}

void step(const CallPtr& call, const DaemonParts& parts) {
    ++parts.counters.solves;
    step_session(call, parts.solve_tools(), parts.sessions);
}

/// Of what `handle` does in the turn of a session.
template <auto handle>
void in_session(const CallPtr& call, const DaemonParts& parts) {
    handle(call, parts.solve_tools(), parts.sessions);
}

void close(const CallPtr& call, const DaemonParts& parts) {
    close_session(call, parts.sessions);
}

void list(const CallPtr& call, const DaemonParts& parts) {
    list_sessions(call, parts.sessions);
}

}  // namespace

void add_session_methods(MethodTable& methods) {
    constexpr auto high = proto::Priority::high;
    methods.add({.name = "session.open", .handle = open});
    methods.add({.name = "session.step", .priority = high, .job = "step", .handle = step});
    methods.add({.name = "session.info", .priority = high, .handle = in_session<tell_session>});
    methods.add({.name = "session.save", .priority = high, .handle = in_session<save_session>});
    methods.add({.name = "session.restore", .priority = high, .handle = in_session<restore_session>});
    methods.add({.name = "session.forget", .priority = high, .handle = in_session<forget_state>});
    methods.add({.name = "session.close", .is_quick = true, .handle = close});
    methods.add({.name = "session.list", .is_quick = true, .handle = list});
}

}  // namespace contactd::server
