// Shares coefficients between strips, and the products on parts of their grid, among operators.
#pragma once

#include <cstddef>
#include <memory>

#include "contactd/strip_table.hpp"
#include "operators/cached_boxes.hpp"
#include "strip_products.hpp"

namespace contactd {

/// Objects are safe to use from several threads at once.
class StripParts {
   public:
    /// Creates the products of a grid of nx elements along each strip. Products read up to reach() elements ahead.
    /// Throws InvalidArgument if there are fewer offsets than nx. `left_out` is as for StripProducts.
    StripParts(std::shared_ptr<const StripCoefficients> coefficients, int nx,
               OffsetParity parity = OffsetParity::natural, double left_out = 0);
    /// Uses the coefficients of a table.
    StripParts(StripTable table, int nx, OffsetParity parity = OffsetParity::natural, double left_out = 0);

    ElementBox extent() const { return {0, 0, nx_, coefficients_->strips()}; }
    /// Returns the number of offsets along x beyond those of the grid.
    int reach() const { return coefficients_->offsets() - nx_; }
    bool coupled() const { return coefficients_->coupled(); }
    double left_out() const { return left_out_; }
    double self(Axis i, int strip) const { return coefficients_->self(i, strip); }
    /// Returns the products on a box, whose position along x does not matter. Those of the last few boxes are cached.
    std::shared_ptr<const StripProducts> on(const ElementBox& box) const;
    /// Returns the approximate memory of coefficients, symbols, and those of some boxes.
    std::size_t bytes() const { return coefficients_->bytes(); }

    /// Returns the parts of StripCoefficients::coarse.
    std::shared_ptr<const StripParts> coarse(const ElementBox& box, int along_x, int along_y) const;

   private:
    const std::shared_ptr<const StripCoefficients> coefficients_;
    const int nx_;
    const OffsetParity parity_;
    const double left_out_;
    mutable CachedBoxes<StripProducts> cache_;
};

}  // namespace contactd
