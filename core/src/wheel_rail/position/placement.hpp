// Prepares patches of a wheel at one height for solves at this height and nearby.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "contactd/contact.hpp"
#include "contactd/solve_wheel_rail.hpp"
#include "geometry/position.hpp"

namespace contactd {

/// Near the height at which places and gaps were computed, these do not change, and approaches follow the height.
class Placement {
   public:
    class Patch {
       public:
        Patch(geometry::CandidatePatch found_, ContactProblem problem_)
            : found(std::move(found_)), problem(std::move(problem_)) {}

        /// Returns a source that calls `source` once. It must not outlive the patch.
        InfluenceSource kept(const InfluenceSource& source) const;

        geometry::CandidatePatch found;
        ContactProblem problem;

       private:
        mutable std::optional<ContactInfluence> influence_{};
    };

    /// The tolerance is the change of gaps near `z` (mm), relative to the approach, up to which they are reused. If an
    /// accuracy of largest values is requested, the position of the elements may not change much, either.
    Placement(double z, double tolerance, std::optional<double> accuracy) : z_(z), tolerance_(tolerance) {
        constexpr double per_accuracy = 0.1;  // mm
        if (accuracy) reach_ = std::min(reach_, per_accuracy * *accuracy);
    }

    void add(geometry::CandidatePatch found, ContactProblem problem);

    /// Returns whether the patches can be used at this height.
    bool holds_at(double z) const { return std::abs(z - z_) <= reach_; }
    /// Returns whether there is a single patch of a single region, whose approach determines the height.
    bool is_single() const { return patches.size() == 1 && patches.front().found.place.regions.size() == 1; }
    /// Returns the error of gaps at this height, relative to the approach, in units of the tolerance.
    double change_at(double z) const { return z == z_ ? 0 : std::abs(z - z_) / reach_; }
    double approach_at(double z, const Patch& patch) const;
    /// Returns the height at which the patch has this approach.
    double height_of(double approach, const Patch& patch) const;

    std::vector<Patch> patches{};
    std::vector<std::string> warnings{};

   private:
    double z_, tolerance_;
    double reach_ = 2e-5;  // mm
};

}  // namespace contactd
