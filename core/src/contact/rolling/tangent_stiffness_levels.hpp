// Preconditions slip in steady rolling of contacts with many elements.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "contact/support/contact_elements.hpp"
#include "contactd/step_operator.hpp"
#include "rolling_sweep.hpp"

namespace contactd {

// C + D is a convolution except for the tangent stiffness D, which spans two orders of magnitude over the contact.
// Therefore
//
//     J^-1 r ~ sum over j of q_j (C + d_j)^-1 q_j r + q r/(D + d)
//
// with two levels d_j of D, and a remainder where C matters little. q_j^2 and q state how near D is to each; they sum
// to 1. Adhesion, D = 0, belongs to the lowest level, through which distant slip interacts. C is of order zero, so that
// the levels, in units of its diagonal, and the iterations do not depend on the size of the elements.
class TangentStiffnessLevels {
   public:
    // Creates the levels, or returns null if C has no inverses. `unit` is the approximate diagonal of C (mm^3/N).
    static std::unique_ptr<TangentStiffnessLevels> make(const StepOperator& increment, const Contact& contact,
                                                        double unit);

    // Updates the levels. Call it after division or stiffness have changed.
    void linearise(const Linearisation& linearisation);
    // Computes z ~ J^-1 r where elements slip; elsewhere z does not change.
    void solve_slip(const Linearisation& linearisation, const Field& r, Field& z);

   private:
    static constexpr std::size_t count = 2;
    using Inverses = std::array<std::shared_ptr<const StepInverse>, count>;

    TangentStiffnessLevels(Inverses inverses, std::size_t elements, const Contact& contact, double unit);

    const Inverses inverses_;
    const Contact& contact_;
    const double unit_;
    std::array<std::vector<double>, count> weight_;  // q_j of each element
    std::vector<double> local_;                      // q/(D + d)
    Field full_in_, full_out_, sum_;
};

}  // namespace contactd
