#include "log.hpp"

#include <spdlog/formatter.h>
#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <string>

#include "contactd/error.hpp"

namespace contactd::server {
namespace {

using nlohmann::json;

/// Marks messages made by log_event, whose payload is the message, this separator, and the fields as a JSON object.
/// Recognised by its address, so that no text can imitate it.
constexpr const char* event_mark = "event";
constexpr char separator = '\x1f';

struct Line {
    std::string_view message;
    json fields = json::array();  // of [key, value]
};

Line line_of(const spdlog::details::log_msg& message) {
    const std::string_view payload(message.payload.data(), message.payload.size());
    if (message.source.filename != event_mark) return {payload};
    const auto end = payload.find(separator);
    return {payload.substr(0, end), json::parse(payload.substr(end + 1))};
}

void append(spdlog::memory_buf_t& line, std::string_view text) {
    line.append(text.data(), text.data() + text.size());
}

/// Returns JSON in ASCII, with all control characters of terminals and line readers escaped.
std::string ascii(const json& value) {
    return value.dump(-1, ' ', true, json::error_handler_t::replace);
}

/// Returns `text` on one line; quotes are kept.
std::string escaped(std::string_view text) {
    const bool is_plain = std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c < '\x7f'; });
    if (is_plain) return std::string(text);
    std::string result;
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t quote = std::min(text.find_first_of("\"\\", start), text.size());
        const std::string part = ascii(std::string(text.substr(start, quote - start)));
        result += part.substr(1, part.size() - 2);
        if (quote < text.size()) result += text[quote];
        start = quote + 1;
    }
    for (std::size_t at = 0; (at = result.find('\x7f', at)) != std::string::npos;) result.replace(at, 1, "\\u007f");
    return result;
}

/// Writes words in capitals (statuses) without quotes, and all other strings with quotes.
std::string shown(const json& value) {
    if (!value.is_string()) return ascii(value);
    const auto& text = value.get_ref<const std::string&>();
    const bool is_plain = !text.empty() && std::all_of(text.begin(), text.end(),
                                                       [](char c) { return (c >= 'A' && c <= 'Z') || c == '_'; });
    return is_plain ? text : escaped(ascii(value));
}

class TextFormatter final : public spdlog::formatter {
   public:
    void format(const spdlog::details::log_msg& message, spdlog::memory_buf_t& line) override {
        spdlog::details::log_msg head = message;
        head.payload = {};
        head_.format(head, line);
        const Line parts = line_of(message);
        append(line, escaped(parts.message));
        for (const json& field : parts.fields) {
            append(line, " " + field[0].get_ref<const std::string&>() + "=");
            append(line, shown(field[1]));
        }
        append(line, "\n");
    }
    std::unique_ptr<spdlog::formatter> clone() const override { return std::make_unique<TextFormatter>(); }

   private:
    spdlog::pattern_formatter head_{"%Y-%m-%dT%H:%M:%S.%e %l ", spdlog::pattern_time_type::local, ""};
};

class JsonFormatter final : public spdlog::formatter {
   public:
    void format(const spdlog::details::log_msg& message, spdlog::memory_buf_t& line) override {
        append(line, "{\"time\":\"");
        time_.format(message, line);
        const Line parts = line_of(message);
        const auto level = spdlog::level::to_string_view(message.level);
        append(line, "\",\"level\":\"" + std::string(level.data(), level.size()) + "\",\"message\":");
        append(line, ascii(std::string(parts.message)));
        for (const json& field : parts.fields) append(line, "," + ascii(field[0]) + ":" + ascii(field[1]));
        append(line, "}\n");
    }
    std::unique_ptr<spdlog::formatter> clone() const override { return std::make_unique<JsonFormatter>(); }

   private:
    spdlog::pattern_formatter time_{"%Y-%m-%dT%H:%M:%S.%eZ", spdlog::pattern_time_type::utc, ""};
};

std::unique_ptr<spdlog::formatter> formatter(bool is_json) {
    if (is_json) return std::make_unique<JsonFormatter>();
    return std::make_unique<TextFormatter>();
}

}  // namespace

Log::Log(const Config& config)
    : file_(config.log.file),
      is_json_(config.log.format == "json"),
      sinks_(std::make_shared<spdlog::sinks::dist_sink_mt>()) {
    try {
        sinks_->add_sink(open());
    } catch (const spdlog::spdlog_ex& error) {
        throw Error("log.file cannot be opened: " + std::string(error.what()));
    }
    const auto logger = std::make_shared<spdlog::logger>("contactd", sinks_);
    logger->set_level(spdlog::level::from_str(config.log.level));
    logger->flush_on(spdlog::level::info);
    spdlog::set_default_logger(logger);
}

Log::~Log() {
    sinks_->flush();
}

std::shared_ptr<spdlog::sinks::sink> Log::open() const {
    std::shared_ptr<spdlog::sinks::sink> sink;
    if (file_.empty())
        sink = std::make_shared<spdlog::sinks::stderr_sink_mt>();
    else
        sink = std::make_shared<spdlog::sinks::basic_file_sink_mt>(file_.string());
    sink->set_formatter(formatter(is_json_));
    return sink;
}

void Log::reopen() {
    if (file_.empty()) return;
    try {
        sinks_->set_sinks({open()});
        spdlog::info("log file reopened");
    } catch (const spdlog::spdlog_ex& error) {
        spdlog::error("the log file cannot be reopened, and the old one stays open: {}", error.what());
    }
}

void log_line(engine::LogLevel level, const std::string& line) {
    constexpr std::array levels{spdlog::level::info, spdlog::level::warn, spdlog::level::err};
    spdlog::log(levels[static_cast<std::size_t>(level)], "{}", line);
}

void log_event(spdlog::level::level_enum level, std::string_view message, std::initializer_list<LogField> fields) {
    if (!spdlog::should_log(level)) return;
    json members = json::array();
    for (const auto& [key, value] : fields) members.push_back({key, value});
    spdlog::log(spdlog::source_loc{event_mark, 1, ""}, level, "{}{}{}", message, separator, ascii(members));
}

}  // namespace contactd::server
