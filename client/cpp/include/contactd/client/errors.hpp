// Exceptions of the client in addition to InvalidArgument (invalid input, detected before anything is sent).
// contactd::Error is the base of all.
#pragma once

#include "contactd/error.hpp"
#include "contactd/status.hpp"

namespace contactd::client {

/// The daemon's own answers; docs/protocol.md lists codes and reasons.
using contactd::Status;
using contactd::StatusCode;
using contactd::StatusError;
using contactd::Violation;

/// The daemon cannot be reached: the endpoint is malformed, or there is no daemon at it.
class ConnectionError : public Error {
   public:
    using Error::Error;
};

/// No answer arrived within the timeout of the call. A build continues in the daemon, and a repeated request joins it.
/// A late answer is discarded.
class TimeoutError : public Error {
   public:
    using Error::Error;
};

/// A client or session was used during one of its calls, by another thread or in on_progress, or a session was used in
/// a process that was forked from its own. Nothing was sent, and the running call continues.
class ConcurrencyError : public Error {
   public:
    using Error::Error;
};

/// The daemon sent a message that is not a reply of this protocol.
class ProtocolError : public Error {
   public:
    using Error::Error;
};

}  // namespace contactd::client
