// Exceptions of the client beside InvalidArgument (a problem that cannot be solved as stated, found before anything is
// sent). contactd::Error is the base of all.
#pragma once

#include "contactd/error.hpp"
#include "contactd/status.hpp"

namespace contactd::client {

/// The daemon's own answers; docs/protocol.md lists codes and reasons.
using contactd::Status;
using contactd::StatusCode;
using contactd::StatusError;
using contactd::Violation;

/// The daemon cannot be reached: bad endpoint, or nobody listens there.
class ConnectionError : public Error {
   public:
    using Error::Error;
};

/// No answer within the call's timeout. A build goes on in the daemon, and asking again joins it; a late answer is
/// discarded.
class TimeoutError : public Error {
   public:
    using Error::Error;
};

/// A client or session that is in use was used once more, by another thread or in on_progress, or a session was used in
/// a process that was forked from its own. Nothing was sent, and the call that runs goes on.
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
