// Computes products with coefficients between strips, or with some of these, by FFTs along x.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "contactd/element_box.hpp"
#include "operators/fft/workspaces.hpp"
#include "operators/lazy.hpp"
#include "strip_coefficients.hpp"

namespace contactd {

/// Computes products on the elements of a box of a grid whose rows are the strips. Arrays are in the element order of
/// the box. Symbols are computed when they are first needed. Objects are safe to use from several threads at once.
class StripProducts {
   public:
    /// Reads displacements at elements up to `reach` elements ahead of the box and behind it, for which there are
    /// coefficients at box.nx + reach offsets. The position of the box along x does not matter. No coefficient (mm^3/N)
    /// changes by more than `left_out`: the effect of large wavenumbers on distant strips is smaller, and is not read.
    /// The matrices stay symmetric.
    StripProducts(std::shared_ptr<const StripCoefficients> coefficients, const ElementBox& box, int reach,
                  OffsetParity parity, double left_out);
    ~StripProducts();

    /// These two require natural parity.
    void normal(std::span<const double> pz, std::span<double> uz) const;
    void normal_of_tangential(std::span<const double> px, std::span<const double> py, std::span<double> uz) const;
    void tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                    std::span<double> uy) const;
    void tangential_of_normal(std::span<const double> pz, std::span<double> ux, std::span<double> uy) const;
    /// Add the results to ux and uy.
    void add_tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                        std::span<double> uy) const;
    void add_tangential_of_normal(std::span<const double> pz, std::span<double> ux, std::span<double> uy) const;
    /// Subtracts the displacements at the points that lie `ahead` elements further along x, |ahead| <= reach.
    void tangential_change(int ahead, std::span<const double> px, std::span<const double> py, std::span<double> ux,
                           std::span<double> uy) const;
    void tangential_change_of_normal(int ahead, std::span<const double> pz, std::span<double> ux,
                                     std::span<double> uy) const;

   private:
    const SymmetricSymbol& tangential_symbol() const;
    const RectangularSymbol& coupling_symbol() const;
    struct Workspace;
    Workspaces<Workspace>::Lease workspace() const;
    void normal_waves(std::span<const double> pz, Workspace& work) const;
    void in_waves(std::span<const double> px, std::span<const double> py, Workspace& work) const;
    void tangential_waves(std::span<const double> px, std::span<const double> py, Workspace& work) const;
    void coupled_waves(std::span<const double> pz, Workspace& work) const;
    void turn_back(Waves& waves) const;
    void read_normal(Workspace& work, std::span<double> u) const;
    template <class Take>
    void read_tangential(Workspace& work, std::span<double> ux, std::span<double> uy, int length,
                         const Take& take) const;
    auto difference_to(int ahead) const;

    const std::shared_ptr<const StripCoefficients> coefficients_;
    const ElementBox box_;
    const SymbolExtent extent_;
    const std::size_t strips_;
    const StripFft fft_;
    mutable Lazy<SymmetricSymbol> normal_, tangential_;
    mutable Lazy<RectangularSymbol> coupling_;
    mutable Workspaces<Workspace> idle_;
};

}  // namespace contactd
