#include "placement.hpp"

#include <algorithm>
#include <cmath>

namespace contactd {
namespace {

/// Returns the change of gaps in addition to the approach as the wheel is lowered, over the change of the approach. The
/// wheel slides along the plane, where its profile is inclined at the ends of the contact, and the rows of a curved
/// contact have other directions.
double change_beside_approach(const ContactPlace& place) {
    double across = 0, rotated = 0;
    for (const OverlapRegion& region : place.regions)
        for (const double end : {region.y.from, region.y.to})
            across = std::max(across, std::abs(end - place.reference.y) / std::cos(place.reference.angle));
    for (const ContactRow& row : place.rows)
        rotated = std::max(rotated, 1 - std::cos(row.angle - place.reference.angle));
    return std::abs(std::sin(place.reference.angle)) * across / std::abs(place.radii.wheel_across) + rotated;
}

double upright(const ContactPlace& place) {
    return std::abs(std::cos(place.reference.angle));
}

}  // namespace

InfluenceSource Placement::Patch::kept(const InfluenceSource& source) const {
    return [this, &source](const ContactProblem& asked, const PatchStrips& strips, Observer& observer) {
        if (!influence_) influence_ = source(asked, strips, observer);
        return *influence_;
    };
}

void Placement::add(geometry::CandidatePatch found, ContactProblem problem) {
    // The interaction of regions depends on their distance, and thus on the height.
    if (found.place.regions.size() > 1) reach_ = 0;
    constexpr double least_change = 1e-3;
    const double approach = std::max(found.place.approach, 0.0);
    reach_ = std::min(reach_, tolerance_ * approach / std::max(change_beside_approach(found.place), least_change));
    patches.emplace_back(std::move(found), std::move(problem));
}

double Placement::approach_at(double z, const Patch& patch) const {
    return patch.found.place.approach + (z - z_) * upright(patch.found.place);
}

double Placement::height_of(double approach, const Patch& patch) const {
    return z_ + (approach - patch.found.place.approach) / upright(patch.found.place);
}

}  // namespace contactd
