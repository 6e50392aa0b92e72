// Parameters of contacts and wheels, and fields that are variables by their paths.
#pragma once

#include <filesystem>
#include <string_view>

#include "handles.hpp"

namespace contactd::fmu {

/// Sets all parameters except those of a step. Throws Failure.
void set_up(contactd_contact* contact, const Values& values);
/// Sets all parameters. Throws Failure, also for a file that cannot be read, naming the variable.
void set_up(contactd_wheel* wheel, const Values& values, const std::filesystem::path& resources);

/// Sets the inputs and parameters that are fields of a contact and whose paths begin with `group`.
void set_fields(contactd_contact* contact, const Values& values, std::string_view group);

/// Sets the variables of this role that are fields, by their paths.
void set_fields(contactd_wheel* wheel, const Values& values, Role role);
/// Reads the outputs.
void read_fields(contactd_wheel* wheel, Values& values);

}  // namespace contactd::fmu
