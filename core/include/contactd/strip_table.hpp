// Defines influence coefficients of strips of elements on a body that is uniform along x, with any cross-section.
#pragma once

#include <cstddef>
#include <vector>

#include "contactd/axis.hpp"
#include "contactd/ic_table.hpp"
#include "contactd/observer.hpp"

namespace contactd {

/// A[i,j](I,J,k) is the displacement component i (mm) in the frame of strip I, at the middle of its arc, for a unit
/// traction (1 N/mm^2) along j of the frame of strip J. The observed element is k elements ahead of the loaded one
/// along x: x_I - x_J = k dx. The axes of a frame are x, y along the outline (s of StripFrame), and z outward. Strips
/// are numbered along s, as rows of a grid are along y. xx, yy, zz, yz and zy are even in k; xy, yx, xz and zx are odd.
struct StripTable {
    int nx = 0;         ///< offsets 0..nx-1 along x
    int strips = 0;     ///< along the cross-section
    UnsetArray values;  ///< shape [3, 3, strips, strips, nx]: displacement axis, load axis, I, J, k; mm^3/N

    StripTable() = default;
    StripTable(int nx_, int strips_) : nx(nx_), strips(strips_), values(9 * component_size(), 0.0) {}

    std::size_t component_size() const {
        return static_cast<std::size_t>(strips) * static_cast<std::size_t>(strips) * static_cast<std::size_t>(nx);
    }
    std::size_t index(Axis i, Axis j, int I, int J, int k) const {
        return (static_cast<std::size_t>(i) * 3 + static_cast<std::size_t>(j)) * component_size() +
               (static_cast<std::size_t>(I) * static_cast<std::size_t>(strips) + static_cast<std::size_t>(J)) *
                   static_cast<std::size_t>(nx) +
               static_cast<std::size_t>(k);
    }
    double& operator()(Axis i, Axis j, int I, int J, int k) { return values[index(i, j, I, J, k)]; }  ///< k >= 0
    double operator()(Axis i, Axis j, int I, int J, int k) const { return values[index(i, j, I, J, k)]; }
    /// Returns the coefficient at offsets of either sign, |k| < nx, by parity.
    double at(Axis i, Axis j, int I, int J, int k) const;

    bool operator==(const StripTable&) const = default;
};

/// Returns strips `first`..`first + strips - 1` and offsets 0..nx-1, times `factor`. Throws InvalidArgument if the
/// table is smaller, and Cancelled.
StripTable cropped(const StripTable& table, int first, int strips, int nx, double factor = 1,
                   const Observer& observer = {});

/// Returns the table of a flat surface, which is also Toeplitz along y: A(I,J,k) = A(k, l = I - J), on all offsets.
StripTable strip_table_of(const IcTable& flat);

/// Returns the largest |A[i,j](I,J,k) - A[j,i](J,I,-k)| over the mean zz of elements on themselves. By Betti's theorem,
/// it would be zero without errors if displacements were means over elements instead of values at centres.
double reciprocity_defect(const StripTable& table);

/// Returns the symmetric table (A + A')/2 for operators, with A'[i,j](I,J,k) = A[j,i](J,I,-k).
StripTable symmetrised(StripTable table);

/// Returns the table of the body mirrored in y: strips are in reverse order, and signs of y are opposite. Throws
/// Cancelled.
StripTable mirrored(const StripTable& table, const Observer& observer = {});

/// Sums the tables like pair_of of IcTable, in the frames of the lower body's strips. The upper body has the
/// same number of strips, opposite and in reverse order. Throws InvalidArgument if the extents differ, and
/// Cancelled.
StripTable pair_of(const StripTable& upper, StripTable lower, const Observer& observer = {});

}  // namespace contactd
