#include "lines.hpp"

#include <poll.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>

#include "contactd/proto/message.hpp"

namespace contactd::ic {
namespace {

constexpr auto longest_wait = std::chrono::milliseconds(200);

}  // namespace

nlohmann::json error_line(const Complaint& complaint) {
    nlohmann::json error = {{"field", complaint.field}, {"message", complaint.message}};
    if (!complaint.kind.empty()) error["kind"] = complaint.kind;
    if (!complaint.problem.empty()) error["problem"] = complaint.problem;
    return {{"error", std::move(error)}};
}

void Lines::write(const nlohmann::json& line) {
    const std::string text = proto::dump(line) + "\n";
    const std::lock_guard lock(mutex_);
    std::fwrite(text.data(), 1, text.size(), stdout);
    std::fflush(stdout);
}

void Lines::write_table(const std::vector<unsigned char>& bytes, const std::string& problem) {
    const std::string text = proto::dump({{"table_bytes", bytes.size()}, {"problem", problem}}) + "\n";
    const std::lock_guard lock(mutex_);
    std::fwrite(text.data(), 1, text.size(), stdout);
    std::fwrite(bytes.data(), 1, bytes.size(), stdout);
    std::fflush(stdout);
}

void Lines::write_error(const Complaint& complaint) {
    std::fprintf(stderr, "contactd-ic: %s\n", complaint.message.c_str());
    write(error_line(complaint));
}

void Lines::write_unless_stuck(const nlohmann::json& line) {
    const std::unique_lock<std::timed_mutex> lock(mutex_, longest_wait);
    pollfd output{STDOUT_FILENO, POLLOUT, 0};
    if (!lock.owns_lock() || ::poll(&output, 1, 0) != 1 || !(output.revents & POLLOUT)) return;
    const std::string text = proto::dump(line) + "\n";
    [[maybe_unused]] const ssize_t written = ::write(STDOUT_FILENO, text.data(), text.size());
}

}  // namespace contactd::ic
