// Provides common parts of the functions of FMI 3.
#pragma once

#include <fmi3Functions.h>

#include "api_boundary.hpp"

namespace contactd::fmu {

inline constexpr fmi3Status fmi3_statuses[] = {fmi3OK, fmi3Warning, fmi3Discard, fmi3Error};

template <class Body>
fmi3Status with(fmi3Instance instance, const Body& body) noexcept {
    return fmi3_statuses[static_cast<int>(guarded(instance, body))];
}

}  // namespace contactd::fmu
