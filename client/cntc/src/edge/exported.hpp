// Declares the exported functions, the only names visible outside the library, and defines their second names.
#pragma once

#pragma GCC visibility push(default)
#include "contactd_cntc.h"
#pragma GCC visibility pop

/// Defines the name with an underscore, which some Fortran compilers append. It is weak, because a wrapper may define
/// the same name.
#define CONTACTD_FORTRAN_NAME(name) \
    extern "C" __attribute__((weak, alias(#name), visibility("default"))) decltype(name) name##_;
