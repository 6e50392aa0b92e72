// Provides the part along the direction of flow for preconditioners of the form W M W + (1 - W^2)/diagonal.
#pragma once

#include <vector>

#include "linearisation.hpp"

namespace contactd {

// Rows along the flow are unit (1 + slope A). If the slope is so steep that A dominates, A's own preconditioner M
// inverts them, otherwise the diagonal does. Across the flow, the scalars are those of slip.
class FlowPreconditioner {
   public:
    // `self` is A's diagonal of each element in contact. A dominates above `soft` times `self`, and `close` times
    // `self` replaces A with close neighbours.
    FlowPreconditioner(const std::vector<double>& self, double soft, double close);

    void linearise(const Linearisation::Flow& flow);
    // Computes to = W r, with `across` in place of W for elements that do not flow.
    void scale_rows(const std::vector<double>& across, const Field& r, Field& to) const;
    // Computes z = W z + (1 - W^2) r/diagonal, with `across` and `rest` for elements that do not flow; z is M W r
    // before.
    void complete(const std::vector<double>& across, const std::vector<double>& rest, const Field& r, Field& z) const;

   private:
    const std::vector<double>& self_;
    double soft_, close_;
    const Linearisation::Flow* flow_ = nullptr;
    std::vector<double> rows_, columns_, rest_;
};

}  // namespace contactd
