// Computes smooth values along a row of elements from those at a few of its points.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace contactd::geometry {

/// Holds Chebyshev's points from the first element to the last one, and the polynomial through them.
class RowNodes {
   public:
    static constexpr std::size_t count = 8;
    using Values = std::array<double, count>;

    /// Computes the nodes of n >= 2 elements from x0 on (mm).
    RowNodes(double x0, double dx, int n);

    const Values& x() const { return x_; }
    /// Returns whether the polynomial has settled: its highest terms are below `settled`. Returns false if a value is
    /// NaN.
    static bool smooth(const Values& values, double settled);
    /// Appends the values of all elements.
    void interpolate(const Values& values, std::vector<double>& row) const;

   private:
    Values x_;
    std::vector<Values> weights_;  // weights of the nodes, for each element
};

}  // namespace contactd::geometry
