// Which wavenumbers of coefficients between rows matter, by the distance of the rows.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <vector>

#include "midway_kernels.hpp"

namespace contactd {

/// How many distances in rows, from 0 on, matter to each group of wavenumbers, however the rows turn: large wavenumbers
/// do not reach far. What is not kept of a coefficient, and what rounding changes of it, is at most `left_out`.
class KeptDistances {
   public:
    /// A coefficient is a sum of these numbers of MidwaySymbols, times factors of at most one; null: of none.
    using Terms = std::initializer_list<const std::vector<double>*>;

    KeptDistances(const MidwaySymbols& symbols, std::initializer_list<Terms> coefficients, double left_out);

    bool rounded() const { return rounded_; }
    /// Returns how many rows before row I matter to a group, itself counted.
    std::size_t of(std::size_t group) const { return kept_[group]; }

   private:
    std::vector<std::size_t> kept_;
    bool rounded_ = false;
};

}  // namespace contactd
