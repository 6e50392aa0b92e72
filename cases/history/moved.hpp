// Moves values to a grid that is displaced by whole elements and may have more or fewer elements.
#pragma once

#include <vector>

#include "contactd/contact_load.hpp"
#include "contactd/friction.hpp"
#include "contactd/grid.hpp"

namespace contactd::cases {

/// Returns the elements of a step that continues: they keep their size, and the requested displacement is rounded to
/// whole elements.
Grid continued(const Grid& requested, const Grid& before);

/// Returns values on other elements of the same size. New elements have the values `elsewhere`, a single number or one
/// for each element. Empty values remain empty.
std::vector<double> on_grid(const std::vector<double>& values, const Grid& from, const Grid& to,
                            const std::vector<double>& elsewhere = {0});

/// Returns the state at the end of a step on other elements. New particles have the initial state of this friction.
SurfaceState on_grid(const SurfaceState& state, const Grid& from, const Grid& to, const FrictionLaw& friction);

}  // namespace contactd::cases
