// The functions of contactd_local for tables of creep forces.
#pragma once

#include "python_api.hpp"

namespace contactd::python {

/// Ends with an empty entry.
extern PyMethodDef creep_table_methods[];

}  // namespace contactd::python
