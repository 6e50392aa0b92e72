// Computes real two-dimensional FFTs of arrays padded with zeros, for convolutions.
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "contactd/axis.hpp"

namespace contactd {

class LaneFft;

/// Transforms arrays of shape [ny, nx] on the periodic grid [padded_ny, padded_nx].
class PaddedFft {
   public:
    PaddedFft(int nx, int ny, int padded_nx, int padded_ny);
    /// Uses a given number of possible_lanes(), for comparison.
    PaddedFft(int nx, int ny, int padded_nx, int padded_ny, std::size_t lanes);
    ~PaddedFft();
    PaddedFft(const PaddedFft&) = delete;
    PaddedFft& operator=(const PaddedFft&) = delete;

    /// Holds the transform of a kernel, with the factor 1/(padded_nx padded_ny) of the inverse transform, in an
    /// internal order. It is real for a kernel that is even in both offsets or odd in both. For a kernel that is odd in
    /// one of them it is imaginary, and the symbol is its imaginary part.
    using Symbol = std::vector<double>;
    /// Holds the symbol of a kernel without parity.
    struct ComplexSymbol {
        std::vector<double> real, imag;
    };

    /// Holds values at the offsets 0..nx-1 x 0..ny-1, shape [ny, nx], zero beyond.
    struct Kernel {
        const double* values;
        int nx, ny;
        Parity parity;
    };
    /// Returns the symbol of a kernel. Offsets beyond half the period are omitted.
    Symbol symbol(const Kernel& kernel) const;

    /// Holds values at the offsets -(nx-1)..nx-1 x -(ny-1)..ny-1, shape [2 ny - 1, 2 nx - 1], zero beyond.
    struct SignedKernel {
        const double* values;
        int nx, ny;
    };
    /// Returns the symbol of a kernel. Offsets beyond half the period are omitted; at half the period, where both signs
    /// coincide, their mean is used.
    ComplexSymbol symbol(const SignedKernel& kernel) const;

    /// Returns the symbol times a function of the wavenumber along x; `factor` holds its value for each number of
    /// periods, 0 to padded_nx/2.
    ComplexSymbol times_along_x(const Symbol& symbol, std::span<const std::complex<double>> factor) const;

    /// Convolves one array; the symbol is real.
    void apply(const Symbol& symbol, std::span<const double> in, std::span<double> out) const;
    /// Convolves with a kernel without parity.
    void apply(const ComplexSymbol& symbol, std::span<const double> in, std::span<double> out) const;
    /// Convolves a pair of arrays: out_x = xx in_x + xy in_y, out_y = yx in_x + yy in_y. All symbols are real; xy and
    /// yx may both be empty, which represents zero.
    struct PairSymbols {
        const Symbol &xx, &xy, &yx, &yy;
    };
    void apply(const PairSymbols& symbols, std::span<const double> in_x, std::span<const double> in_y,
               std::span<double> out_x, std::span<double> out_y) const;
    /// Holds symbols of a pair of kernels without parity.
    struct ComplexPairSymbols {
        const ComplexSymbol &xx, &xy, &yx, &yy;
    };
    void apply(const ComplexPairSymbols& symbols, std::span<const double> in_x, std::span<const double> in_y,
               std::span<double> out_x, std::span<double> out_y) const;
    /// Computes out = x in_x + y in_y; both symbols are imaginary.
    void gather(const Symbol& x, const Symbol& y, std::span<const double> in_x, std::span<const double> in_y,
                std::span<double> out) const;
    /// Gathers with symbols of kernels without parity.
    void gather(const ComplexSymbol& x, const ComplexSymbol& y, std::span<const double> in_x,
                std::span<const double> in_y, std::span<double> out) const;
    /// Computes out_x = x in, out_y = y in; both symbols are imaginary.
    void spread(const Symbol& x, const Symbol& y, std::span<const double> in, std::span<double> out_x,
                std::span<double> out_y) const;
    /// Spreads with symbols of kernels without parity.
    void spread(const ComplexSymbol& x, const ComplexSymbol& y, std::span<const double> in, std::span<double> out_x,
                std::span<double> out_y) const;

    double norm_factor() const;  ///< 1/(padded_nx padded_ny)

   private:
    struct Plans;
    struct Workspace;
    class Lease;  // of a workspace

    template <std::size_t inputs, std::size_t outputs, class Product>
    void convolve(const std::array<std::span<const double>, inputs>& in,
                  const std::array<std::span<double>, outputs>& out, const Product& product) const;
    template <class Store>
    void transform_columns(const double* spectrum, const Store& store) const;
    const LaneFft& fft() const;

    std::shared_ptr<const Plans> plans_;
    mutable std::mutex idle_mutex_;
    mutable std::vector<std::unique_ptr<Workspace>> idle_;  // each call uses one workspace
};

}  // namespace contactd
