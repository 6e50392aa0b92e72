// Memory that a build takes, and memory that the machine has.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <vector>

namespace contactd::ic {

/// Resident bytes of these processes together, libraries counted in each. One that has ended counts nothing.
std::uint64_t resident_bytes(const std::vector<pid_t>& processes);

/// The memory (bytes) of this machine, or what the control groups of this process (version 2) allow of it.
std::uint64_t machine_memory();

/// The share of memory that a build may use by default: the rest is for the daemon, the kernel and other programs.
inline constexpr double usable_share = 0.8;

/// Has the kernel end this process, before any other, when memory runs out (oom_score_adj).
void volunteer_for_the_kernel();

}  // namespace contactd::ic
