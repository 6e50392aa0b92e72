// Searches again, on a coarse mesh, for edges and steps of a rail that the search along the locus skips.
#pragma once

#include <optional>

#include "geometry/search/gap_mesh.hpp"
#include "geometry/search/locus.hpp"
#include "geometry/search/overlap_search.hpp"

namespace contactd::geometry {

/// The locus assumes that the rail is straight around the point of least distance to the wheel. Elsewhere on the rail
/// the wheel may be deeper; this search finds such places within an eighth of its radius.
class CoarseMesh {
   public:
    /// The wheel stands at z = 0. All arguments must outlive this object. Throws as GapMesh does.
    CoarseMesh(const WheelSurface& wheel, const RailSurface& rail, const Observer& observer);

    /// Returns a skipped place; `locus` must have been evaluated below z.
    std::optional<PassedOver> passed_over(const Locus& locus, double z);

   private:
    GapMesh mesh_;
};

}  // namespace contactd::geometry
