// Computes steps of a wheel on its rail: each one may start from the end of the case before.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

#include "contactd/wheel_rail_estimates.hpp"
#include "contactd/wheel_rail_state.hpp"
#include "given/given.hpp"

namespace contactd::cases {

class RailHistory {
   public:
    /// Solves the step that a case describes, and keeps its end for the next case. `solve` receives the estimates from
    /// which the step starts, and leaves those for the next one in them. Throws NotCovered, and as `solve`; the history
    /// is then as before.
    WheelRailSolution solve(const Given& given, Model model, const WheelRailState& state,
                            const std::function<WheelRailSolution(WheelRailEstimates&)>& solve);

    std::size_t elements() const;  ///< number in all patches at the end of the last step

   private:
    /// Estimates contain the tractions of all patches, so they are not copied. Null: there are none.
    using SharedEstimates = std::shared_ptr<const WheelRailEstimates>;
    SharedEstimates start_of(const Given& given, Model model, const WheelRailState& state) const;

    SharedEstimates before_{};  ///< at the start of the last step
    SharedEstimates end_{};     ///< at its end
};

}  // namespace contactd::cases
