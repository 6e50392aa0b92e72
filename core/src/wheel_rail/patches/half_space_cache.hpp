// Caches the operators of half-spaces for a wheel on its rail, whose grids change by a few elements per step.
#pragma once

#include <cstdint>
#include <list>
#include <mutex>
#include <tuple>

#include "contactd/contact_influence.hpp"
#include "contactd/ic_table.hpp"
#include "contactd/observer.hpp"
#include "contactd/patch_influence.hpp"
#include "contactd/patch_strips.hpp"

namespace contactd {

/// Keeps the operators that were used last, and one table that contains all of them. Only the sizes of a grid matter,
/// not its position. Thread-safe.
class HalfSpaceCache {
   public:
    /// Throws InvalidArgument ("bodies") unless all bodies are half-spaces in closed form, or rigid.
    explicit HalfSpaceCache(Bodies bodies);

    /// Returns the operators of a problem. Rotated strips share the data that does not depend on their angles, because
    /// these differ at the next position. Throws InvalidArgument ("conformal") for strips of sections, and Cancelled.
    ContactInfluence of(const ContactProblem& problem, const PatchStrips& strips = {}, const Observer& observer = {});

   private:
    using Key = std::tuple<int, int, double, double, double, double>;  // numbers and sizes of elements, and the step
    struct Entry {
        Key key;
        ContactInfluence influence;
    };
    /// Returns operators of flat rows. It must be called with the mutex locked.
    const ContactInfluence& flat_influence(const ContactProblem& problem, const Observer& observer);
    IcTable table_for(const Grid& grid, const Observer& observer);

    const Bodies bodies_;
    RotatedPatches rotated_;
    std::mutex mutex_;        // guards the following members
    std::list<Entry> cache_;  // most recently used first
    IcTable table_{1, 1};
    double dx_ = 0, dy_ = 0;  // of the table
};

}  // namespace contactd
