// Where an engine writes what happens behind its calls: builds, files that were set aside, a disk in trouble.
#pragma once

#include <functional>
#include <string>

namespace contactd::engine {

enum class LogLevel { info, warning, error };

/// Takes a line, from any thread. Empty: nobody listens.
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
