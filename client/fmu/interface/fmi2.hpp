// Provides common parts of the functions of FMI 2.
#pragma once

#include <fmi2Functions.h>

#include "api_boundary.hpp"

namespace contactd::fmu {

inline constexpr fmi2Status fmi2_statuses[] = {fmi2OK, fmi2Warning, fmi2Discard, fmi2Error};

template <class Body>
fmi2Status with(fmi2Component instance, const Body& body) noexcept {
    return fmi2_statuses[static_cast<int>(guarded(instance, body))];
}

}  // namespace contactd::fmu
