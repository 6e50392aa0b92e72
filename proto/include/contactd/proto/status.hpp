// Statuses as JSON.
#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "contactd/status.hpp"

namespace contactd::proto {

// Every reply contains a status, so these texts are part of the protocol.
using contactd::code_named;
using contactd::invalid_field;
using contactd::name_of;
using contactd::Status;
using contactd::StatusCode;
using contactd::StatusError;
using contactd::Violation;
namespace reason = contactd::reason;

/// {"code", "name", "message", "details": {"reason", "violations", "retry_delay_ms", "versions"}} without empty
/// details.
nlohmann::json to_json(const Status& status);
/// Throws StatusError (UNKNOWN) if `json` is not a status.
Status status_from_json(const nlohmann::json& json);

}  // namespace contactd::proto
