#include "contactd/history.hpp"

#include <utility>

#include "contactd/fields/grid_arrays.hpp"

namespace contactd {

SurfaceState end_of(const ContactSolution& solution) {
    SurfaceState state;
    for (const HistoryArray& array : history_arrays) state.*array.before = solution.*array.after;
    return state;
}

SurfaceState end_of(ContactSolution&& solution) {
    SurfaceState state;
    for (const HistoryArray& array : history_arrays) state.*array.before = std::move(solution.*array.after);
    return state;
}

}  // namespace contactd
