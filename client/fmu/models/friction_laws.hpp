// Sets friction laws other than the coefficient, and thermal properties of bodies, for both models.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "handles.hpp"
#include "variables/variable.hpp"

namespace contactd::fmu {

/// Holds numbers by their variables, whose names are also paths of fields below a prefix.
class NamedValues {
   public:
    NamedValues(void* handle, std::string prefix, std::span<const Variable> variables, const Values& values)
        : handle_(handle), prefix_(std::move(prefix)), variables_(variables), values_(values) {}

    bool is_there(std::string_view name) const { return values_[reference_in(variables_, name)] != 0; }
    void set(std::string_view name) const {
        set_field(handle_, prefix_ + std::string(name), values_[reference_in(variables_, name)]);
    }
    /// Sets all variables with this prefix that are not outputs.
    void set_below(std::string_view group) const {
        for (const Variable& variable : variables_)
            if (variable.role != Role::output && variable.name.starts_with(group)) set(variable.name);
    }

   private:
    void* handle_;
    std::string prefix_;
    std::span<const Variable> variables_;
    const Values& values_;
};

/// Sets the second term, memory, layer and temperature according to the variables.
inline void set_friction_laws(const NamedValues& values, bool falls) {
    if (falls && values.is_there("friction.kinetic.second.fall")) values.set_below("friction.kinetic.second.");
    if (falls && values.is_there("friction.kinetic.memory.distance")) values.set_below("friction.kinetic.memory.");
    if (values.is_there("friction.temperature.change")) values.set_below("friction.temperature.");
    if (values.is_there("friction.layer.yield_stress"))
        values.set_below("friction.layer.");
    else if (values.is_there("friction.layer.flexibility"))
        values.set("friction.layer.flexibility");
}

/// Sets the thermal properties of both bodies if temperatures are requested.
inline void set_temperature(const NamedValues& values) {
    if (!values.is_there("temperature.computed")) return;
    for (const char* body : {"temperature.upper.", "temperature.lower."}) values.set_below(body);
}

}  // namespace contactd::fmu
