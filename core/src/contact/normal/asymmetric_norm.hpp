// NORM's loop over the contact area for operators that are not symmetric: those of bodies that creep as they roll.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "norm.hpp"

namespace contactd {

// There is no function whose minimum the contact is, but one solution, since A is positive definite. Conjugate
// residuals on the contact set, each orthogonal to those before (Eisenstat, Elman and Schultz 1983), take the place of
// conjugate gradients. Nothing is watched: sets that change too often are changed less eagerly, first where the
// equations within them are solved only, and then one element at a time, the last one first, which ends for such
// matrices (Murty 1974).
class AsymmetricNorm final : public Norm {
   public:
    using Norm::Norm;

    /// What directions take in memory, for each element, at most.
    static constexpr std::size_t most_directions = 30;
    static constexpr std::size_t bytes_per_element = most_directions * 2 * sizeof(double);

   private:
    struct Direction {
        Values v, q;      // q = A v, less its mean over the set where the sum is prescribed
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
    int changes_ = 0;  // of the set, while it is changed eagerly
    int in_vain_ = 0;  // changes that have not lowered the number of violations
    std::size_t fewest_ = static_cast<std::size_t>(-1);
    bool one_by_one_ = false;
};

// The one that the operator asks for.
std::unique_ptr<Norm> make_norm(const InfluenceOperator& influence, const NormProblem& problem,
                                const SolverSettings& settings, Observer& observer);

}  // namespace contactd
