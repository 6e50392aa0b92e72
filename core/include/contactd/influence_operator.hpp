// The bodies as a contact solver sees them: displacements for tractions. Solvers do not know whether a two-dimensional
// convolution or something else stands behind it.
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

    /// Whether the products are those of symmetric matrices. Those of bodies that creep as they roll are not; they are
    /// positive definite all the same, and so is their preconditioner.
    virtual bool is_symmetric() const { return true; }

    /// A[i,i] of every element on itself (mm^3/N), > 0.
    virtual std::vector<double> diagonal(Axis i) const = 0;
    /// z ~ A[i,i]^-1 r, symmetric (where A is) and positive definite; any approximation serves, even a scaled identity.
    virtual void precondition(Axis i, std::span<const double> r, std::span<double> z) const = 0;
    /// Preconditions both tangential components at once, with their coupling where an implementation knows it.
    virtual void precondition_tangential(std::span<const double> rx, std::span<const double> ry, std::span<double> zx,
                                         std::span<double> zy) const {
        precondition(Axis::x, rx, zx);
        precondition(Axis::y, ry, zy);
    }

    /// About what it takes in memory, with all that it will make when that is first needed.
    virtual std::size_t bytes() const = 0;

    /// These make solves quicker, where an operator has them, else null. Both live as long as this one.
    virtual const CoarserGrid* coarser() const { return nullptr; }
    virtual const ElementBoxes* boxes() const { return nullptr; }
};

/// The bodies on a grid of larger elements, where solvers find a first estimate.
class CoarserGrid {
   public:
    virtual ~CoarserGrid() = default;
    virtual const InfluenceOperator& influence() const = 0;
    /// How many elements a coarser one stands for, along x and along y. The last coarser ones may reach beyond.
    virtual int along_x() const = 0;
    virtual int along_y() const = 0;
    int ratio() const { return along_x() * along_y(); }
    /// Means over the elements that a coarser one stands for.
    virtual void average(std::span<const double> fine, std::span<double> coarse) const = 0;
    /// Interpolates between the centres of the coarser elements.
    virtual void interpolate(std::span<const double> coarse, std::span<double> fine) const = 0;
    /// Gives every element the value of the coarser one it belongs to.
    virtual void copy(std::span<const double> coarse, std::span<double> fine) const = 0;
};

/// The bodies on parts of the grid, for problems whose tractions vanish elsewhere: products cost less there.
class ElementBoxes {
   public:
    virtual ~ElementBoxes() = default;
    /// All elements, as a rectangle.
    virtual ElementBox extent() const = 0;
    /// A box around `needed` on which products are cheap: a little larger, so that few sizes occur, and with a margin
    /// where the contact may grow; extent() when nothing is gained.
    virtual ElementBox convenient(const ElementBox& needed, bool may_grow) const = 0;
    /// The operator on the elements of a box within extent(); its element order is that of the box. Results depend on
    /// the box alone, not on what was asked for before.
    virtual std::shared_ptr<const InfluenceOperator> influence(const ElementBox& box) const = 0;
};

/// All elements: the rectangle that they are where the operator has boxes, else a row.
inline ElementBox extent_of(const InfluenceOperator& influence) {
    const ElementBoxes* boxes = influence.boxes();
    return boxes != nullptr ? boxes->extent() : ElementBox{0, 0, static_cast<int>(influence.size()), 1};
}

}  // namespace contactd
