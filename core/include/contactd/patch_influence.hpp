// Creates operators of contacts between wheel and rail that are curved across the track.
#pragma once

#include <functional>
#include <memory>

#include "contactd/contact_influence.hpp"
#include "contactd/ic_record.hpp"
#include "contactd/observer.hpp"
#include "contactd/patch_strips.hpp"

namespace contactd {

/// Creates operators on strips that are not flat: from the tables of existing sections, or from half-spaces rotated
/// from row to row. Throws InvalidArgument ("dy") for tables of too many numbers, and Cancelled.
ContactInfluence patch_influence(const ContactProblem& problem, const PatchStrips& strips,
                                 const IcRecord* rail = nullptr, const IcRecord* wheel = nullptr,
                                 const Observer& observer = {});

/// Creates operators of half-spaces rotated by half angles, and keeps the common data of grids of one size, which do
/// not depend on the angles of their rows, for the sizes used last. Thread-safe.
class RotatedPatches {
   public:
    RotatedPatches();
    ~RotatedPatches();
    RotatedPatches(const RotatedPatches&) = delete;
    RotatedPatches& operator=(const RotatedPatches&) = delete;

    /// Creates the operators of a problem; `flat`, if given, creates those of flat rows. Answers do not depend on
    /// earlier calls. Throws InvalidArgument ("dy") for symbols of too many numbers, and Cancelled.
    ContactInfluence of(const ContactProblem& problem, const PatchStrips& strips, const Observer& observer = {},
                        const std::function<ContactInfluence()>& flat = {});

   private:
    struct Kept;
    std::unique_ptr<Kept> kept_;
};

}  // namespace contactd
