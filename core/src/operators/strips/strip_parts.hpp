// A strip table with the products on parts of its grid, for the operators that share them.
#pragma once

#include <cstddef>
#include <memory>

#include "operators/cached_boxes.hpp"
#include "strip_products.hpp"

namespace contactd {

/// Safe to use from several threads at once.
class StripParts {
   public:
    /// Makes the products of a grid of nx elements along each strip. Products read up to table.nx - nx elements ahead.
    /// Throws InvalidArgument where the table has fewer offsets than nx. `left_out` is as for StripProducts.
    StripParts(StripTable table, int nx, OffsetParity parity = OffsetParity::natural, double left_out = 0);

    const StripTable& table() const { return *table_; }
    ElementBox extent() const { return {0, 0, nx_, table_->strips}; }
    /// A[i,z] and A[z,i] of the tangential i beyond coupling_tolerance.
    bool coupled() const { return coupled_; }
    double left_out() const { return left_out_; }
    /// Where the box lies along x does not matter. Those of the last few boxes are cached.
    std::shared_ptr<const StripProducts> on(const ElementBox& box) const;
    /// About what all takes in memory: table, symbols, and those of some boxes.
    std::size_t bytes() const;
    static std::size_t bytes_of(int nx, int strips);

    /// Returns the table of elements of along_x x along_y: mean displacements over one for a unit traction on another.
    /// The last may reach beyond the grid, where the surface goes on as it is before.
    StripTable coarse(const ElementBox& box, int along_x, int along_y) const;

   private:
    std::shared_ptr<const StripTable> table_;
    int nx_;
    OffsetParity parity_;
    bool coupled_;
    double left_out_;
    mutable CachedBoxes<StripProducts> cache_;
};

}  // namespace contactd
