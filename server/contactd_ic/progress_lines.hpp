// Writes the progress of a build as lines, and detects a build that hangs.
#pragma once

#include <chrono>
#include <mutex>
#include <optional>
#include <string>

#include "contactd/observer.hpp"
#include "lines.hpp"

namespace contactd::ic {

/// {"stage", "fraction", "iteration", "residual", "seconds_left", "memory_bytes"}: each change of stage, otherwise at
/// most twenty lines per second. Thread-safe.
class ProgressLines : public Observer {
   public:
    explicit ProgressLines(Lines& lines);
    void on_progress(const Progress& progress) override;
    /// Sets the expected memory of the whole build (bytes) for all lines, if it is known. Must be called before any
    /// progress.
    void expect_memory(std::optional<double> bytes) { memory_bytes_ = bytes; }

    /// Must be called several times a second by another thread. Writes the estimated progress of a long step, from its
    /// expected time.
    void tick();
    /// Returns whether the current step has exceeded its expected time so much that it will not end.
    bool is_stuck() const;

   private:
    using Clock = std::chrono::steady_clock;

    nlohmann::json line(Clock::time_point now) const;

    Lines& lines_;
    std::optional<double> memory_bytes_;
    mutable std::mutex mutex_;
    Progress last_;
    std::string stage_;  ///< text of last_, which points to it
    const Clock::time_point begin_ = Clock::now();
    Clock::time_point reported_ = begin_, next_{};
    double processor_seconds_;  ///< when last_ was reported
};

}  // namespace contactd::ic
