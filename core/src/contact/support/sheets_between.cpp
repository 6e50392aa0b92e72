#include "sheets_between.hpp"

#include <memory>
#include <utility>

#include "operators/sheets/sheet_step.hpp"
#include "operators/sheets/thin_sheet.hpp"

namespace contactd {

ContactInfluence with_sheets(const ContactProblem& problem, ContactInfluence bodies) {
    const bool sheared = problem.friction && problem.friction->layer;
    const SheetFlexibility sheets{problem.sheet_flexibility, sheared ? problem.friction->layer->flexibility : 0};
    if (sheets.normal > 0 || sheets.tangential > 0)
        bodies.current = std::make_shared<const ThinSheet>(std::move(bodies.current), sheets);
    if (!(sheets.tangential > 0) || !bodies.increment) return bodies;
    const auto [x, y] = step_of(problem);
    bodies.increment =
        std::make_shared<const SheetStep>(std::move(bodies.increment), problem.grid, x, y, sheets.tangential);
    return bodies;
}

}  // namespace contactd
