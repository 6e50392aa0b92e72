// Written by ./dev generate from proto/schema: edit it there.

#include "contactd/fields/grid.hpp"

#include <array>

namespace contactd {
namespace {

// A member that the schema does not declare makes the number of these names wrong.
[[maybe_unused]] void all_of(const Grid& all) {
    [[maybe_unused]] const auto& [nx_, ny_, dx_, dy_, x0_, y0_] = all;
}

}  // namespace

template <>
const FieldType& type_of<Grid>() {
    static const auto list = std::to_array<Field>({
        fields::field<&Grid::nx>("nx", {.bounds = {.least = 1}, .required = true}),
        fields::field<&Grid::ny>("ny", {.bounds = {.least = 1}, .required = true}),
        fields::field<&Grid::dx>(
            "dx", {.bounds = {.least = 0, .most = 1e+12, .least_excluded = true}, .unit = "mm", .required = true}),
        fields::field<&Grid::dy>(
            "dy", {.bounds = {.least = 0, .most = 1e+12, .least_excluded = true}, .unit = "mm", .required = true}),
        fields::field<&Grid::x0>("x0", {.bounds = {.least = -1e+12, .most = 1e+12}, .unit = "mm"}),
        fields::field<&Grid::y0>("y0", {.bounds = {.least = -1e+12, .most = 1e+12}, .unit = "mm"}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

}  // namespace contactd
