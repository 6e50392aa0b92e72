// Converts a contact whose regions interact partially to a plain contact.
#pragma once

#include "contactd/contact.hpp"
#include "contactd/contact_influence.hpp"
#include "operators/region_operator.hpp"

namespace contactd {

/// Returns the region of each element, by its centre.
RegionShares region_shares(const ContactRegions& regions, const Grid& grid);

/// Holds a problem without regions: the undeformed distance prevents contact of elements in no region, and the bodies
/// weigh the displacements. It requires regions, and the influence of bodies for the problem's grid.
struct ProblemOfRegions {
    ProblemOfRegions(const ContactProblem& with_regions, const ContactInfluence& of_bodies);

    ContactProblem problem;
    ContactInfluence influence;
};

}  // namespace contactd
