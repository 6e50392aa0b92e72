// Coefficients between strips of elements, and the symbols that products make of them.
#pragma once

#include <cstddef>
#include <memory>

#include "contactd/axis.hpp"
#include "contactd/element_box.hpp"
#include "operators/fft/periodic_joint.hpp"
#include "strip_fft.hpp"
#include "strip_symbols.hpp"

namespace contactd {

/// States whether the components of a table are even and odd in the offset as those of StripTable, or the other way
/// round.
enum class OffsetParity { natural, opposite };

/// The strips and offsets along x that symbols are made for.
struct SymbolExtent {
    int first_strip, strips;
    int offsets;  ///< 0..offsets-1 along x
    int period;
    OffsetParity parity;
    PeriodicJoint joint;  ///< how coefficients go on to the next period
    double left_out;      ///< see SymmetricSymbol::trim

    bool natural() const { return parity == OffsetParity::natural; }
};

/// Safe to use from several threads at once.
class StripCoefficients {
   public:
    virtual ~StripCoefficients() = default;

    virtual int strips() const = 0;
    virtual int offsets() const = 0;  ///< along x
    /// A[i,z] and A[z,i] of the tangential i beyond coupling_tolerance.
    virtual bool coupled() const = 0;
    /// A[i,i] of an element of the strip on itself (mm^3/N).
    virtual double self(Axis i, int strip) const = 0;
    virtual std::size_t bytes() const = 0;

    /// Waves of x are turned by -i on their way in and out (WavePhase). With natural parity that makes all matrices
    /// real; with the opposite one they are -i times real ones. Entries of tangential symbols are x and y of a strip in
    /// turns, so that what is left out lies far from the diagonal. `fft` has the period of the extent.
    virtual SymmetricSymbol normal(const SymbolExtent& extent, const StripFft& fft) const = 0;
    virtual SymmetricSymbol tangential(const SymbolExtent& extent, const StripFft& fft) const = 0;
    virtual RectangularSymbol coupling(const SymbolExtent& extent, const StripFft& fft) const = 0;

    /// Returns those of elements of along_x x along_y on the elements of `box`: mean displacements over one for a unit
    /// traction on another. The last may reach beyond the grid, where the surface goes on as it is before.
    virtual std::shared_ptr<const StripCoefficients> coarse(const ElementBox& box, int along_x, int along_y) const = 0;
};

}  // namespace contactd
