// Logs an engine's background work: builds, renamed damaged files, disk problems.
#pragma once

#include <functional>
#include <string>

namespace contactd::engine {

enum class LogLevel { info, warning, error };

/// Receives a line, from any thread. Empty: lines are dropped.
using LogSink = std::function<void(LogLevel, const std::string&)>;

class EngineLog {
   public:
    explicit EngineLog(LogSink sink = {}) : sink_(std::move(sink)) {}

    void info(const std::string& line) const { write(LogLevel::info, line); }
    void warn(const std::string& line) const { write(LogLevel::warning, line); }
    void error(const std::string& line) const { write(LogLevel::error, line); }

   private:
    void write(LogLevel level, const std::string& line) const {
        if (sink_) sink_(level, line);
    }

    LogSink sink_;
};

}  // namespace contactd::engine
