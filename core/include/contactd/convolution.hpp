// The influence operator of a table that is Toeplitz in both directions: A p is a convolution, done by FFT.
#pragma once

#include <memory>

#include "contactd/ic_table.hpp"
#include "contactd/influence_operator.hpp"

namespace contactd {

/// Real FFTs on a padded grid; the padded size is the 2-3-5-7-smooth number that fits, FFTW plans are made once per
/// size and shared between operators and threads.
class ConvolutionOperator final : public InfluenceOperator {
   public:
    /// `table` (of the pair of bodies) covers at least the offsets 0..nx-1 x 0..ny-1. Throws InvalidArgument otherwise.
    ConvolutionOperator(const IcTable& table, int nx, int ny);
    ~ConvolutionOperator() override;
    ConvolutionOperator(ConvolutionOperator&&) noexcept;
    ConvolutionOperator& operator=(ConvolutionOperator&&) noexcept;

    std::size_t size() const override;
    void normal(std::span<const double> pz, std::span<double> uz) const override;
    void tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                    std::span<double> uy) const override;
    /// coupling(table) > coupling_tolerance. The transforms of xz, yz, zx and zy are made when they are first needed.
    bool coupled() const override;
    void normal_of_tangential(std::span<const double> px, std::span<const double> py,
                              std::span<double> uz) const override;
    void tangential_of_normal(std::span<const double> pz, std::span<double> ux, std::span<double> uy) const override;
    double diagonal(Axis i) const override;
    void precondition(Axis i, std::span<const double> r, std::span<double> z) const override;
    void precondition_tangential(std::span<const double> rx, std::span<const double> ry, std::span<double> zx,
                                 std::span<double> zy) const override;
    /// Elements of twice the size, down to about a dozen along the longer side.
    const InfluenceOperator* coarser() const override;
    void to_coarser(std::span<const double> fine, std::span<double> coarse) const override;
    void from_coarser(std::span<const double> coarse, std::span<double> fine) const override;
    void copy_from_coarser(std::span<const double> coarse, std::span<double> fine) const override;
    int elements_per_coarser() const override;
    ElementBox extent() const override;
    ElementBox convenient_box(const ElementBox& needed, bool may_grow) const override;
    /// Operators of the same size share one; the last few sizes are kept.
    std::shared_ptr<const InfluenceOperator> restricted(const ElementBox& box) const override;

   private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// The smallest 2-3-5-7-smooth number >= n (n >= 1).
int smooth_size(int n);

}  // namespace contactd
