// Written by ./dev generate from proto/schema: edit it there.

#include "contactd/fields/ic_reply.hpp"

#include <array>

namespace contactd {
namespace {

// A member that the schema does not declare makes the number of these names wrong.
[[maybe_unused]] void all_of(const IcUses& all) {
    [[maybe_unused]] const auto& [upper_, lower_, pair_] = all;
}
[[maybe_unused]] void all_of(const IcUse& all) {
    [[maybe_unused]] const auto& [origin_, key_, evidence_] = all;
}

}  // namespace

template <>
const FieldType& type_of<IcUses>() {
    static const auto list = std::to_array<Field>({
        fields::field<&IcUses::upper>("upper"),
        fields::field<&IcUses::lower>("lower"),
        fields::field<&IcUses::pair>("pair"),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<IcUse>() {
    static const auto list = std::to_array<Field>({
        fields::field<&IcUse::origin>("origin", {.required = true}),
        fields::field<&IcUse::key>("key", {.required = true}),
        fields::field<&IcUse::evidence>("evidence", {.required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

}  // namespace contactd
