// What a contact solver needs to know of the bodies: displacements for tractions. Solvers do not know whether a
// two-dimensional convolution or something else stands behind it.
#pragma once

#include <cstddef>
#include <span>

#include "contactd/ic_table.hpp"

namespace contactd {

/// All spans have size() entries, in the element order of the grid. Implementations are safe to use from several
/// threads at once.
class InfluenceOperator {
   public:
    virtual ~InfluenceOperator() = default;
    virtual std::size_t size() const = 0;
    /// uz = A_zz pz
    virtual void normal(std::span<const double> pz, std::span<double> uz) const = 0;
    /// (ux, uy) = [[A_xx, A_xy], [A_yx, A_yy]] (px, py)
    virtual void tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                            std::span<double> uy) const = 0;
    /// A[i,i](0,0), the influence of an element on itself (mm^3/N).
    virtual double diagonal(Axis i) const = 0;
    /// z ~ A[i,i]^-1 r, symmetric and positive definite; any approximation serves, even a scaled identity.
    virtual void precondition(Axis i, std::span<const double> r, std::span<double> z) const = 0;

    /// The same bodies on a coarser grid, for solvers to find a first estimate on, or null. Lives as long as this one.
    virtual const InfluenceOperator* coarser() const { return nullptr; }
    /// Means over the elements that a coarser one stands for; called only when there is a coarser grid.
    virtual void to_coarser(std::span<const double> /*fine*/, std::span<double> /*coarse*/) const {}
    /// Interpolates between the centres of the coarser elements.
    virtual void from_coarser(std::span<const double> /*coarse*/, std::span<double> /*fine*/) const {}
};

}  // namespace contactd
