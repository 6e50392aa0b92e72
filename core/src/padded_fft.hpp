// Real two-dimensional FFTs of arrays padded with zeros: the machinery behind convolutions with even and odd kernels.
#pragma once

#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace contactd {

/// Transforms arrays of shape [ny, nx] on the periodic grid [padded_ny, padded_nx]. Kernels must be even in both
/// offsets or odd in both, so that their transforms (symbols) are real.
class PaddedFft {
   public:
    PaddedFft(int nx, int ny, int padded_nx, int padded_ny);
    ~PaddedFft();
    PaddedFft(const PaddedFft&) = delete;
    PaddedFft& operator=(const PaddedFft&) = delete;

    /// A real symbol with the factor 1/(padded_nx padded_ny) of the inverse transform, in an order of its own.
    using Symbol = std::vector<double>;

    /// Values at the offsets 0..nx-1 x 0..ny-1, shape [ny, nx], zero beyond; even in both offsets or odd in both.
    struct Kernel {
        const double* values;
        int nx, ny;
        bool odd;
    };
    /// Offsets beyond half the period are left out.
    Symbol symbol(const Kernel& kernel) const;

    /// Convolution of one array.
    void apply(const Symbol& symbol, std::span<const double> in, std::span<double> out) const;
    /// Convolution of a pair of arrays: out_x = xx in_x + xy in_y, out_y = yx in_x + yy in_y.
    struct PairSymbols {
        const Symbol &xx, &xy, &yx, &yy;
    };
    void apply(const PairSymbols& symbols, std::span<const double> in_x, std::span<const double> in_y,
               std::span<double> out_x, std::span<double> out_y) const;

    double norm_factor() const;  ///< 1/(padded_nx padded_ny)

   private:
    struct Plans;
    struct Workspace;
    class Lease;  // of a workspace

    void rows_forward(std::span<const double> in, Workspace& workspace, int field) const;
    void rows_inverse(Workspace& workspace, int field, std::span<double> out) const;

    std::shared_ptr<const Plans> plans_;
    mutable std::mutex idle_mutex_;
    mutable std::vector<std::unique_ptr<Workspace>> idle_;  // one workspace a call at a time
};

}  // namespace contactd
