// Adds prescribed forces to the friction law: they border its linear equations by a row and a column each.
#pragma once

#include <array>
#include <vector>

#include "compliance.hpp"
#include "contact/support/pair.hpp"

namespace contactd {

// Holds the prescribed sums of the tractions over the elements in contact (N/mm^2). Along a component without a force,
// the rigid slip is prescribed.
struct ForcesGiven {
    std::array<bool, 2> given{};
    Pair sum = Pair::Zero();
    double tolerance = 1e-6;  // tolerance of the missing forces, over the sum of the bounds
};

// Adds the uniform rigid slip omega as an unknown. A step then solves
//
//     J dp + P E domega = r,   S dp = F - S p
//
// where S sums, and E = (e_x, e_y) is a unit of rigid slip everywhere. Pairs are zero along components without a force.
class ForceBorder {
   public:
    ForceBorder(const ForcesGiven& forces, std::size_t m);
    // Sets other forces along the same components.
    void ask_for(const ForcesGiven& forces) { forces_ = forces; }
    double tolerance() const { return forces_.tolerance; }

    Pair missing(const Field& p) const;
    Pair sum(const Vectors& step) const;
    // Sums the part of a step that is free to change the tractions.
    Pair sum_of_free(const Linearisation& law, const Vectors& step) const;

    // Computes Z = M P E with the preconditioner M. Z is only recomputed after the division has changed significantly.
    void prepare(Compliance& compliance, const Linearisation& law, int iteration);
    void division_changed(const std::vector<char>& before, const std::vector<char>& after);
    // Changes z to z - Z domega, so that z sums to `missing`; returns domega.
    Pair correct(Field& z, const Pair& missing) const;

   private:
    Pair given(double x, double y) const { return {forces_.given[0] ? x : 0, forces_.given[1] ? y : 0}; }

    ForcesGiven forces_;
    const std::size_t m_;
    std::array<Field, 2> response_;  // Z
    Eigen::Matrix2d sums_ = Eigen::Matrix2d::Identity();
    std::size_t changed_ = 0;  // elements that have changed since Z was computed
    bool is_made_ = false;
};

}  // namespace contactd
