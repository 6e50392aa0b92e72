// Ends the program immediately, even inside MFEM and hypre: on a signal (SIGTERM, SIGINT, SIGHUP), if it exceeds its
// memory limit, or if no program waits for it any more (end of standard input, --exit-with-stdin). Under mpirun the
// other processes end as well, because a process that exits without MPI_Finalize terminates all.
#pragma once

#include <sys/types.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "lines.hpp"
#include "progress_lines.hpp"

namespace contactd::ic {

/// Exit statuses of contactd-ic; 128 + n if signal n ended it.
enum ExitCode { success = 0, failure = 1, bad_input = 2, not_converged = 3, out_of_memory = 4 };

/// Blocks the signals in this thread and all threads that it starts, so that only the guard receives them. Must be
/// called before MPI starts threads.
void hold_signals_back();

class Guard {
   public:
    /// With `silent` the guard ends the program without a message. Among several processes the first message must be
    /// that of the one that failed, not those of processes that the launcher signals.
    Guard(Lines& lines, bool silent);
    ~Guard();
    Guard(const Guard&) = delete;
    Guard& operator=(const Guard&) = delete;

    /// Lets the end of standard input end the program from now on.
    void watch_standard_input();
    /// Stops watching, because the result is available and reported.
    void stand_down();
    /// Writes {"heartbeat": rank, "processes"} four times a second from now on, and the estimated progress of a long
    /// step. A program of one process writes nothing if it used no processor time, because it is then stuck. Neither
    /// does one whose step used far more time than expected, because it hangs in a loop. `progress` must outlive the
    /// guard.
    void beat(int rank, int processes, ProgressLines& progress);
    /// Ends the program from now on if `processes` together use more memory than `bytes`.
    void watch_memory(std::vector<pid_t> processes, std::uint64_t bytes);
    /// Returns a lock to hold while the result is written. The guard waits for it for a while, so that no temporary
    /// file is left behind.
    std::timed_mutex& writing() { return writing_; }

   private:
    void watch();
    int milliseconds_to_beat();
    int milliseconds_to_look_at_memory();
    bool lives();
    /// Returns only after stand_down().
    void end(int exit_code, const std::string& why, const std::string& kind = "");

    Lines& lines_;
    bool silent_;
    std::timed_mutex writing_;
    std::atomic<bool> watching_input_ = false;
    std::atomic<int> rank_ = -1;  ///< negative: no heartbeat
    std::atomic<int> processes_ = 1;
    std::atomic<bool> standing_down_ = false;
    std::atomic<ProgressLines*> progress_ = nullptr;
    std::vector<pid_t> watched_processes_;        ///< fixed once most_memory_ is set
    std::atomic<std::uint64_t> most_memory_ = 0;  ///< 0: not watched
    int signals_ = -1, wake_ = -1;
    std::chrono::steady_clock::time_point next_beat_{};
    std::chrono::nanoseconds processor_time_{};
    std::thread thread_;
};

}  // namespace contactd::ic
