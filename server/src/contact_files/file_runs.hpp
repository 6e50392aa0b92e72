// Stores runs of input files of the CONTACT program that wait for their next call.
#pragma once

#include <chrono>
#include <list>
#include <memory>
#include <mutex>
#include <string>

#include "run/case_run.hpp"

namespace contactd::server {

/// Thread-safe. Keeps the runs that were used last for a while.
class FileRuns {
   public:
    using Clock = std::chrono::steady_clock;
    using RunPtr = std::unique_ptr<cases::CaseRun>;

    /// Stores a run, and returns its name: 128 random bits in hexadecimal, or `name` if the run has one.
    std::string keep(RunPtr run, std::string name = {});
    /// Removes a run from the store and returns it. Throws StatusError (NOT_FOUND).
    RunPtr take(const std::string& name);

   private:
    struct Kept {
        std::string name;
        RunPtr run;
        Clock::time_point since;
    };
    void forget_old();

    std::mutex mutex_;
    std::list<Kept> runs_;  // the last used one at the end
};

}  // namespace contactd::server
