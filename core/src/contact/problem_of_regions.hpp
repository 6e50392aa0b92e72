// A contact whose regions feel each other's pressures in part, as a plain one.
#pragma once

#include "contactd/contact.hpp"
#include "contactd/solve_contact.hpp"
#include "operators/region_operator.hpp"

namespace contactd {

/// The region of each element, by its centre.
RegionShares region_shares(const ContactRegions& regions, const Grid& grid);

/// A problem without regions: the undeformed distance keeps elements of none from touching, and the bodies weigh the
/// displacements. Needs regions, and the influence of bodies for the problem's grid.
struct ProblemOfRegions {
    ProblemOfRegions(const ContactProblem& with_regions, const ContactInfluence& of_bodies);

    ContactProblem problem;
    ContactInfluence influence;
};

}  // namespace contactd
