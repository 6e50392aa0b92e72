// Declares the handlers of methods with a separate source file, which has the method's name.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>

#include "daemon_parts.hpp"

namespace contactd::server {

/// Handles contact.solve_many in the I/O thread. Answers `call` when all solves have ended; invalid problems fail
/// individually. Each problem is decoded, solved and encoded by the worker that takes it. At most one problem per
/// worker runs at a time, so that other requests run in between.
void queue_problems(const CallPtr& call, const DaemonParts& parts);

/// Handles session.step_many in the I/O thread: queues each step in its session, and answers when all have run.
void queue_steps(const CallPtr& call, const DaemonParts& parts);

/// Handle ic.list and ic.delete. Both throw StatusError.
void list_tables(const CallPtr& call, const DaemonParts& parts);
void delete_tables(const CallPtr& call, const DaemonParts& parts);

/// Handles ic.export: fetches the coefficients of one or two bodies, and writes them to a file in a worker. Throws
/// StatusError for invalid parameters, and for a text of more than limits.max_frame_bytes.
void export_table(const CallPtr& call, const DaemonParts& parts);

/// Handles ic.import: stores a user's table. Throws InvalidArgument ("attributes...", "datasets...") if it is not a
/// table, or not the claimed one.
void import_table(const CallPtr& call, const DaemonParts& parts);

/// Returns the largest number of elements of a case of contact_file.run and contact_file.convert.
std::size_t max_elements_of(const nlohmann::json& params, const Config& config);
/// Handles contact_file.run: solves cases until the time of the call is over, and keeps the run if cases are left.
void run_contact_file(const CallPtr& call, const DaemonParts& parts);
/// Handles contact_file.convert.
void convert_contact_file(const CallPtr& call, const DaemonParts& parts);

}  // namespace contactd::server
