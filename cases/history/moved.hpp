// Values of elements on others, which lie whole elements elsewhere and may be more or fewer.
#pragma once

#include <vector>

#include "contactd/contact_load.hpp"
#include "contactd/friction.hpp"
#include "contactd/grid.hpp"

namespace contactd::cases {

/// Returns the requested elements as those that a step goes on with: they keep their size, and lie whole elements from
/// those before.
Grid continued(const Grid& requested, const Grid& before);

/// Returns values on other elements of the same size; new elements have `elsewhere`, one number or one an element.
/// Empty values stay empty.
std::vector<double> on_grid(const std::vector<double>& values, const Grid& from, const Grid& to,
                            const std::vector<double>& elsewhere = {0});

/// Returns the end of a step on other elements, where particles that come new have the state of this friction.
SurfaceState on_grid(const SurfaceState& state, const Grid& from, const Grid& to, const FrictionLaw& friction);

}  // namespace contactd::cases
