// Where Newton's method on the friction law starts on many elements.
#pragma once

#include <memory>
#include <optional>

#include "contact/newton/force_border.hpp"
#include "contactd/grid.hpp"
#include "contactd/influence_operator.hpp"
#include "contactd/observer.hpp"
#include "contactd/step_operator.hpp"

namespace contactd {

/// What slip owes to tractions: C of steady rolling where there is a `change`, otherwise A.
struct FrictionBodies {
    const InfluenceOperator& influence;
    const StepOperator* change;
    Grid grid;
    double step_x = 0, step_y = 0;  ///< as of RollingBodies, where there is a `change`
};

/// The bodies' operators and the contact outlive it.
std::unique_ptr<Compliance> compliance_of(const FrictionBodies& bodies, const Contact& contact);

struct FrictionStart {
    Field tractions;  ///< on the grid
    Pair uniform;     ///< part of the rigid slip that forces ask for (mm)
};

/// Tractions and rigid slip found on coarser grids, roughly; none and `uniform` where there are no coarser grids, or
/// where that did not converge.
FrictionStart start_on_coarser(const FrictionBodies& bodies, const Contact& contact,
                               const std::optional<ForcesGiven>& forces, const Pair& uniform, const Observer& observer);

}  // namespace contactd
