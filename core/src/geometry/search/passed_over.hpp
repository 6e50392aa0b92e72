// Edges and steps of a rail that the search along the locus passes over: a second look, on a coarse mesh.
#pragma once

#include <optional>

#include "geometry/search/gap_mesh.hpp"
#include "geometry/search/locus.hpp"
#include "geometry/search/overlap_search.hpp"

namespace contactd::geometry {

/// The locus takes the rail to be straight around the place where its distance to the wheel is least. Elsewhere on the
/// rail the wheel may stand deeper: within an eighth of its radius this is seen.
class CoarseMesh {
   public:
    /// The wheel stands at z = 0. All must live longer. Throws as GapMesh does.
    CoarseMesh(const WheelSurface& wheel, const RailSurface& rail, const Observer& observer);

    /// `locus` has been looked at below z.
    std::optional<PassedOver> passed_over(const Locus& locus, double z);

   private:
    GapMesh mesh_;
};

}  // namespace contactd::geometry
