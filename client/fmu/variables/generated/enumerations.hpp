// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include "variables/variable.hpp"

namespace contactd::fmu::enumerations {

inline constexpr std::string_view model_keywords[] = {"full", "hertz", "fastsim", "fastrip", "polach"};
inline constexpr Enumeration model{
    "Model", model_keywords, "Overrides model: 0 full, 1 hertz, 2 fastsim, 3 fastrip, 4 polach; -1: model applies."};

inline constexpr std::string_view motion_keywords[] = {"steady", "transient", "shift"};
inline constexpr Enumeration motion{"Motion", motion_keywords,
                                    "Overrides motion.kind: 0 steady, 1 transient, 2 shift; -1: motion.kind applies."};

inline constexpr std::string_view side_keywords[] = {"left", "right"};
inline constexpr Enumeration side{"Side", side_keywords, "Overrides side: 0 left, 1 right; -1: side applies."};

inline constexpr std::string_view kinetic_friction_keywords[] = {"none", "linear", "exponential", "rational"};
inline constexpr Enumeration kinetic_friction{
    "KineticFriction", kinetic_friction_keywords,
    "Overrides friction.kinetic.law: 0 none, 1 linear, 2 exponential, 3 rational; -1: friction.kinetic.law applies."};

inline constexpr std::string_view conformal_keywords[] = {"off", "half_space", "rotated",
                                                          "fem", "auto",       "rotated_displacements"};
inline constexpr Enumeration conformal{"Conformal", conformal_keywords,
                                       "Overrides conformal: 0 off, 1 half_space, 2 rotated, 3 fem, 4 auto, 5 "
                                       "rotated_displacements; -1: conformal applies."};

}  // namespace contactd::fmu::enumerations
