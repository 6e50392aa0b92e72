// Operators of contacts between wheel and rail that are curved across the track.
#pragma once

#include <functional>
#include <memory>

#include "contactd/contact_influence.hpp"
#include "contactd/ic_record.hpp"
#include "contactd/observer.hpp"
#include "contactd/patch_strips.hpp"

namespace contactd {

/// On strips that are not flat: of the tables of those sections that there are, or of half-spaces in closed form that
/// turn from row to row. Throws InvalidArgument ("dy") for tables of too many numbers, and Cancelled.
ContactInfluence patch_influence(const ContactProblem& problem, const PatchStrips& strips,
                                 const IcRecord* rail = nullptr, const IcRecord* wheel = nullptr,
                                 const Observer& observer = {});

/// Makes operators of half-spaces that turn by halves, and keeps what those of grids of one size have in common: all
/// but the angles of their rows. The sizes that were used last are kept. Thread-safe.
class RotatedPatches {
   public:
    RotatedPatches();
    ~RotatedPatches();
    RotatedPatches(const RotatedPatches&) = delete;
    RotatedPatches& operator=(const RotatedPatches&) = delete;

    /// `flat`, where it is given, makes the operators of rows that lie side by side. Answers do not depend on what was
    /// asked for before. Throws InvalidArgument ("dy") for symbols of too many numbers, and Cancelled.
    ContactInfluence of(const ContactProblem& problem, const PatchStrips& strips, const Observer& observer = {},
                        const std::function<ContactInfluence()>& flat = {});

   private:
    struct Kept;
    std::unique_ptr<Kept> kept_;
};

}  // namespace contactd
