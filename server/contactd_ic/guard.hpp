// Ends the program at once, whatever MFEM and hypre are doing, on a signal (SIGTERM, SIGINT, SIGHUP), when it
// uses more memory than it may, or when nobody is left who waits for it (end of standard input, --exit-with-stdin).
// Under mpirun the others follow, because a process that leaves without MPI_Finalize takes all with it.
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

/// Holds the signals back in this thread and all that it starts, so that only the guard sees them. To be called before
/// MPI starts threads of its own.
void hold_signals_back();

class Guard {
   public:
    /// With `silent` the guard ends the program without a word: among several processes the first words are those of
    /// the one that failed, and the launcher's signals to the others must not cover them.
    Guard(Lines& lines, bool silent);
    ~Guard();
    Guard(const Guard&) = delete;
    Guard& operator=(const Guard&) = delete;

    /// From now on the end of standard input ends the program.
    void watch_standard_input();
    /// From now on nothing ends the program: the result is there and reported.
    void stand_down();
    /// From now on says {"heartbeat": rank, "processes"} four times a second, and how far a long step should be.
    /// A program of one process says nothing when it used no processor time meanwhile: one that waits for something is
    /// stuck. So is one whose step used far more than was expected of it: it spins. `progress` must outlive the guard.
    void beat(int rank, int processes, ProgressLines& progress);
    /// From now on the program ends when `processes` use more memory than `bytes` together.
    void watch_memory(std::vector<pid_t> processes, std::uint64_t bytes);
    /// Held while the result is written: the guard waits for it a while, so that no temporary file stays behind.
    std::timed_mutex& writing() { return writing_; }

   private:
    void watch();
    int milliseconds_to_beat();
    int milliseconds_to_look_at_memory();
    bool lives();
    /// Returns only when standing down.
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
