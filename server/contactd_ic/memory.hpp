// Measures the memory used by a build, and the memory of the machine.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <vector>

namespace contactd::ic {

/// Returns the total resident bytes of these processes, counting libraries in each. Processes that have ended count as
/// zero.
std::uint64_t resident_bytes(const std::vector<pid_t>& processes);

/// Returns the memory (bytes) of this machine, or the limit of this process's control groups (version 2).
std::uint64_t machine_memory();

/// Returns the default share of memory for a build; the rest is for the daemon, the kernel and other programs.
inline constexpr double usable_share = 0.8;

/// Lets the kernel end this process before any other if memory runs out (oom_score_adj).
void volunteer_for_the_kernel();

}  // namespace contactd::ic
