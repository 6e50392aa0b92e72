#include "contactd/proto/status.hpp"

#include "contactd/proto/object.hpp"

namespace contactd::proto {
namespace {

constexpr int last_code = static_cast<int>(StatusCode::unauthenticated);

[[noreturn]] void no_status(const std::string& problem) {
    throw StatusError(StatusCode::unknown, reason::unexpected, "The reply's status " + problem + ".");
}

std::string text_of(const nlohmann::json& object, const char* key) {
    const auto at = object.find(key);
    if (at == object.end()) return {};
    if (!at->is_string()) no_status(std::string("has a ") + key + " that is not a string");
    return at->get<std::string>();
}

std::vector<Violation> violations_from(const nlohmann::json& details) {
    std::vector<Violation> violations;
    const auto at = details.find("violations");
    if (at == details.end()) return violations;
    if (!at->is_array()) no_status("has violations that are not a list");
    for (const auto& entry : *at) {
        if (!entry.is_object()) no_status("has a violation that is not an object");
        violations.push_back({text_of(entry, "field"), text_of(entry, "description")});
    }
    return violations;
}

int retry_delay_from(const nlohmann::json& details) {
    const auto at = details.find("retry_delay_ms");
    if (at == details.end()) return 0;
    if (!at->is_number_integer() || *at < 0 || *at > 86'400'000) no_status("has an invalid retry_delay_ms");
    return at->get<int>();
}

std::vector<int> versions_from(const nlohmann::json& details) {
    const auto at = details.find("versions");
    if (at == details.end()) return {};
    if (!at->is_array()) no_status("has versions that are not a list");
    std::vector<int> versions;
    for (const auto& version : *at) {
        if (!version.is_number_integer()) no_status("has a version that is not an integer");
        versions.push_back(version.get<int>());
    }
    return versions;
}

}  // namespace

nlohmann::json to_json(const Status& status) {
    nlohmann::json json =
        object({{"code", static_cast<int>(status.code)}, {"name", name_of(status.code)}, {"message", status.message}});
    nlohmann::json details = nlohmann::json::object();
    if (!status.reason.empty()) details["reason"] = status.reason;
    for (const Violation& violation : status.violations)
        details["violations"].push_back({{"field", violation.field}, {"description", violation.description}});
    if (status.retry_delay_ms > 0) details["retry_delay_ms"] = status.retry_delay_ms;
    if (!status.versions.empty()) details["versions"] = status.versions;
    if (!details.empty()) json["details"] = std::move(details);
    return json;
}

Status status_from_json(const nlohmann::json& json) {
    if (!json.is_object()) no_status("is not an object");
    const auto code = json.find("code");
    if (code == json.end() || !code->is_number_integer() || *code < 0 || *code > last_code)
        no_status("has no code from 0 to 16");
    Status status;
    status.code = static_cast<StatusCode>(code->get<int>());
    status.message = text_of(json, "message");
    if (const auto details = json.find("details"); details != json.end()) {
        if (!details->is_object()) no_status("has details that are not an object");
        status.reason = text_of(*details, "reason");
        status.violations = violations_from(*details);
        status.retry_delay_ms = retry_delay_from(*details);
        status.versions = versions_from(*details);
    }
    return status;
}

}  // namespace contactd::proto
