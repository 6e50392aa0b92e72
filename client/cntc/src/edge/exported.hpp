// The interface, whose names alone leave the library, and their second names.
#pragma once

#pragma GCC visibility push(default)
#include "contactd_cntc.h"
#pragma GCC visibility pop

/// The name with an underscore, which some Fortran compilers append. Weak: a wrapper may have one of its own.
#define CONTACTD_FORTRAN_NAME(name) \
    extern "C" __attribute__((weak, alias(#name), visibility("default"))) decltype(name) name##_;
