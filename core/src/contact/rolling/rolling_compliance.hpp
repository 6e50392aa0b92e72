// Implements the compliance of steady rolling: K = C, the change of displacements over a step.
#pragma once

#include <memory>
#include <vector>

#include "contact/newton/compliance.hpp"
#include "influence_division.hpp"
#include "rolling.hpp"
#include "rolling_sweep.hpp"
#include "tangent_stiffness_levels.hpp"

namespace contactd {

enum class PreconditionerLevels { on_many_elements, never };

// C is not symmetric. If the contact has a leading edge but no trailing one, C = A T with T p = p(x) - p(x + step), and
// C^-1 = T^-1 A^-1; if it has only a trailing edge, the inverse is A^-1 T^-1. Adhesion has both, and their mean is
// twice as good as either alone, especially for the first step, whose residual is smooth up to the edges. In slip both
// are equally good, so that they alternate if slip prevails. If nearly all of many elements slip, these have their own
// levels, and both halves, computed on the whole contact, are used for adhesion only.
class RollingCompliance final : public Compliance {
   public:
    RollingCompliance(const RollingBodies& bodies, const Contact& contact,
                      PreconditionerLevels levels = PreconditionerLevels::on_many_elements);

    void apply(const Field& p, Field& u) override;
    const std::vector<double>& self() const override { return self_; }
    void linearise(const Linearisation& law) override;
    void precondition(const Field& r, Field& z, Residual kind, int iteration) override;
    bool is_far_reaching() const override { return false; }
    std::string_view stage() const override { return "rolling"; }

   private:
    void linearise_levels();
    double slip_part() const;
    void precondition_by_halves(const Field& r, Field& z, Residual kind, int iteration);
    // Applies both halves to elements that adhere; elsewhere z is undefined.
    void precondition_adhesion(const Field& r, Field& z);

    const StepOperator& increment_;
    const Contact& contact_;
    const std::size_t m_;
    const std::vector<double> influence_self_;  // A's diagonal of each element in contact
    RollingSweep sweep_;
    InfluenceDivision division_;
    std::size_t sweep_count_ = 0;  // number of elements of the sweep up to the last one selected in the division
    const PreconditionerLevels with_levels_;
    std::unique_ptr<TangentStiffnessLevels> levels_;  // null until needed
    bool uses_levels_ = false;
    const Linearisation* law_ = nullptr;
    std::size_t slipping_ = 0;  // number of elements that slip
    Field swept_, full_in_, full_out_;
    std::vector<double> self_;
};

}  // namespace contactd
