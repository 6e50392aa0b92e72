// What setters change of the bodies that they name.
#pragma once

#include <cstdint>

#include "arguments.hpp"
#include "inputs.hpp"

namespace contactd::c {

/// Calls `change` with the bodies that the word names.
template <class Change>
void each_body(Said& said, std::int32_t body, const Change& change) {
    word(body, CONTACTD_BOTH, "body");
    if (body != CONTACTD_LOWER) change(said.problem.bodies.upper);
    if (body != CONTACTD_UPPER) change(said.problem.bodies.lower);
}

inline void set_coefficients(Said& said, std::int32_t body, const Coefficients& ics) {
    each_body(said, body, [&](Body& changed) { changed.ics = ics; });
    said.problem.bodies.pair.reset();
}

/// Makes a section of this shape the bodies' own, by finite elements of an accuracy of 1e-3.
inline void set_section(Said& said, std::int32_t body, const SectionShape& shape) {
    constexpr double default_accuracy = 1e-3;
    Ics ics;
    ics.source = IcSource::fem;
    ics.body = BodyShape::longitudinally_uniform;
    ics.accuracy = default_accuracy;
    ics.section = Section{shape};
    set_coefficients(said, body, ics);
}

/// The coefficients of a body that has a section.
inline Ics& prism_of(Body& body) {
    auto* ics = std::get_if<Ics>(&body.ics);
    if (ics == nullptr || !ics->section)
        throw InvalidArgument(
            "ics.section",
            "is missing; contactd_set_section, _set_outline, _set_profile_points or _set_profile_file "
            "say it first");
    return *ics;
}

}  // namespace contactd::c
