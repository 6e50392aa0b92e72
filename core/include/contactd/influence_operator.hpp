// What a contact solver needs to know of the bodies: displacements for tractions. Solvers do not know whether a
// two-dimensional convolution or something else stands behind it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>

#include "contactd/ic_table.hpp"

namespace contactd {

/// A rectangle of elements: columns first_x .. first_x + nx - 1, rows alike.
struct ElementBox {
    int first_x = 0, first_y = 0, nx = 0, ny = 0;

    std::size_t size() const { return static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny); }
    bool operator==(const ElementBox&) const = default;
};

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

    /// Whether normal and tangential contact influence each other: false when A_xz, A_yz, A_zx and A_zy are negligible
    /// (see coupling_tolerance); the two products with them then give zeros.
    virtual bool coupled() const { return false; }
    /// uz = A_zx px + A_zy py
    virtual void normal_of_tangential(std::span<const double> /*px*/, std::span<const double> /*py*/,
                                      std::span<double> uz) const {
        std::fill(uz.begin(), uz.end(), 0.0);
    }
    /// ux = A_xz pz, uy = A_yz pz
    virtual void tangential_of_normal(std::span<const double> /*pz*/, std::span<double> ux,
                                      std::span<double> uy) const {
        std::fill(ux.begin(), ux.end(), 0.0);
        std::fill(uy.begin(), uy.end(), 0.0);
    }

    /// A[i,i](0,0), the influence of an element on itself (mm^3/N).
    virtual double diagonal(Axis i) const = 0;
    /// z ~ A[i,i]^-1 r, symmetric and positive definite; any approximation serves, even a scaled identity.
    virtual void precondition(Axis i, std::span<const double> r, std::span<double> z) const = 0;
    /// The same for both tangential components at once, with their coupling where an implementation knows it.
    virtual void precondition_tangential(std::span<const double> rx, std::span<const double> ry, std::span<double> zx,
                                         std::span<double> zy) const {
        precondition(Axis::x, rx, zx);
        precondition(Axis::y, ry, zy);
    }

    /// The same bodies on a coarser grid, for solvers to find a first estimate on, or null. Lives as long as this one.
    virtual const InfluenceOperator* coarser() const { return nullptr; }
    /// Means over the elements that a coarser one stands for; called only when there is a coarser grid.
    virtual void to_coarser(std::span<const double> /*fine*/, std::span<double> /*coarse*/) const {}
    /// Interpolates between the centres of the coarser elements.
    virtual void from_coarser(std::span<const double> /*coarse*/, std::span<double> /*fine*/) const {}
    /// Gives every element the value of the coarser one it belongs to.
    virtual void copy_from_coarser(std::span<const double> /*coarse*/, std::span<double> /*fine*/) const {}
    /// How many elements a coarser one stands for.
    virtual int elements_per_coarser() const { return 1; }

    /// All elements, as a rectangle.
    virtual ElementBox extent() const { return {0, 0, static_cast<int>(size()), 1}; }
    /// A box around `needed` on which products are cheap: a little larger, so that few sizes occur, and with a margin
    /// where the contact may grow; extent() when nothing is gained.
    virtual ElementBox convenient_box(const ElementBox& /*needed*/, bool /*may_grow*/) const { return extent(); }
    /// The same bodies on the elements of a box within extent(), for problems whose tractions vanish elsewhere; its
    /// element order is that of the box. Null when this operator cannot be restricted. Results depend on the box alone,
    /// not on what was asked for before.
    virtual std::shared_ptr<const InfluenceOperator> restricted(const ElementBox& /*box*/) const { return nullptr; }
};

}  // namespace contactd
