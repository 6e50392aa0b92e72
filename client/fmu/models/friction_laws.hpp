// The laws of friction beside the coefficient, of both models alike.
#pragma once

#include <string>

#include "handles.hpp"

namespace contactd::fmu {

/// Sets what of a second term, of memory and of a layer the variables ask for. `value` gives that of a variable below
/// "friction.", whose name is its path below `prefix`, too.
template <class Value>
void set_friction_laws(void* handle, const std::string& prefix, bool falls, const Value& value) {
    const auto set = [&](const char* name) { set_field(handle, prefix + name, value(name)); };
    const auto is_there = [&](const char* name) { return value(name) != 0; };
    if (falls && is_there("kinetic.second.fall")) {
        set("kinetic.second.fall");
        set("kinetic.second.slip_velocity");
    }
    if (falls && is_there("kinetic.memory.distance")) {
        set("kinetic.memory.distance");
        set("kinetic.memory.least_velocity");
    }
    if (is_there("layer.flexibility")) set("layer.flexibility");
    if (!is_there("layer.yield_stress")) return;
    set("layer.yield_stress");
    set("layer.hardening");
    set("layer.residual");
}

}  // namespace contactd::fmu
