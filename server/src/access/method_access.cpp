#include "method_access.hpp"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

namespace contactd::server {
namespace {

using proto::Status;
using proto::StatusCode;

bool holds(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

Status status(StatusCode code, std::string_view reason, std::string message) {
    return {code, std::move(message), std::string(reason), {}, 0};
}

}  // namespace

bool is_allowed(const MethodRules& rules, const std::string& name, const std::string& user) {
    const auto given = rules.allowed_users.find(name);
    return given == rules.allowed_users.end() || holds(given->second, user);
}

std::optional<Status> refusal(const MethodRules& rules, const std::string& method, const std::string& user) {
    if (holds(rules.disabled, method))
        return status(StatusCode::unimplemented, proto::reason::method_disabled,
                      method + " is disabled by the configuration of this daemon (methods.disabled).");
    if (is_allowed(rules, method, user)) return {};
    return status(
        StatusCode::permission_denied, proto::reason::method_denied,
        method + " is restricted to the users in methods.allowed_users of the daemon's configuration, and " +
            (user.empty() ? "this connection has no user name." : nlohmann::json(user).dump() + " is not among them."));
}

nlohmann::json described_for(const MethodRules& rules, const std::string& user, nlohmann::json document) {
    for (nlohmann::json& method : document.at("methods")) {
        const std::string name = method.at("name");
        if (holds(rules.disabled, name))
            method["x-disabled"] = true;
        else if (!is_allowed(rules, name, user))
            method["x-denied"] = true;
    }
    return document;
}

}  // namespace contactd::server
