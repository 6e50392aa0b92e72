// Patches of a wheel at one height, ready to be solved there and close by.
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "contactd/contact.hpp"
#include "geometry/position.hpp"

namespace contactd {

/// Near the height where places and gaps were found they stay as they are, and approaches follow the height.
class Placement {
   public:
    struct Patch {
        geometry::CandidatePatch found;
        ContactProblem problem;
    };

    /// What is neglected near `z` (mm) changes gaps by at most this share of the approach.
    Placement(double z, double tolerance) : z_(z), tolerance_(tolerance) {}

    void add(geometry::CandidatePatch found, ContactProblem problem);

    /// Whether patches are at this height as they were found.
    bool holds_at(double z) const { return std::abs(z - z_) <= reach_; }
    double approach_at(double z, const Patch& patch) const;
    /// Returns the height at which the patch has this approach.
    double height_of(double approach, const Patch& patch) const;

    std::vector<Patch> patches{};
    std::vector<std::string> warnings{};

   private:
    double z_, tolerance_;
    double reach_ = 1e-3;  // mm
};

}  // namespace contactd
