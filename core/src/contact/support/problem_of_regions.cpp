#include "problem_of_regions.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

#include "closed_forms/undeformed_distance.hpp"

namespace contactd {
namespace {

constexpr double out_of_reach = 1e6;  // mm: far beyond any approach, but finite

bool holds(const Extent& extent, double at) {
    return at >= extent.from && at <= extent.to;
}

}  // namespace

RegionShares region_shares(const ContactRegions& regions, const Grid& grid) {
    RegionShares result{{}, regions.shares, static_cast<int>(regions.limits.size())};
    result.region.reserve(grid.size());
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix) {
            const auto found = std::ranges::find_if(regions.limits, [&](const RegionLimits& limits) {
                return holds(limits.x, grid.x(ix)) && holds(limits.y, grid.y(iy));
            });
            result.region.push_back(found == regions.limits.end() ? -1
                                                                  : static_cast<int>(found - regions.limits.begin()));
        }
    return result;
}

ProblemOfRegions::ProblemOfRegions(const ContactProblem& with_regions, const ContactInfluence& of_bodies)
    : problem(with_regions), influence(of_bodies) {
    RegionShares shares = region_shares(*with_regions.regions, with_regions.grid);
    std::vector<double> distance = undeformed_distance(with_regions);
    for (std::size_t at = 0; at < distance.size(); ++at)
        if (shares.region[at] < 0) distance[at] += out_of_reach;
    problem.regions.reset();
    problem.gap = std::move(distance);
    influence.current = std::make_shared<const RegionOperator>(of_bodies.current, std::move(shares));
}

}  // namespace contactd
