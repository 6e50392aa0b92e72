// Tractions of both closed-form theories: Hertz-like over the ellipse, less Hertz-like over a similar, smaller one.
#pragma once

#include "elliptic_contact.hpp"
#include "force_search.hpp"
#include "rolling_frame.hpp"

namespace contactd {

/// Direction of the force when all slips, |w/full| >= 1: the elastic displacement (or its gradient along the rolling
/// direction) is -full n, and the rest of the motion w slips, against the force. Joins w/full where slip becomes full.
Pair direction_of_slip(const Pair& w, const Pair& full);

/// `direction` is the unit vector of the force (zero without one); the smaller ellipse, k times as large, adheres; its
/// centre lies (1-k) a ahead of the other's in rolling, so that they touch there, and at the same place in a shift.
EllipticFriction ellipse_difference(const Grid& grid, const EllipticContact& contact, double mu, const Pair& direction,
                                    double k, const RollingFrame* rolling);

}  // namespace contactd
