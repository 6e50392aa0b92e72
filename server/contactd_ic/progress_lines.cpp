#include "progress_lines.hpp"

#include <time.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace contactd::ic {
namespace {

constexpr auto shortest_interval = std::chrono::milliseconds(50);

/// A step is given up only after this processor time (s) and this multiple of its expected time, because expectations
/// may be ten times too short on the slowest machines. A step that yields the processor between failing attempts, as
/// OpenBLAS does if it gets no memory, is given up after this multiple of the wall-clock time.
constexpr double least_timeout = 10, timeout_factor = 20, idle_factor = 10;

/// A step that takes longer than expected reports at most this fraction.
constexpr double nearly = 0.95;

double processor_seconds() {
    timespec used{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
    return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

/// Returns the remaining time at the pace so far, if known.
std::optional<double> left_at_pace(double elapsed, double fraction) {
    constexpr double least_seconds = 2, least_fraction = 0.05;
    if (elapsed < least_seconds || fraction < least_fraction) return std::nullopt;
    return elapsed * (1 - fraction) / fraction;
}

}  // namespace

ProgressLines::ProgressLines(Lines& lines) : lines_(lines), processor_seconds_(processor_seconds()) {}

nlohmann::json ProgressLines::line(Clock::time_point now) const {
    const auto seconds = [&](Clock::time_point since) { return std::chrono::duration<double>(now - since).count(); };
    const double in_step = seconds(reported_);
    double fraction = last_.fraction;
    if (last_.step_seconds > 0)
        fraction += (last_.step_fraction - fraction) * std::min(in_step / last_.step_seconds, nearly);
    nlohmann::json result = {
        {"stage", stage_}, {"fraction", fraction}, {"iteration", last_.iteration}, {"residual", last_.residual}};
    const auto left =
        last_.seconds_left ? std::optional(*last_.seconds_left - in_step) : left_at_pace(seconds(begin_), fraction);
    if (left && std::isfinite(*left)) result["seconds_left"] = std::max(*left, 0.0);
    if (memory_bytes_ && std::isfinite(*memory_bytes_)) result["memory_bytes"] = std::llround(*memory_bytes_);
    return result;
}

void ProgressLines::on_progress(const Progress& progress) {
    const std::scoped_lock lock(mutex_);
    const auto now = Clock::now();
    const bool same_stage = progress.stage == stage_;
    stage_ = progress.stage;
    last_ = progress;
    reported_ = now;
    processor_seconds_ = processor_seconds();
    if (same_stage && now < next_) return;
    next_ = now + shortest_interval;
    lines_.write(line(now));
}

void ProgressLines::tick() {
    const std::scoped_lock lock(mutex_);
    if (stage_.empty() || last_.step_seconds == 0) return;
    lines_.write_unless_stuck(line(Clock::now()));
}

bool ProgressLines::is_stuck() const {
    const std::scoped_lock lock(mutex_);
    const double timeout = least_timeout + timeout_factor * last_.step_seconds;
    const double seconds = std::chrono::duration<double>(Clock::now() - reported_).count();
    return processor_seconds() - processor_seconds_ > timeout || seconds > idle_factor * timeout;
}

}  // namespace contactd::ic
