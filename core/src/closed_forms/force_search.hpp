// Searches the motion (shift or creepages) for prescribed forces, if a force takes microseconds.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "contactd/contact.hpp"

namespace contactd {

using Pair = std::array<double, 2>;  // x, y

struct PrescribedForce {
    std::optional<double> Fx, Fy;
    double bound;  // mu Fn
};

/// Throws InvalidArgument(`field`) if friction cannot carry the force.
void check_reach(const PrescribedForce& prescribed, const char* field);

/// Changes those components of `motion` whose force is prescribed, by the Levenberg-Marquardt method from the given
/// estimate, until the error of the force is at most 1e-9 of the bound. `scale` is the motion in each direction that
/// makes most of the area slip. Returns nothing if no force is prescribed.
std::optional<SolverEvidence> find_motion(const std::function<Pair(const Pair&)>& force,
                                          const PrescribedForce& prescribed, const Pair& scale, Pair& motion);

}  // namespace contactd
