// Measures the duration of solves.
#pragma once

#include <chrono>
#include <ctime>

#include "handles/contact_case.hpp"

namespace contactd::cntc {

/// Returns the processor time of this thread (s).
inline double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Adds the time of its own lifetime to a total.
class Stopwatch {
   public:
    explicit Stopwatch(CalculationTime& time) : time_(time) {}
    ~Stopwatch() {
        time_.cpu += processor_seconds() - cpu_;
        time_.wall += std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_).count();
    }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

   private:
    CalculationTime& time_;
    double cpu_ = processor_seconds();
    std::chrono::steady_clock::time_point wall_ = std::chrono::steady_clock::now();
};

}  // namespace contactd::cntc
