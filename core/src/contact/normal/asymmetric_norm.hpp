// Implements NORM's loop over the contact area for operators that are not symmetric: those of rolling viscoelastic
// bodies.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "norm.hpp"

namespace contactd {

// The contact is not the minimum of a function, but the solution is unique, since A is positive definite. Conjugate
// residuals on the contact set, each orthogonal to the previous ones (Eisenstat, Elman and Schultz 1983), replace
// conjugate gradients. No function is monitored. Instead, sets that change too often are changed less often: first only
// after the equations within them are solved, and then by one element at a time, the last one first, which terminates
// for such matrices (Murty 1974).
class AsymmetricNorm final : public Norm {
   public:
    using Norm::Norm;

    /// Directions take at most this memory per element.
    static constexpr std::size_t most_directions = 30;
    static constexpr std::size_t bytes_per_element = most_directions * 2 * sizeof(double);

   private:
    struct Direction {
        Values v, q;      // q = A v, minus its mean over the set if the sum is prescribed
        double mean = 0;  // that mean
        double square = 0;
    };

    bool change_set(Check check, bool change_all) override;
    bool watch() override { return true; }
    double choose_step() override;

    bool change_last();
    std::size_t violations() const;
    bool is_violated(std::size_t i) const;

    std::vector<Direction> directions_;  // since the last change of the set
    std::size_t oldest_ = 0;
    int changes_ = 0;  // changes of the set, while they are frequent
    int in_vain_ = 0;  // changes that have not reduced the number of violations
    std::size_t fewest_ = static_cast<std::size_t>(-1);
    bool one_by_one_ = false;
};

// Creates the variant that the operator requires.
std::unique_ptr<Norm> make_norm(const InfluenceOperator& influence, const NormProblem& problem,
                                const SolverSettings& settings, Observer& observer);

}  // namespace contactd
