// Predicts the memory of coefficients that differ from strip to strip, for longitudinally uniform bodies and curved
// patches.
#pragma once

namespace contactd {

/// Selects the kind of a step of rolling, in elements along x. Only a step by a fraction of an element needs separate
/// tables.
enum class StripRolling { none, whole, fractional };

/// Returns the kind of a step of `elements` elements.
StripRolling strip_rolling(double elements);

/// Returns the peak memory of tables, symbols and boxes of elements in bytes, for `pairs`, the number of offsets along
/// x times pairs of strips. `tables` bodies have separate tables, whose sum is that of the pair.
double strip_bytes(double pairs, int tables, StripRolling step);

/// Returns the memory in bytes of a patch of half-spaces that rotate from row to row, for nx*ny `elements` and nx*ny*ny
/// `pairs`. Such a patch needs no tables.
double rotated_bytes(double elements, double pairs);

}  // namespace contactd
