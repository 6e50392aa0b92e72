// JSON Schemas (draft-07) of every message, kept in proto/schema and compiled in, and the OpenRPC document made of
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

/// Every method of the wire, which is every file proto/schema/<method>.params.json, in the order of docs/protocol.md.
const std::vector<std::string>& method_names();

/// The schema kept as proto/schema/<name>.json, e.g. "ic.get.params", "envelope". Throws std::out_of_range.
const nlohmann::json& schema(std::string_view name);

/// Violations of `document`, by path, each description saying what the value is and what would be right; empty
/// when it conforms. Thread-safe.
std::vector<Violation> violations_of(std::string_view schema_name, const nlohmann::json& document);
std::vector<Violation> violations_of(std::string_view schema_name, const AnswerValue& document);
/// Violations of a schema that is given, without references.
std::vector<Violation> violations_against(const nlohmann::json& schema, const nlohmann::json& document);

/// Throws StatusError: UNIMPLEMENTED/UNKNOWN_METHOD, or INVALID_ARGUMENT/FIELD_INVALID with all violations.
void check_params(const std::string& method, const nlohmann::json& params);

/// The check of params that are one list of another method's, as contact.solve_many's, member by member, so that
/// threads can share the work. It finds out only whether they conform; check_params says what is wrong. `params` must
/// live on.
class ListCheck {
   public:
    /// Throws std::out_of_range when the params of this method are no list.
    ListCheck(const std::string& method, const nlohmann::json& params);

    /// Apart from the members.
    bool conforms() const { return members_ != nullptr; }
    /// 0 when it does not conform.
    std::size_t size() const { return members_ ? members_->size() : 0; }
    /// Thread-safe.
    bool member_conforms(std::size_t index) const;

   private:
    const std::string method_;
    const nlohmann::json* members_ = nullptr;
};

/// The OpenRPC 1.3 description of the service, which server.describe returns.
const nlohmann::json& openrpc();

}  // namespace contactd::proto
