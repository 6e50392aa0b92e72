// Writes the daemon's log: one line per event, as text or as a JSON object.
#pragma once

#include <spdlog/common.h>
#include <spdlog/sinks/dist_sink.h>

#include <filesystem>
#include <initializer_list>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "config/config.hpp"
#include "engine/operation/engine_log.hpp"

namespace contactd::server {

/// Receives the messages of spdlog during its lifetime. Values chosen by clients (ids, names) cannot start a line or
/// imitate a field, because control characters are escaped and strings quoted.
class Log {
   public:
    /// Throws Error when the file cannot be opened.
    explicit Log(const Config& config);
    ~Log();
    Log(const Log&) = delete;
    Log& operator=(const Log&) = delete;

    /// Reopens the file by its name, after it was moved (logrotate). If that fails, the old one stays open.
    void reopen();

   private:
    std::shared_ptr<spdlog::sinks::sink> open() const;

    const std::filesystem::path file_;
    const bool is_json_;
    std::shared_ptr<spdlog::sinks::dist_sink_mt> sinks_;
};

/// Writes a line of the service or of its engine.
void log_line(engine::LogLevel level, const std::string& line);

using LogField = std::pair<std::string_view, nlohmann::json>;

/// Writes a message with fields: `message key=value key="value"` as text, members of the line's object as JSON.
/// `message` is the daemon's own text, not a client's.
void log_event(spdlog::level::level_enum level, std::string_view message, std::initializer_list<LogField> fields);

}  // namespace contactd::server
