// Starts Newton's method on the friction law with many elements.
#pragma once

#include <optional>

#include "contact/newton/force_border.hpp"
#include "contact/newton/plastic_flow.hpp"
#include "contactd/observer.hpp"
#include "friction_bodies.hpp"

namespace contactd {

struct FrictionStart {
    Field tractions;  ///< on the grid
    Pair uniform;     ///< part of the rigid slip that forces determine (mm)
};

/// Returns approximate tractions and rigid slip from coarser grids. If there are no coarser grids, or that did not
/// converge, returns no tractions and `uniform`. `flow` is the law of a layer that hardens, or null.
FrictionStart start_on_coarser(const FrictionBodies& bodies, const Contact& contact,
                               const std::optional<ForcesGiven>& forces, const Pair& uniform, const FlowLaw* flow,
                               const Observer& observer);

}  // namespace contactd
