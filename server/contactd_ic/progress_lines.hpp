// How far a build is, as lines, and whether it gets on.
#pragma once

#include <chrono>
#include <mutex>
#include <optional>
#include <string>

#include "contactd/observer.hpp"
#include "lines.hpp"

namespace contactd::ic {

/// {"stage", "fraction", "iteration", "residual", "seconds_left", "memory_bytes"}: every change of stage, else no more
/// than twenty a second. Thread-safe.
class ProgressLines : public Observer {
   public:
    explicit ProgressLines(Lines& lines);
    void on_progress(const Progress& progress) override;
    /// Sets the memory that the whole build is expected to take (bytes), if that is known; each line has it. To be
    /// called before any progress.
    void expect_memory(std::optional<double> bytes) { memory_bytes_ = bytes; }

    /// To be called several times a second by another thread: says how far a long step should be by now, by the time it
    /// was expected to take.
    void tick();
    /// Whether the step at hand takes so long, many times what was expected of it, that it will never end.
    bool is_stuck() const;

   private:
    using Clock = std::chrono::steady_clock;

    nlohmann::json line(Clock::time_point now) const;

    Lines& lines_;
    std::optional<double> memory_bytes_;
    mutable std::mutex mutex_;
    Progress last_;
    std::string stage_;  ///< of last_, which points to it
    const Clock::time_point begin_ = Clock::now();
    Clock::time_point reported_ = begin_, next_{};
    double processor_seconds_;  ///< when last_ was reported
};

}  // namespace contactd::ic
