#include "builder_listener.hpp"

#include <algorithm>
#include <cctype>

namespace contactd::engine {
namespace {

constexpr std::size_t longest_line = 1 << 20;
constexpr std::size_t kept_error_bytes = 4096;
constexpr std::size_t largest_table = std::size_t(1) << 32;
constexpr double most_processes = 1 << 20;
constexpr double most_memory = 1e18;

double number(const nlohmann::json& line, const char* name) {
    const auto at = line.find(name);
    return at != line.end() && at->is_number() ? at->get<double>() : 0.0;
}

std::string text(const nlohmann::json& line, const char* name) {
    const auto at = line.find(name);
    return at != line.end() && at->is_string() ? at->get<std::string>() : std::string();
}

}  // namespace

void BuilderListener::hear_output(std::string_view bytes) {
    has_begun_ = true;
    while (!bytes.empty()) {
        if (awaited_ > 0) {
            const std::size_t size = std::min(awaited_, bytes.size());
            table_.bytes.insert(table_.bytes.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
            bytes.remove_prefix(size);
            awaited_ -= size;
            heard_[0] = Clock::now();
            continue;
        }
        const std::size_t end = bytes.find('\n');
        if (line_.size() <= longest_line) line_ += bytes.substr(0, end);
        if (end == std::string_view::npos) return;
        bytes.remove_prefix(end + 1);
        hear_line(line_);
        line_.clear();
    }
}

void BuilderListener::hear_error(std::string_view bytes) {
    messages_ += bytes;
    if (messages_.size() > kept_error_bytes) messages_.erase(0, messages_.size() - kept_error_bytes);
}

BuilderListener::Clock::duration BuilderListener::silence() const {
    if (!has_begun_) return {};
    const auto quietest = std::min_element(heard_.begin(), heard_.end(),
                                           [](const auto& a, const auto& b) { return a.second < b.second; });
    return Clock::now() - quietest->second;
}

std::string BuilderListener::complaint() const {
    if (!complaint_.empty()) return complaint_;
    std::string messages = messages_;
    while (!messages.empty() && std::isspace(static_cast<unsigned char>(messages.back()))) messages.pop_back();
    return messages;
}

void BuilderListener::hear_line(std::string_view line) {
    const auto json = nlohmann::json::parse(line, nullptr, false);
    if (!json.is_object()) return;  // a launcher may chat
    if (json.contains("heartbeat")) return hear_heartbeat(json);
    heard_[0] = Clock::now();
    if (const auto error = json.find("error"); error != json.end() && error->is_object()) {
        complaint_ = text(*error, "message");
        kind_ = text(*error, "kind");
        field_ = text(*error, "field");
        problem_ = text(*error, "problem");
    }
    if (json.contains("table_bytes")) {
        const double size = number(json, "table_bytes");
        if (size > 0 && size <= static_cast<double>(largest_table)) awaited_ = static_cast<std::size_t>(size);
        table_.problem = text(json, "problem");
    }
    if (const auto stage = json.find("stage"); stage != json.end() && stage->is_string()) hear_progress(json);
}

/// The first heartbeat of any process starts the clock of all, so a process that stops before its first one is also
/// noticed.
void BuilderListener::hear_heartbeat(const nlohmann::json& line) {
    const auto processes = static_cast<int>(std::clamp(number(line, "processes"), 1.0, most_processes));
    for (int rank = static_cast<int>(heard_.size()); rank < processes; ++rank) heard_[rank] = Clock::now();
    if (const auto heard = heard_.find(static_cast<int>(std::clamp(number(line, "heartbeat"), 0.0, most_processes)));
        heard != heard_.end())
        heard->second = Clock::now();
}

void BuilderListener::hear_progress(const nlohmann::json& line) {
    JobProgress progress{line["stage"].get<std::string>(), std::clamp(number(line, "fraction"), 0.0, 1.0),
                         static_cast<int>(number(line, "iteration")), number(line, "residual")};
    if (line.contains("seconds_left")) progress.seconds_left = std::max(number(line, "seconds_left"), 0.0);
    if (line.contains("memory_bytes"))
        progress.memory_bytes = static_cast<std::uint64_t>(std::clamp(number(line, "memory_bytes"), 0.0, most_memory));
    on_progress_(progress);
}

}  // namespace contactd::engine
