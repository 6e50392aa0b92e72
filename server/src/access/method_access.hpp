// Controls the access of users to methods.
#pragma once

#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "config/config.hpp"
#include "contactd/proto/status.hpp"

namespace contactd::server {

/// Returns the answer to a user who may not call a method: UNIMPLEMENTED if it is disabled, PERMISSION_DENIED if it is
/// restricted to others.
std::optional<proto::Status> refusal(const MethodRules& rules, const std::string& method, const std::string& user);

/// Returns whether a user may use `name`, a method or MethodRules::builds.
bool is_allowed(const MethodRules& rules, const std::string& name, const std::string& user);

/// Returns the OpenRPC document for a user, in which methods that the user may not call have "x-disabled" or
/// "x-denied".
nlohmann::json described_for(const MethodRules& rules, const std::string& user, nlohmann::json document);

}  // namespace contactd::server
