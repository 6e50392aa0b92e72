// Writes one line of the log per request.
#pragma once

#include <string>

#include "jobs/call.hpp"

namespace contactd::server {

/// Represents the log's line for an answer, with enough data to identify the request, but not its content. It is
/// created before the answer is sent and written afterwards, so that the client does not wait for the log.
struct RequestLine {
    std::string id, method, status;
    double milliseconds = 0;
    std::string identity, agent, user;  ///< of the client
};

RequestLine line_of(const Answer& answer);
void write(const RequestLine& line);

}  // namespace contactd::server
