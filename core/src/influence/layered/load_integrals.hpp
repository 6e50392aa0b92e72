// Integrates the radial functions of a layered body over elements to displacements at offsets from a load.
#pragma once

#include <vector>

#include "contactd/observer.hpp"
#include "influence/layered/edge_rule.hpp"
#include "influence/layered/offset_lattice.hpp"
#include "influence/layered/radial_functions.hpp"

namespace contactd {

/// Computes displacements under constant tractions. The kernels are divergences of vector fields, so that only
/// integrals along the edges of the element remain, and nothing is singular: zz = div (D e_rho); xx, yy and xy consist
/// of div (F e_rho) and derivatives of E e_rho; xz = -d Phi/dx.
class ConstantLoad {
   public:
    /// Edges have distances from `least` to `largest`.
    ConstantLoad(const Layers& body, double least, double largest);

    /// Returns coefficients in mm^3/N, [l][k]. Throws Cancelled if the observer cancels.
    std::vector<SurfaceCoefficients> at(const OffsetLattice& offsets, const Observer& observer) const;

   private:
    struct EdgeSums;
    EdgeSums sums(double across, double from, double to) const;

    double least_;
    RadialFunctions<4> radial_;
    EdgeRule rule_;
};

/// Computes displacements under bilinear tractions. A hat function is bilinear on each of the four cells between
/// element centres, so that moments of the kernels over cells are sufficient; those are integrals along edges. With D,
/// F and Phi as above, Psi' = -E, and Q, R the radial fields whose divergences are Psi and Phi:
///   the integral of x div (D e_rho) is that of rho D along edges x = constant,
///   xx contains -(second difference of Psi along x)/dx, under the hat function along y,
///   xy = -(differences of the integrals of Psi over cells)/(dx dy),  xz = slope of the hat function times Phi.
class BilinearLoad {
   public:
    BilinearLoad(const Layers& body, double least, double largest);
    std::vector<SurfaceCoefficients> at(const OffsetLattice& offsets, const Observer& observer) const;

   private:
    struct EdgeSums;
    struct Cell;
    using Edges = std::vector<EdgeSums>;
    using Cells = std::vector<Cell>;
    EdgeSums sums(double across, double from, double to) const;
    Edges row_line(const EdgeLines& lines, std::size_t j) const;   // on the line y[j]
    Edges row_edges(const EdgeLines& lines, std::size_t j) const;  // across the row between y[j] and y[j + 1]
    static Cells row_cells(const Edges& below, const Edges& between, const Edges& above);

    double least_;
    RadialFunctions<5> radial_;
    EdgeRule rule_;
};

}  // namespace contactd
