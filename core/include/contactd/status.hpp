// Defines the status of a request: gRPC's status codes, which every reply contains, and contactd's stable reasons.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "contactd/error.hpp"

namespace contactd {

/// gRPC defines these numbers and names.
enum class StatusCode {
    ok = 0,
    cancelled = 1,
    unknown = 2,
    invalid_argument = 3,
    deadline_exceeded = 4,
    not_found = 5,
    already_exists = 6,
    permission_denied = 7,
    resource_exhausted = 8,
    failed_precondition = 9,
    aborted = 10,
    out_of_range = 11,
    unimplemented = 12,
    internal = 13,
    unavailable = 14,
    data_loss = 15,
    unauthenticated = 16
};
std::string_view name_of(StatusCode code);  ///< "INVALID_ARGUMENT", ...
/// Returns the code with that name. Throws std::out_of_range for other names.
StatusCode code_named(std::string_view name);

/// Reasons are stable upper-case keywords for programs; see docs/protocol.md for their meanings.
namespace reason {
inline constexpr std::string_view not_json = "NOT_JSON";
inline constexpr std::string_view not_an_object = "NOT_AN_OBJECT";
inline constexpr std::string_view envelope_invalid = "ENVELOPE_INVALID";
inline constexpr std::string_view protocol_version = "PROTOCOL_VERSION";
inline constexpr std::string_view unknown_method = "UNKNOWN_METHOD";
inline constexpr std::string_view method_disabled = "METHOD_DISABLED";
inline constexpr std::string_view method_denied = "METHOD_DENIED";
inline constexpr std::string_view build_denied = "BUILD_DENIED";
inline constexpr std::string_view field_invalid = "FIELD_INVALID";
inline constexpr std::string_view array_invalid = "ARRAY_INVALID";
inline constexpr std::string_view limit_exceeded = "LIMIT_EXCEEDED";
inline constexpr std::string_view queue_full = "QUEUE_FULL";
inline constexpr std::string_view rate_limited = "RATE_LIMITED";
inline constexpr std::string_view too_many_open = "TOO_MANY_OPEN";
inline constexpr std::string_view key_revoked = "KEY_REVOKED";
inline constexpr std::string_view build_failed = "BUILD_FAILED";
inline constexpr std::string_view build_out_of_memory = "BUILD_OUT_OF_MEMORY";
inline constexpr std::string_view build_quarantined = "BUILD_QUARANTINED";
inline constexpr std::string_view job_cancelled = "JOB_CANCELLED";
inline constexpr std::string_view request_cancelled = "REQUEST_CANCELLED";
inline constexpr std::string_view client_gone = "CLIENT_GONE";
inline constexpr std::string_view request_unknown = "REQUEST_UNKNOWN";
inline constexpr std::string_view answer_too_large = "ANSWER_TOO_LARGE";
inline constexpr std::string_view deadline_passed = "DEADLINE_PASSED";
inline constexpr std::string_view job_unknown = "JOB_UNKNOWN";
inline constexpr std::string_view solve_unknown = "SOLVE_UNKNOWN";
inline constexpr std::string_view session_unknown = "SESSION_UNKNOWN";
inline constexpr std::string_view session_expired = "SESSION_EXPIRED";
inline constexpr std::string_view session_limit = "SESSION_LIMIT";
inline constexpr std::string_view run_unknown = "RUN_UNKNOWN";
inline constexpr std::string_view state_unknown = "STATE_UNKNOWN";
inline constexpr std::string_view step_out_of_order = "STEP_OUT_OF_ORDER";
inline constexpr std::string_view step_differs = "STEP_DIFFERS";
inline constexpr std::string_view not_converged = "NOT_CONVERGED";
inline constexpr std::string_view ic_unknown = "IC_UNKNOWN";
inline constexpr std::string_view store_unusable = "STORE_UNUSABLE";
inline constexpr std::string_view stopping = "STOPPING";
inline constexpr std::string_view unexpected = "UNEXPECTED";
}  // namespace reason

/// Describes an invalid field of a request. `field` is a path from the envelope's root or, below "params", from there:
/// "grid.nx", "bodies.upper.nu", "gap.array".
struct Violation {
    std::string field;
    std::string description;
};

struct Status {
    StatusCode code = StatusCode::ok;
    std::string message;
    std::string reason;                 ///< empty for ok
    std::vector<Violation> violations;  ///< for an invalid argument
    int retry_delay_ms = 0;             ///< for a full queue or a table in quarantine, else 0
    std::vector<int> versions{};        ///< supported versions of the protocol, if another one was requested

    bool ok() const { return code == StatusCode::ok; }
};

/// Wraps a status as an exception: the server answers with it, and the C++ client throws it.
class StatusError : public Error {
   public:
    explicit StatusError(Status status) : Error(status.message), status_(std::move(status)) {}
    StatusError(StatusCode code, std::string_view reason, std::string message);
    const Status& status() const noexcept { return status_; }

   private:
    Status status_;
};

/// Returns INVALID_ARGUMENT for one field, with the message "<field> <problem>".
StatusError invalid_field(std::string field, const std::string& problem, std::string_view why = reason::field_invalid);

/// Returns the status of a thrown exception.
Status status_of(const std::exception& error);

}  // namespace contactd
