// Real two-dimensional FFTs of arrays padded with zeros: the machinery behind convolutions.
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
    /// With a number of possible_lanes() of its own, for comparison.
    PaddedFft(int nx, int ny, int padded_nx, int padded_ny, std::size_t lanes);
    ~PaddedFft();
    PaddedFft(const PaddedFft&) = delete;
    PaddedFft& operator=(const PaddedFft&) = delete;

    /// The transform of a kernel, with the factor 1/(padded_nx padded_ny) of the inverse transform, in an order of its
    /// own. That of a kernel even in both offsets or odd in both is real; of one that is odd in one of them it is
    /// imaginary, and the symbol is its imaginary part.
    using Symbol = std::vector<double>;
    /// The symbol of a kernel without parity.
    struct ComplexSymbol {
        std::vector<double> real, imag;
    };

    /// Values at the offsets 0..nx-1 x 0..ny-1, shape [ny, nx], zero beyond.
    struct Kernel {
        const double* values;
        int nx, ny;
        Parity parity;
    };
    /// Offsets beyond half the period are left out.
    Symbol symbol(const Kernel& kernel) const;

    /// Values at the offsets -(nx-1)..nx-1 x -(ny-1)..ny-1, shape [2 ny - 1, 2 nx - 1], zero beyond.
    struct SignedKernel {
        const double* values;
        int nx, ny;
    };
    /// Offsets beyond half the period are left out; at half the period both signs share one place: their mean.
    ComplexSymbol symbol(const SignedKernel& kernel) const;

    /// Returns the symbol times a function of the wavenumber along x, of which `factor` has the value for each number
    /// of periods, 0 to padded_nx/2.
    ComplexSymbol times_along_x(const Symbol& symbol, std::span<const std::complex<double>> factor) const;

    /// Convolution of one array; the symbol is real.
    void apply(const Symbol& symbol, std::span<const double> in, std::span<double> out) const;
    /// Convolution with a kernel without parity.
    void apply(const ComplexSymbol& symbol, std::span<const double> in, std::span<double> out) const;
    /// Convolution of a pair of arrays: out_x = xx in_x + xy in_y, out_y = yx in_x + yy in_y. All symbols are real; xy
    /// and yx may both be empty, which stands for zero.
    struct PairSymbols {
        const Symbol &xx, &xy, &yx, &yy;
    };
    void apply(const PairSymbols& symbols, std::span<const double> in_x, std::span<const double> in_y,
               std::span<double> out_x, std::span<double> out_y) const;
    /// Symbols of a pair of kernels without parity.
    struct ComplexPairSymbols {
        const ComplexSymbol &xx, &xy, &yx, &yy;
    };
    void apply(const ComplexPairSymbols& symbols, std::span<const double> in_x, std::span<const double> in_y,
               std::span<double> out_x, std::span<double> out_y) const;
    /// out = x in_x + y in_y, both symbols imaginary.
    void gather(const Symbol& x, const Symbol& y, std::span<const double> in_x, std::span<const double> in_y,
                std::span<double> out) const;
    /// Gathers with symbols of kernels without parity.
    void gather(const ComplexSymbol& x, const ComplexSymbol& y, std::span<const double> in_x,
                std::span<const double> in_y, std::span<double> out) const;
    /// out_x = x in, out_y = y in, both symbols imaginary.
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
    mutable std::vector<std::unique_ptr<Workspace>> idle_;  // one workspace a call at a time
};

}  // namespace contactd
