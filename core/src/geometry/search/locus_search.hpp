// Searches the overlap of wheel and rail by the locus: along the track, the gap grows with the round wheel.
#pragma once

#include "geometry/search/edges_along.hpp"
#include "geometry/search/locus.hpp"
#include "geometry/search/overlap_search.hpp"
#include "geometry/search/passed_over.hpp"

namespace contactd::geometry {

class LocusSearch : public OverlapSearch {
   public:
    /// Selects the end of the overlap between two rows: where the gap is zero, or would be if it and the rail were
    /// straight from row to row, as in reference programs.
    enum class Ends { exact, straight };

    /// The wheel stands at z = 0. All arguments must outlive this object.
    LocusSearch(const WheelSurface& wheel, const RailSurface& rail, double step, Ends ends, const Observer& observer)
        : wheel_(wheel), rail_(rail), observer_(observer), locus_(wheel, rail, step, observer), ends_(ends) {}

    double least_gap() const override { return locus_.least_gap(); }
    std::vector<OverlapRegion> regions(double z) override;
    EquivalentEllipse ellipse(double z, const RegionGroup& group) const override;
    QualityFlags quality_flags(double z, const RegionGroup& group) const override;
    std::optional<PassedOver> passed_over(double z) override;

   private:
    OverlapRegion region_of(std::size_t begin, std::size_t end, double z) const;
    LocusRow edge(std::size_t inside, long step, double z) const;

    const WheelSurface& wheel_;
    const RailSurface& rail_;
    const Observer& observer_;
    Locus locus_;
    Ends ends_;
    std::optional<EdgesAlong> edges_;  // edges of slices, created when needed
    std::optional<CoarseMesh> mesh_;   // created if there may be edges
};

}  // namespace contactd::geometry
