// Where Newton's method on the friction law starts on many elements.
#pragma once

#include <optional>

#include "contact/newton/force_border.hpp"
#include "contact/newton/plastic_flow.hpp"
#include "contactd/observer.hpp"
#include "friction_bodies.hpp"

namespace contactd {

struct FrictionStart {
    Field tractions;  ///< on the grid
    Pair uniform;     ///< part of the rigid slip that forces ask for (mm)
};

/// Tractions and rigid slip found on coarser grids, roughly; none and `uniform` where there are no coarser grids, or
/// where that did not converge. `flow` is the law of a layer that hardens, or null.
FrictionStart start_on_coarser(const FrictionBodies& bodies, const Contact& contact,
                               const std::optional<ForcesGiven>& forces, const Pair& uniform, const FlowLaw* flow,
                               const Observer& observer);

}  // namespace contactd
