// Defines coefficients between strips of elements, and their symbols for products.
#pragma once

#include <cstddef>
#include <memory>

#include "contactd/axis.hpp"
#include "contactd/element_box.hpp"
#include "operators/fft/periodic_joint.hpp"
#include "strip_fft.hpp"
#include "strip_symbols.hpp"

namespace contactd {

/// Selects whether the components of a table are even and odd in the offset as those of StripTable, or reversed.
enum class OffsetParity { natural, opposite };

/// Describes the strips and offsets along x of symbols.
struct SymbolExtent {
    int first_strip, strips;
    int offsets;  ///< 0..offsets-1 along x
    int period;
    OffsetParity parity;
    PeriodicJoint joint;  ///< continuation of coefficients to the next period
    double left_out;      ///< as in SymmetricSymbol::trim

    bool natural() const { return parity == OffsetParity::natural; }
};

/// Implementations are safe to use from several threads at once.
class StripCoefficients {
   public:
    virtual ~StripCoefficients() = default;

    virtual int strips() const = 0;
    virtual int offsets() const = 0;  ///< along x
    /// Returns whether A[i,z] and A[z,i] of the tangential i exceed coupling_tolerance.
    virtual bool coupled() const = 0;
    /// Returns A[i,i] of an element of the strip on itself (mm^3/N).
    virtual double self(Axis i, int strip) const = 0;
    virtual std::size_t bytes() const = 0;

    /// Return the symbols. Waves of x are multiplied by -i before and after the product (WavePhase). With natural
    /// parity all matrices are then real; with the opposite one they are -i times real ones. Entries of tangential
    /// symbols are x and y of a strip alternately, so that omitted entries lie far from the diagonal. `fft` has the
    /// period of the extent.
    virtual SymmetricSymbol normal(const SymbolExtent& extent, const StripFft& fft) const = 0;
    virtual SymmetricSymbol tangential(const SymbolExtent& extent, const StripFft& fft) const = 0;
    virtual RectangularSymbol coupling(const SymbolExtent& extent, const StripFft& fft) const = 0;

    /// Returns the coefficients of elements of along_x x along_y on the elements of `box`: mean displacements over one
    /// for a unit traction on another. The last may extend beyond the grid, where the surface continues unchanged.
    virtual std::shared_ptr<const StripCoefficients> coarse(const ElementBox& box, int along_x, int along_y) const = 0;
};

}  // namespace contactd
