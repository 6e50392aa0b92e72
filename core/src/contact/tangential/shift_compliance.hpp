// Implements the compliance of a shift or a transient step: K = A.
#pragma once

#include <vector>

#include "contact/newton/compliance.hpp"
#include "contact/newton/flow_preconditioner.hpp"
#include "contactd/influence_operator.hpp"

namespace contactd {

// The preconditioner is that of TangCg: the operator's own, scaled on both sides, where A dominates, the diagonal where
// D dominates, and their mean in between.
class ShiftCompliance final : public Compliance {
   public:
    ShiftCompliance(const InfluenceOperator& influence, const Contact& contact);

    void apply(const Field& p, Field& u) override;
    const std::vector<double>& self() const override { return self_; }
    void linearise(const Linearisation& law) override;
    void precondition(const Field& r, Field& z, Residual kind, int iteration) override;
    bool is_far_reaching() const override { return true; }
    std::string_view stage() const override { return "tangential"; }

   private:
    const InfluenceOperator& influence_;
    const Contact& contact_;
    const std::vector<double> self_;  // A's diagonal of each element in contact
    const Linearisation* law_ = nullptr;
    std::vector<double> scale_, diagonal_;  // values of the operator's preconditioner and of the diagonal
    FlowPreconditioner along_flow_;
    Field rows_, full_in_, full_out_;
};

}  // namespace contactd
