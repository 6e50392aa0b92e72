// Written by ./dev generate from proto/schema: edit it there.

#include "contactd/fields/solve_reply.hpp"

#include <array>

namespace contactd {
namespace {

// A member that the schema does not declare makes the number of these names wrong.
[[maybe_unused]] void all_of(const OperatorUse& all) {
    [[maybe_unused]] const auto& [made_, bytes_, budget_bytes_] = all;
}

}  // namespace

template <>
const FieldType& type_of<OperatorUse>() {
    static const auto list = std::to_array<Field>({
        fields::field<&OperatorUse::made>("made", {.required = true}),
        fields::field<&OperatorUse::bytes>("bytes", {.bounds = {.least = 0}, .required = true}),
        fields::field<&OperatorUse::budget_bytes>("budget_bytes", {.bounds = {.least = 0}, .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

}  // namespace contactd
