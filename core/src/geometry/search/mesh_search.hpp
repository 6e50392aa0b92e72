// Searches the overlap of wheel and rail on a mesh, for rails that curve along the track like wheels.
#pragma once

#include "geometry/search/gap_mesh.hpp"
#include "geometry/search/overlap_search.hpp"

namespace contactd::geometry {

class MeshSearch : public OverlapSearch {
   public:
    /// The wheel stands at z = 0. All arguments must outlive this object. Steps are in mm.
    MeshSearch(const WheelSurface& wheel, const RailSurface& rail, double step_x, double step_y,
               const Observer& observer)
        : rail_(rail), mesh_(wheel, rail, step_x, step_y, observer) {}
    /// Uses the nodes of search_nodes.hpp for the wheel.
    MeshSearch(const WheelSurface& wheel, const RailSurface& rail, NodeMesh nodes, double step_y,
               const Observer& observer)
        : rail_(rail), mesh_(wheel, rail, std::move(nodes), step_y, observer) {}

    double least_gap() const override { return mesh_.least_gap(); }
    std::vector<OverlapRegion> regions(double z) override;
    EquivalentEllipse ellipse(double z, const RegionGroup& group) const override;
    QualityFlags quality_flags(double z, const RegionGroup& group) const override;
    std::optional<PassedOver> passed_over(double) override { return std::nullopt; }

   private:
    OverlapRegion region_of(const std::vector<GapMesh::Node>& nodes, double z) const;
    /// Calls `visit` with each node of the group that overlaps, and its depth.
    template <class Visit>
    void for_each(double z, const RegionGroup& group, const Visit& visit) const;

    const RailSurface& rail_;
    GapMesh mesh_;
};

}  // namespace contactd::geometry
