// What preconditioners of the kind W M W + (1 - W^2)/diagonal take along the direction of flow.
#pragma once

#include <vector>

#include "linearisation.hpp"

namespace contactd {

// Rows along flow are unit (1 + slope A): by A's own preconditioner M where the slope is so steep that A rules, by the
// diagonal elsewhere. Across, the scalars are those that slip has.
class FlowPreconditioner {
   public:
    // `self`: A's diagonal of each element in contact; `soft` times that is where A rules, `close` times that stands in
    // for A with close neighbours.
    FlowPreconditioner(const std::vector<double>& self, double soft, double close);

    void linearise(const Linearisation::Flow& flow);
    // to = W r, with `across` in place of W where nothing flows.
    void scale_rows(const std::vector<double>& across, const Field& r, Field& to) const;
    // z = W z + (1 - W^2) r/diagonal, with `across` and `rest` where nothing flows; z is M W r before.
    void complete(const std::vector<double>& across, const std::vector<double>& rest, const Field& r, Field& z) const;

   private:
    const std::vector<double>& self_;
    double soft_, close_;
    const Linearisation::Flow* flow_ = nullptr;
    std::vector<double> rows_, columns_, rest_;
};

}  // namespace contactd
