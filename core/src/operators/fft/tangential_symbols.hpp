// Holds transforms of the tangential components of a table, without parity.
#pragma once

#include <algorithm>

#include "influence/shifted_table.hpp"
#include "padded_fft.hpp"

namespace contactd {

/// For half-spaces and layers, xy and yx are equal: yx is then empty, and products read a quarter less.
struct TangentialSymbols {
    PaddedFft::ComplexSymbol xx, xy, yx, yy;

    static TangentialSymbols of(const PaddedFft& fft, const ShiftedTable& table) {
        using enum Axis;
        const auto values = [&](Axis i, Axis j) {
            return &table.values[table.index(i, j, 1 - table.nx, 1 - table.ny)];
        };
        const auto symbol = [&](Axis i, Axis j) {
            return fft.symbol(PaddedFft::SignedKernel{values(i, j), table.nx, table.ny});
        };
        TangentialSymbols made{symbol(x, x), symbol(x, y), {}, symbol(y, y)};
        if (!std::equal(values(x, y), values(x, y) + table.component_size(), values(y, x))) made.yx = symbol(y, x);
        return made;
    }

    const PaddedFft::ComplexSymbol& of_yx() const { return yx.real.empty() ? xy : yx; }
    PaddedFft::ComplexPairSymbols pair() const { return {xx, xy, of_yx(), yy}; }
};

}  // namespace contactd
