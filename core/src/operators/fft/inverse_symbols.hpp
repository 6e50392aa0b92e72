// Computes symbols of approximate inverses of a table's diagonal components, as if the grid were periodic.
#pragma once

#include "contactd/ic_table.hpp"
#include "padded_fft.hpp"

namespace contactd {

/// Returns the inverse symbol of one component, made positive, because errors and the end of the table may have made
/// the symbol negative.
PaddedFft::Symbol reciprocal_symbol(const PaddedFft& fft, const IcTable& table, Axis i);

/// Holds the inverse of the 2 x 2 symbol of the tangential components, made symmetric and positive definite.
struct TangentialInverse {
    PaddedFft::Symbol xx, yy, xy;
};
TangentialInverse tangential_inverse(const PaddedFft& fft, const IcTable& table);

/// Returns the kernel of a component.
PaddedFft::Kernel kernel_of(const IcTable& table, Axis i, Axis j);

}  // namespace contactd
