// Represents the bodies in a contact solver: displacements for tractions. Solvers do not depend on the implementation,
// which may be a two-dimensional convolution.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "contactd/axis.hpp"
#include "contactd/element_box.hpp"

namespace contactd {

class CoarserGrid;
class ElementBoxes;

/// All spans have size() entries, in the element order of the grid. Implementations are safe to use from several
/// threads at once.
class InfluenceOperator {
   public:
    virtual ~InfluenceOperator() = default;
    virtual std::size_t size() const = 0;
    /// Computes uz = A_zz pz.
    virtual void normal(std::span<const double> pz, std::span<double> uz) const = 0;
    /// Computes (ux, uy) = [[A_xx, A_xy], [A_yx, A_yy]] (px, py).
    virtual void tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                            std::span<double> uy) const = 0;

    /// Returns whether normal and tangential contact are coupled: false if A_xz, A_yz, A_zx and A_zy are negligible
    /// (see coupling_tolerance). The two products with them then return zeros.
    virtual bool coupled() const { return false; }
    /// Computes uz = A_zx px + A_zy py.
    virtual void normal_of_tangential(std::span<const double> /*px*/, std::span<const double> /*py*/,
                                      std::span<double> uz) const {
        std::fill(uz.begin(), uz.end(), 0.0);
    }
    /// Computes ux = A_xz pz and uy = A_yz pz.
    virtual void tangential_of_normal(std::span<const double> /*pz*/, std::span<double> ux,
                                      std::span<double> uy) const {
        std::fill(ux.begin(), ux.end(), 0.0);
        std::fill(uy.begin(), uy.end(), 0.0);
    }

    /// Returns whether the matrices are symmetric. Those of rolling viscoelastic bodies are not, but they are positive
    /// definite, and so is their preconditioner.
    virtual bool is_symmetric() const { return true; }

    /// Returns A[i,i] of every element on itself (mm^3/N), > 0.
    virtual std::vector<double> diagonal(Axis i) const = 0;
    /// Approximates z = A[i,i]^-1 r by a positive definite matrix, which is symmetric if A is. It may be as rough as a
    /// scaled identity.
    virtual void precondition(Axis i, std::span<const double> r, std::span<double> z) const = 0;
    /// Preconditions both tangential components at once, with their coupling if an implementation supports it.
    virtual void precondition_tangential(std::span<const double> rx, std::span<const double> ry, std::span<double> zx,
                                         std::span<double> zy) const {
        precondition(Axis::x, rx, zx);
        precondition(Axis::y, ry, zy);
    }

    /// Returns the approximate memory, including the parts that are created on first use.
    virtual std::size_t bytes() const = 0;

    /// These optional parts make solves faster; they may be null. Both live as long as this operator.
    virtual const CoarserGrid* coarser() const { return nullptr; }
    virtual const ElementBoxes* boxes() const { return nullptr; }
};

/// Represents the bodies on a grid of larger elements, on which solvers compute a first estimate.
class CoarserGrid {
   public:
    virtual ~CoarserGrid() = default;
    virtual const InfluenceOperator& influence() const = 0;
    /// Return the number of elements in a coarser one, along x and along y. The last coarser ones may extend beyond the
    /// grid.
    virtual int along_x() const = 0;
    virtual int along_y() const = 0;
    int ratio() const { return along_x() * along_y(); }
    /// Returns means over the elements in each coarser one.
    virtual void average(std::span<const double> fine, std::span<double> coarse) const = 0;
    /// Interpolates between the centres of the coarser elements.
    virtual void interpolate(std::span<const double> coarse, std::span<double> fine) const = 0;
    /// Gives each element the value of its coarser one.
    virtual void copy(std::span<const double> coarse, std::span<double> fine) const = 0;
};

/// Represents the bodies on parts of the grid, for problems whose tractions vanish elsewhere. Products cost less there.
class ElementBoxes {
   public:
    virtual ~ElementBoxes() = default;
    /// Returns the rectangle of all elements.
    virtual ElementBox extent() const = 0;
    /// Returns a box around `needed` with cheap products. It is slightly larger, so that few sizes occur, and has a
    /// margin if the contact may grow. Returns extent() if a box would not be cheaper.
    virtual ElementBox convenient(const ElementBox& needed, bool may_grow) const = 0;
    /// Returns the operator on the elements of a box within extent(); its element order is that of the box. Results
    /// depend only on the box, not on earlier calls.
    virtual std::shared_ptr<const InfluenceOperator> influence(const ElementBox& box) const = 0;
};

/// Returns all elements: as a rectangle if the operator has boxes, otherwise as a row.
inline ElementBox extent_of(const InfluenceOperator& influence) {
    const ElementBoxes* boxes = influence.boxes();
    return boxes != nullptr ? boxes->extent() : ElementBox{0, 0, static_cast<int>(influence.size()), 1};
}

}  // namespace contactd
