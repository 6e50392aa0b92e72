// The handlers of methods that have a source of their own, which bears the method's name.
#pragma once

#include "daemon_parts.hpp"

namespace contactd::server {

/// contact.solve_many, from the I/O thread: answers `call` when all solves have ended; what cannot be solved fails
/// alone. Each problem is decoded, solved and encoded by the worker that takes it. As many as there are workers are on
/// their way at a time, so that other requests run in between.
void queue_problems(const CallPtr& call, const DaemonParts& parts);

/// session.step_many, from the I/O thread: queues each step in its session, and answers when all have run.
void queue_steps(const CallPtr& call, const DaemonParts& parts);

/// ic.list, ic.delete. Both throw StatusError for what cannot be done.
void list_tables(const CallPtr& call, const DaemonParts& parts);
void delete_tables(const CallPtr& call, const DaemonParts& parts);

/// ic.export: fetches the coefficients of one body or of two, and makes a file of them on a worker. Throws StatusError
/// for bad parameters, and for a text of more than limits.max_frame_bytes.
void export_table(const CallPtr& call, const DaemonParts& parts);

/// ic.import: takes a table of somebody's into the store. Throws InvalidArgument ("attributes...", "datasets...") for
/// what is no table, or not what it claims to be.
void import_table(const CallPtr& call, const DaemonParts& parts);

}  // namespace contactd::server
