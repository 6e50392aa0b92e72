// Access of users to methods.
#pragma once

#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "config/config.hpp"
#include "contactd/proto/status.hpp"

namespace contactd::server {

/// The answer to a user who may not call a method: UNIMPLEMENTED where it is off, PERMISSION_DENIED where it is
/// given to others.
std::optional<proto::Status> refusal(const MethodRules& rules, const std::string& method, const std::string& user);

/// Whether a user may do what `name` stands for, a method or MethodRules::builds.
bool is_allowed(const MethodRules& rules, const std::string& name, const std::string& user);

/// The OpenRPC document as it holds for a user: methods that he may not call have "x-disabled" or "x-denied".
nlohmann::json described_for(const MethodRules& rules, const std::string& user, nlohmann::json document);

}  // namespace contactd::server
