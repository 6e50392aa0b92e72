// Finds the motion (shift or creepages) that goes with prescribed forces, where a force costs microseconds.
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

/// Throws InvalidArgument(`field`) when friction cannot carry the force.
void check_reach(const PrescribedForce& prescribed, const char* field);

/// Changes those components of `motion` whose force is prescribed, by Levenberg's and Marquardt's method from the
/// estimate it holds, until the force is met to 1e-9 of the bound. `scale` is the motion in each direction that makes
/// most of the area slip. Nothing where no force is prescribed.
std::optional<SolverEvidence> find_motion(const std::function<Pair(const Pair&)>& force,
                                          const PrescribedForce& prescribed, const Pair& scale, Pair& motion);

}  // namespace contactd
