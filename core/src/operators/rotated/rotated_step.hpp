// Computes the increment of displacements over a step of rolling, on half-spaces along the loaded row.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "contactd/grid.hpp"
#include "contactd/material.hpp"
#include "contactd/observer.hpp"
#include "contactd/step_operator.hpp"
#include "operators/fft/padded_fft.hpp"
#include "row_rotations.hpp"

namespace contactd {

/// Computes the change of displacements of a flat surface along its normal over a step along x, for tractions along x,
/// y and z.
class NormalIncrement {
   public:
    /// Offsets are -(nx-1)..nx-1 x -(ny-1)..ny-1, shape [3, 2 ny - 1, 2 nx - 1]: load axis; l; k (mm^3/N).
    NormalIncrement(int nx, int ny, std::vector<double> kernels);

    std::size_t size() const { return static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_); }
    void of_normal(std::span<const double> pz, std::span<double> uz) const { fft_.apply(z_, pz, uz); }
    void of_tangential(std::span<const double> px, std::span<const double> py, std::span<double> uz) const {
        fft_.gather(x_, y_, px, py, uz);
    }
    std::shared_ptr<const NormalIncrement> on(int nx, int ny) const;

   private:
    PaddedFft::ComplexSymbol symbol(std::size_t load) const;

    int nx_, ny_;
    std::vector<double> kernels_;
    PaddedFft fft_;
    PaddedFft::ComplexSymbol x_, y_, z_;
};

/// Returns the increment of half-spaces, over a step of `shift` (mm) along x. Throws Cancelled.
std::shared_ptr<const NormalIncrement> normal_increment(const MaterialPair& bodies, const Grid& grid, double shift,
                                                        const Observer& observer);

/// Implements the tangential increment of RotatedOperator. Inverses and the coarser grid for first estimates are those
/// of the flat surface.
class RotatedStep final : public StepOperator {
   public:
    /// `flat` and `along_normal` are those of a flat surface. Throws InvalidArgument if the numbers of elements differ.
    RotatedStep(std::shared_ptr<const StepOperator> flat, std::shared_ptr<const NormalIncrement> along_normal,
                RowRotations rotations);

    std::size_t size() const override { return flat_->size(); }
    void tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                    std::span<double> uy) const override;
    bool coupled() const override { return true; }
    void tangential_of_normal(std::span<const double> pz, std::span<double> ux, std::span<double> uy) const override;
    std::size_t bytes() const override { return 2 * flat_->bytes(); }
    std::shared_ptr<const StepInverse> inverse(double added) const override { return flat_->inverse(added); }
    std::shared_ptr<const StepOperator> on(const ElementBox& box) const override;
    const StepOperator* coarser() const override { return flat_->coarser(); }

   private:
    RowComponents of_tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux) const;
    RowComponents of_normal(std::span<const double> pz, std::span<double> ux) const;

    const std::shared_ptr<const StepOperator> flat_;
    const std::shared_ptr<const NormalIncrement> along_normal_;
    const RowRotations rotations_;
};

}  // namespace contactd
