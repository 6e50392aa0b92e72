// What Newton's method on the friction law has found, as a solution on a grid.
#pragma once

#include <cstddef>

#include "contact/newton/friction_newton.hpp"
#include "operators/restriction.hpp"
#include "rolling.hpp"

namespace contactd {

/// On the `n` elements that the contact is part of.
RollingSolution solution_of(const FrictionNewton& newton, const Contact& contact, std::size_t n);

/// That of a box, on all `n` elements: exterior outside the box.
RollingSolution whole_of(const RollingSolution& part, const Restriction& restriction, std::size_t n);

}  // namespace contactd
