// Implements the influence operator of a table that is Toeplitz in both directions: A p is a convolution, computed by
// FFT.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "contactd/ic_table.hpp"
#include "contactd/influence_operator.hpp"

namespace contactd {

/// Uses real FFTs on a padded grid. The padded size is a 2-3-5-smooth number, and the data of a size are created once
/// and shared between operators and threads.
class ConvolutionOperator final : public InfluenceOperator {
   public:
    /// `table` (of the pair of bodies) covers at least the offsets 0..nx-1 x 0..ny-1. Throws InvalidArgument otherwise.
    ConvolutionOperator(const IcTable& table, int nx, int ny);
    /// Creates the operator on the grid of the table's extent.
    explicit ConvolutionOperator(IcTable table);
    ~ConvolutionOperator() override;
    ConvolutionOperator(ConvolutionOperator&&) noexcept;
    ConvolutionOperator& operator=(ConvolutionOperator&&) noexcept;

    std::size_t size() const override;
    void normal(std::span<const double> pz, std::span<double> uz) const override;
    void tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                    std::span<double> uy) const override;
    /// Returns whether coupling(table) > coupling_tolerance. The transforms of xz, yz, zx and zy are computed when they
    /// are first needed.
    bool coupled() const override;
    void normal_of_tangential(std::span<const double> px, std::span<const double> py,
                              std::span<double> uz) const override;
    void tangential_of_normal(std::span<const double> pz, std::span<double> ux, std::span<double> uy) const override;
    std::vector<double> diagonal(Axis i) const override;
    void precondition(Axis i, std::span<const double> r, std::span<double> z) const override;
    void precondition_tangential(std::span<const double> rx, std::span<const double> ry, std::span<double> zx,
                                 std::span<double> zy) const override;
    std::size_t bytes() const override { return size() * bytes_per_element; }
    /// It approximates the memory of the table, symbols of five to nine components on a padded grid, coarser grids, and
    /// some boxes.
    static constexpr std::size_t bytes_per_element = 800;

    /// Returns the grid of elements of twice the size, down to about a dozen along the longer side.
    const CoarserGrid* coarser() const override;
    /// Operators of the same size share one; the last few sizes are kept.
    const ElementBoxes* boxes() const override;

   private:
    class Coarser;
    class Boxes;
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Returns the smallest 2-3-5-smooth number >= n (n >= 1).
int smooth_size(int n);

}  // namespace contactd
