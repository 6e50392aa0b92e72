// Names the writer of a temporary file, so that every process that shares the folder can determine whether the writer
// is alive.
#pragma once

#include <filesystem>
#include <string>

namespace contactd {

/// Returns "<boot>-<process>-<start time>-<host>" of this process, which is unique among all processes, past and
/// future.
const std::string& writer_name();

/// Returns true if the writer of this temporary file is certainly dead. A living one holds a lock on its file. If the
/// file system has no locks, or only local ones, the name decides. A file that another machine may still be writing is
/// left to that machine.
bool is_abandoned(const std::filesystem::path& temporary);

}  // namespace contactd
