// Patches of a wheel at one height, ready to be solved there and close by.
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

/// Near the height where places and gaps were found they stay as they are, and approaches follow the height.
class Placement {
   public:
    class Patch {
       public:
        Patch(geometry::CandidatePatch found_, ContactProblem problem_)
            : found(std::move(found_)), problem(std::move(problem_)) {}

        /// Returns a source that asks the other one once. It must not outlive the patch.
        InfluenceSource kept(const InfluenceSource& source) const;

        geometry::CandidatePatch found;
        ContactProblem problem;

       private:
        mutable std::optional<ContactInfluence> influence_{};
    };

    /// The tolerance is by how much of the approach gaps may change near `z` (mm) without being taken anew; so that
    /// largest values keep to an accuracy where one is asked for, what the elements lie about may not move far, either.
    Placement(double z, double tolerance, std::optional<double> accuracy) : z_(z), tolerance_(tolerance) {
        constexpr double per_accuracy = 0.1;  // mm
        if (accuracy) reach_ = std::min(reach_, per_accuracy * *accuracy);
    }

    void add(geometry::CandidatePatch found, ContactProblem problem);

    /// Tells if patches are at this height as they were found.
    bool holds_at(double z) const { return std::abs(z - z_) <= reach_; }
    /// Tells if there is one patch of one region only, whose approach tells the height.
    bool is_single() const { return patches.size() == 1 && patches.front().found.place.regions.size() == 1; }
    /// Returns how far gaps may be off at this height, over the approach, in parts of the tolerance.
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
