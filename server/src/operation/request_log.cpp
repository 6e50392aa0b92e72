#include "operation/request_log.hpp"

#include <cmath>

#include "operation/log.hpp"

namespace contactd::server {
namespace {

/// Returns the name of a client in the log: the identity of its connection in hexadecimal.
std::string name_of(const std::string& identity) {
    constexpr const char* digits = "0123456789abcdef";
    std::string name;
    for (const unsigned char byte : identity.substr(0, 16)) name += {digits[byte >> 4], digits[byte & 15]};
    return name;
}

}  // namespace

RequestLine line_of(const Answer& answer) {
    return {answer.id,    answer.method,    answer.status, answer.milliseconds, answer.route.identity,
            answer.agent, answer.route.user};
}

void write(const RequestLine& line) {
    log_event(spdlog::level::info, "request",
              {{"id", line.id},
               {"method", line.method},
               {"status", line.status},
               {"ms", std::round(line.milliseconds * 1000) / 1000},
               {"client", name_of(line.identity)},
               {"agent", line.agent},
               {"user", line.user}});
}

}  // namespace contactd::server
