// Who writes a temporary file: a name from which every process that shares the folder can tell whether its writer
// lives.
#pragma once

#include <filesystem>
#include <string>

namespace contactd {

/// "<boot>-<process>-<start time>-<host>" of this process: no other process, before or after, has the same.
const std::string& writer_name();

/// True when it is certain that the writer of this temporary file is dead. A living one holds a lock on its file; where
/// the file system has no locks, or keeps them to each machine, the name decides, and what another machine may still be
/// writing is left to that machine.
bool is_abandoned(const std::filesystem::path& temporary);

}  // namespace contactd
