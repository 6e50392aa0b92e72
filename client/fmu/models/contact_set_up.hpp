// The inputs of a contact before it starts.
#pragma once

#include "handles.hpp"

namespace contactd::fmu {

/// Sets all parameters except those of a step. Throws Failure.
void set_up(contactd_contact* contact, const Values& values);

}  // namespace contactd::fmu
