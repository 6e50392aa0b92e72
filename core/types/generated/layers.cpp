// Written by ./dev generate from proto/schema: edit it there.

#include "contactd/fields/layers.hpp"

#include <array>

namespace contactd {
namespace {

// A member that the schema does not declare makes the number of these names wrong.
[[maybe_unused]] void all_of(const Layer& all) {
    [[maybe_unused]] const auto& [thickness_, G_, nu_] = all;
}

}  // namespace

template <>
const FieldType& type_of<Layer>() {
    static const auto list = std::to_array<Field>({
        fields::field<&Layer::thickness>(
            "thickness",
            {.bounds = {.least = 0, .most = 1e+12, .least_excluded = true}, .unit = "mm", .required = true}),
        fields::field<&Layer::G>(
            "G", {.bounds = {.least = 0, .most = 1e+18, .least_excluded = true}, .unit = "N/mm^2", .required = true}),
        fields::field<&Layer::nu>("nu", {.bounds = {.least = 0, .most = 0.5}, .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

}  // namespace contactd
