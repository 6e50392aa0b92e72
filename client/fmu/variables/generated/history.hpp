// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include <array>
#include <string_view>

namespace contactd::fmu {

/// An array that a step passes on to the next, unless one of the variables is 0. Unused places are empty.
struct HistoryArray {
    const char* name;
    std::array<std::string_view, 2> needs;
};

inline constexpr std::array<HistoryArray, 5> history_arrays{
    HistoryArray{"pressure", {}},
    HistoryArray{"traction_x", {}},
    HistoryArray{"traction_y", {}},
    HistoryArray{"yield_stress", {"friction.layer.yield_stress", "friction.layer.hardening"}},
    HistoryArray{"friction_coefficient", {"friction.kinetic.law", "friction.kinetic.memory.distance"}},
};

}  // namespace contactd::fmu
