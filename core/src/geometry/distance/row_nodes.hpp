// Values along a row of elements from those at a few points of it, where they are smooth.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace contactd::geometry {

/// Chebyshev's points from the first element to the last one, and the polynomial through them.
class RowNodes {
   public:
    static constexpr std::size_t count = 8;
    using Values = std::array<double, count>;

    /// Takes the nodes of n >= 2 elements from x0 on (mm).
    RowNodes(double x0, double dx, int n);

    const Values& x() const { return x_; }
    /// Tells if the polynomial has settled: its highest parts are below `settled`; not where a value is not a number.
    static bool smooth(const Values& values, double settled);
    /// Appends the values of all elements.
    void interpolate(const Values& values, std::vector<double>& row) const;

   private:
    Values x_;
    std::vector<Values> weights_;  // of the nodes, for each element
};

}  // namespace contactd::geometry
