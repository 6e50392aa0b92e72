// Computes the closed form of half-spaces at the points of a lattice.
#pragma once

#include <functional>

#include "contactd/observer.hpp"
#include "half_space_model.hpp"

namespace contactd {

/// Holds points ((k + shift_k) dx, (l + shift_l) dy), first_k <= k <= last_k, first_l <= l <= last_l.
struct Lattice {
    double dx, dy;
    int first_k, last_k, first_l, last_l;
    double shift_k, shift_l;
};

/// Visits integrals over a load of size dx x dy at the origin. Without coupling, the integrals that only coupling needs
/// are omitted. Throws Cancelled if the observer, which is called for each row, cancels.
void for_lattice(const HalfSpaceModel& model, const Lattice& points, const Observer& observer,
                 const std::function<void(int k, int l, const KernelIntegrals&)>& visit);

}  // namespace contactd
