// Holds coefficients between rows that are equally spaced along a surface, in axes midway between those of both rows.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "contactd/ic_table.hpp"
#include "operators/cached_boxes.hpp"
#include "operators/strips/strip_coefficients.hpp"

namespace contactd {

/// Holds transforms of these coefficients along x as real numbers, by the rules of StripCoefficients. Arrays have shape
/// [groups, rows, lanes] by the distance in rows; those of sn and xn are empty without coupling.
struct MidwaySymbols {
    std::size_t rows = 0;
    std::vector<double> xx, xs;
    std::vector<double> sum, difference;  ///< (nn + ss)/2 and (nn - ss)/2
    std::vector<double> sn, xn;

    std::size_t groups() const { return xx.size() / (rows * Waves::lanes); }
};

/// Axes are x, s along the surface, and n. Coefficients depend only on the distance of the rows, whatever their angles:
/// sx is xs, nx is -xn and ns is -sn. Objects are safe to use from several threads at once.
class MidwayKernels {
   public:
    enum Component { xx, xs, ss, nn, sn, xn };
    using Values = std::array<std::vector<double>, 6>;

    /// Creates the coefficients of a pair of half-spaces.
    explicit MidwayKernels(IcTable pair);
    /// `values` by component have shape [ny, nx]: offsets 0..nx-1 along x, distances 0..ny-1 (mm^3/N).
    MidwayKernels(int nx, int ny, Values values, bool coupled, OffsetParity parity);

    int nx() const { return nx_; }
    int ny() const { return ny_; }
    bool coupled() const { return coupled_; }
    double at_origin(Component component) const { return values_[component][0]; }
    std::size_t bytes() const;

    /// Returns the symbols; those of the last few extents are cached.
    std::shared_ptr<const MidwaySymbols> symbols(const SymbolExtent& extent, const StripFft& fft) const;
    /// Returns the coefficients on a coarser grid with nx x ny elements. It requires a pair of half-spaces.
    std::shared_ptr<const MidwayKernels> coarse(int nx, int ny) const;

   private:
    std::vector<double> transform(Component component, const SymbolExtent& extent, const StripFft& fft) const;

    const std::optional<IcTable> pair_;
    const int nx_, ny_;
    const bool coupled_;
    const OffsetParity parity_;
    const Values values_;
    mutable CachedBoxes<MidwaySymbols> symbols_;
    mutable CachedBoxes<MidwayKernels> coarse_;
};

}  // namespace contactd
