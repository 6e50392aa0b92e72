// Fills matrices of symbols between rotated rows, in the order of strip_symbols.hpp.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "midway_kernels.hpp"
#include "operators/strips/strip_kernels.hpp"

namespace contactd {

/// Holds cosines and sines of a factor times the difference of the angles of each pair of rows, shape [rows, rows].
struct PairRotations {
    std::size_t rows;
    std::vector<double> cosine, sine;

    PairRotations(std::span<const double> angles, double factor);
};

/// Fill the matrix of one group of wavenumbers by RotatedCoefficients' formulas, as far as it is kept. `whole` has the
/// factor 1, `half` the factor 1/2.
void fill_normal(const MidwaySymbols& symbols, std::size_t group, const PairRotations& whole, const std::size_t* begin,
                 double* matrix);
void fill_normal(const MidwaySymbols& symbols, std::size_t group, const PairRotations& whole, const std::size_t* begin,
                 float* matrix);
void fill_tangential(const MidwaySymbols& symbols, std::size_t group, const PairRotations& whole,
                     const PairRotations& half, const std::size_t* begin, double* matrix);
void fill_tangential(const MidwaySymbols& symbols, std::size_t group, const PairRotations& whole,
                     const PairRotations& half, const std::size_t* begin, float* matrix);
void fill_coupling(const MidwaySymbols& symbols, std::size_t group, const PairRotations& whole,
                   const PairRotations& half, const EntryRange* kept, double* matrix);
void fill_coupling(const MidwaySymbols& symbols, std::size_t group, const PairRotations& whole,
                   const PairRotations& half, const EntryRange* kept, float* matrix);

}  // namespace contactd
