// Provides JSON Schemas (draft-07) of all messages, compiled from proto/schema, and the OpenRPC document generated from
// them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "contactd/proto/answer_text.hpp"
#include "contactd/proto/status.hpp"

namespace contactd::proto {

/// Returns all methods of the wire, from the files proto/schema/<method>.params.json, in the order of docs/protocol.md.
const std::vector<std::string>& method_names();

/// Returns the schema proto/schema/<name>.json, e.g. "ic.get.params", "envelope". Throws std::out_of_range.
const nlohmann::json& schema(std::string_view name);

/// Returns the violations of `document` by path, each with the value and the valid values; empty if it conforms.
/// Thread-safe.
std::vector<Violation> violations_of(std::string_view schema_name, const nlohmann::json& document);
std::vector<Violation> violations_of(std::string_view schema_name, const AnswerValue& document);
/// Returns the violations of a given schema without references.
std::vector<Violation> violations_against(const nlohmann::json& schema, const nlohmann::json& document);

/// Throws StatusError: UNIMPLEMENTED/UNKNOWN_METHOD, or INVALID_ARGUMENT/FIELD_INVALID with all violations.
void check_params(const std::string& method, const nlohmann::json& params);

/// Checks params that are a list of another method's params, such as those of contact.solve_many, member by member, so
/// that threads can share the work. It only determines whether they conform; check_params reports the errors. `params`
/// must outlive it.
class ListCheck {
   public:
    /// Throws std::out_of_range if the params of this method are not a list.
    ListCheck(const std::string& method, const nlohmann::json& params);

    /// Checks everything except the members.
    bool conforms() const { return members_ != nullptr; }
    /// 0 if it does not conform.
    std::size_t size() const { return members_ ? members_->size() : 0; }
    /// Thread-safe.
    bool member_conforms(std::size_t index) const;

   private:
    const std::string method_;
    const nlohmann::json* members_ = nullptr;
};

/// Returns the OpenRPC 1.3 description of the service, as server.describe does.
const nlohmann::json& openrpc();

}  // namespace contactd::proto
