// Describes the arrays over the grid that a step passes on to the next; contactd/fields/grid_arrays.hpp lists them.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "contactd/contact.hpp"
#include "contactd/fields.hpp"

namespace contactd {

/// Describes an array of the history: a pressure or traction, or other state of particles that some friction laws keep.
struct HistoryArray {
    std::string_view name;  ///< in messages
    std::vector<double> SurfaceState::* before;
    std::vector<double> ContactSolution::* after;
    Bounds bounds{};  ///< unlimited, positive, or zero and positive
    /// Returns whether a friction law keeps this state; null for pressure and tractions, which are always kept.
    bool (*is_kept)(const FrictionLaw& law) = nullptr;
    /// Returns the value of a particle that enters the contact at an element, or nothing if the law has no such value;
    /// null for pressure and tractions, which are zero outside the contact.
    std::optional<double> (*entering)(const FrictionLaw& law, std::size_t element) = nullptr;

    bool is_traction() const { return is_kept == nullptr; }
};

/// Returns the state at the end of a step, where the next step starts.
SurfaceState end_of(const ContactSolution& solution);
SurfaceState end_of(ContactSolution&& solution);

}  // namespace contactd
