// Computes the increment of displacements in a step of rolling: the difference between those at the elements and one
// step ahead.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "contactd/element_box.hpp"

namespace contactd {

/// Approximates z = (C + added)^-1 r for both tangential components at once, where an amount > 0 (mm^3/N) is added to
/// the diagonal; any approximation is allowed. It is safe to use from several threads at once.
class StepInverse {
   public:
    virtual ~StepInverse() = default;
    virtual void tangential(std::span<const double> rx, std::span<const double> ry, std::span<double> zx,
                            std::span<double> zy) const = 0;
};

/// C = A - A', where A' gives the displacements at the points one step ahead of the elements. Spans have size()
/// entries, in the element order of the grid. Implementations are safe to use from several threads at once.
class StepOperator {
   public:
    virtual ~StepOperator() = default;
    virtual std::size_t size() const = 0;
    /// Computes (ux, uy) = [[C_xx, C_xy], [C_yx, C_yy]] (px, py).
    virtual void tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                            std::span<double> uy) const = 0;
    /// Returns false if C_xz and C_yz are negligible; tangential_of_normal then returns zeros.
    virtual bool coupled() const = 0;
    /// Computes ux = C_xz pz and uy = C_yz pz.
    virtual void tangential_of_normal(std::span<const double> pz, std::span<double> ux, std::span<double> uy) const = 0;
    /// Returns the approximate memory, including the parts that are created on first use.
    virtual std::size_t bytes() const = 0;

    /// Returns an inverse that makes solves on many elements faster, or null if unavailable.
    virtual std::shared_ptr<const StepInverse> inverse(double /*added*/) const { return nullptr; }
    /// Returns the step on the elements of a box, as ElementBoxes::influence, or null if unavailable.
    virtual std::shared_ptr<const StepOperator> on(const ElementBox& /*box*/) const { return nullptr; }
    /// Returns the step (in mm) on the grid of InfluenceOperator::coarser(), or null. It lives as long as this
    /// operator.
    virtual const StepOperator* coarser() const { return nullptr; }
};

}  // namespace contactd
