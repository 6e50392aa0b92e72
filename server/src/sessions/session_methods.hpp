// session.open, step, info, save, restore, forget, close and list.
#pragma once

#include "jobs/call.hpp"
#include "session_table.hpp"
#include "solves/solve_task.hpp"

namespace contactd::server {

/// Answers `call` when the session is ready: a build is awaited, and reported, as by contact.solve. Throws for what
/// cannot be opened.
void open_session(const CallPtr& call, const SolveTools& tools, SessionTable& sessions);

/// These take their turn in the session. Throw when there is no such session.
void step_session(const CallPtr& call, const SolveTools& tools, SessionTable& sessions);
void tell_session(const CallPtr& call, const SolveTools& tools, SessionTable& sessions);
void save_session(const CallPtr& call, const SolveTools& tools, SessionTable& sessions);
void restore_session(const CallPtr& call, const SolveTools& tools, SessionTable& sessions);
void forget_state(const CallPtr& call, const SolveTools& tools, SessionTable& sessions);

/// These take no time.
void close_session(const CallPtr& call, SessionTable& sessions);
void list_sessions(const CallPtr& call, const SessionTable& sessions);

}  // namespace contactd::server
