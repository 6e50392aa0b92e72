// Forces that are given, beside the friction law: they border its linear equations by a row and a column each.
#pragma once

#include <array>
#include <vector>

#include "compliance.hpp"
#include "contact/support/pair.hpp"

namespace contactd {

// The sums of the tractions over the elements in contact that are asked for (N/mm^2). Along a component without one the
// rigid slip is known.
struct ForcesGiven {
    std::array<bool, 2> given{};
    Pair sum = Pair::Zero();
    double tolerance = 1e-6;  // of what is missing, over the sum of the bounds
};

// With the uniform rigid slip omega as a further unknown, a step solves
//
//     J dp + P E domega = r,   S dp = F - S p
//
// S sums up, E = (e_x, e_y) is one unit of rigid slip everywhere. Pairs are zero along components without a force.
class ForceBorder {
   public:
    ForceBorder(const ForcesGiven& forces, std::size_t m);
    // Along the same components.
    void ask_for(const ForcesGiven& forces) { forces_ = forces; }
    double tolerance() const { return forces_.tolerance; }

    Pair missing(const Field& p) const;
    Pair sum(const Vectors& step) const;
    // Sums the part of a step that is free to change the tractions.
    Pair sum_of_free(const Linearisation& law, const Vectors& step) const;

    // Z = M P E with the preconditioner M; made anew only when the division has changed by much.
    void prepare(Compliance& compliance, const Linearisation& law, int iteration);
    void division_changed(const std::vector<char>& before, const std::vector<char>& after);
    // z -> z - Z domega, so that z sums to `missing`; returns domega.
    Pair correct(Field& z, const Pair& missing) const;

   private:
    Pair given(double x, double y) const { return {forces_.given[0] ? x : 0, forces_.given[1] ? y : 0}; }

    ForcesGiven forces_;
    const std::size_t m_;
    std::array<Field, 2> response_;  // Z
    Eigen::Matrix2d sums_ = Eigen::Matrix2d::Identity();
    std::size_t changed_ = 0;  // elements since Z was made
    bool is_made_ = false;
};

}  // namespace contactd
