// Handles arrays of forces at the nodes of a creep-force table.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "contactd/error.hpp"
#include "creep_table/spline_axis.hpp"

namespace contactd::creep_table {

/// Holds the values of one component, in the order of the axes.
using Values = std::vector<double>;

inline std::size_t nodes_of(const SplineAxis& axis) {
    return static_cast<std::size_t>(axis.cells) + 1;
}

inline void require_node_values(std::size_t given, std::size_t needed) {
    if (given != needed)
        throw InvalidArgument("nodes",
                              "have " + std::to_string(given) + " values; this table needs " + std::to_string(needed));
}

/// Returns the coefficients of (Fx, Fy, Mz/c) as a table stores them: four numbers each, the fourth of which is zero.
inline std::vector<float> interleaved(const std::array<Values, 3>& components) {
    std::vector<float> coefficients(4 * components[0].size());
    for (std::size_t k = 0; k < components[0].size(); ++k)
        for (std::size_t c = 0; c < 3; ++c) coefficients[4 * k + c] = static_cast<float>(components[c][k]);
    return coefficients;
}

}  // namespace contactd::creep_table
