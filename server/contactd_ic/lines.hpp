// What contactd-ic says: one JSON object a line on standard output, flushed.
#pragma once

#include <chrono>
#include <mutex>
#include <string>

#include <nlohmann/json.hpp>

#include "contactd/observer.hpp"

namespace contactd::ic {

class Lines {
   public:
    void write(const nlohmann::json& line);
    /// The last word of a failing run: {"error": {"field", "message"}}, and the sentence on standard error.
    void write_error(const std::string& field, const std::string& message);
    /// The same from another thread, left out when a reader that does not read would make it wait.
    void write_error_unless_stuck(const std::string& message);

   private:
    std::timed_mutex mutex_;
};

/// Progress as lines: every change of stage, else no more than twenty a second.
class ProgressLines : public Observer {
   public:
    explicit ProgressLines(Lines& lines) : lines_(lines) {}
    void on_progress(const Progress& progress) override;

   private:
    Lines& lines_;
    std::string stage_;
    std::chrono::steady_clock::time_point next_{};
};

}  // namespace contactd::ic
