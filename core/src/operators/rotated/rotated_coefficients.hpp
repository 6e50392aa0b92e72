// Computes coefficients between rows whose axes rotate with a surface from those midway between rows.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "midway_kernels.hpp"
#include "operators/strips/strip_coefficients.hpp"

namespace contactd {

/// Between rows I and J, whose normals have the angles a_I and a_J, tau = a_I - a_J, the coefficients are R(tau/2) K
/// R(tau/2), with K those midway between them (see rotated_half_space). With S and D for (nn + ss)/2 and (nn - ss)/2:
///     nn = D + cos(tau) S + sin(tau) sn                ss = -D + cos(tau) S + sin(tau) sn
///     sn = -ns = -sin(tau) S + cos(tau) sn             xx = xx
///     sx = cos(tau/2) xs + sin(tau/2) xn               xn = -sin(tau/2) xs + cos(tau/2) xn
/// Therefore no coefficient needs its own transform: the angles rotate those of the distances exactly.
class RotatedCoefficients final : public StripCoefficients {
   public:
    /// `angles` (rad) are those of the rows, whose distances the kernels must cover.
    RotatedCoefficients(std::shared_ptr<const MidwayKernels> midway, std::vector<double> angles);

    int strips() const override { return static_cast<int>(angles_.size()); }
    int offsets() const override { return midway_->nx(); }
    bool coupled() const override { return coupled_; }
    double self(Axis i, int strip) const override;
    std::size_t bytes() const override;

    SymmetricSymbol normal(const SymbolExtent& extent, const StripFft& fft) const override;
    SymmetricSymbol tangential(const SymbolExtent& extent, const StripFft& fft) const override;
    RectangularSymbol coupling(const SymbolExtent& extent, const StripFft& fft) const override;
    std::shared_ptr<const StripCoefficients> coarse(const ElementBox& box, int along_x, int along_y) const override;

   private:
    std::span<const double> angles_of(const SymbolExtent& extent) const;

    const std::shared_ptr<const MidwayKernels> midway_;
    const std::vector<double> angles_;
    const bool coupled_;
};

}  // namespace contactd
