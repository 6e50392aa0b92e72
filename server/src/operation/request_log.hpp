// One line of the log a request.
#pragma once

#include <string>

#include "jobs/call.hpp"

namespace contactd::server {

/// The log's line of an answer: enough to find the request again, nothing of what it holds. Taken from the answer
/// before it goes, written afterwards: the client need not wait for the log.
struct RequestLine {
    std::string id, method, status;
    double milliseconds = 0;
    std::string identity, agent, user;  ///< of the client
};

RequestLine line_of(const Answer& answer);
void write(const RequestLine& line);

}  // namespace contactd::server
