// Selects the significant wavenumbers of coefficients between rows, by the distance of the rows.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <vector>

#include "midway_kernels.hpp"

namespace contactd {

/// Determines, for each group of wavenumbers, the number of significant distances in rows, from 0 on, whatever the
/// rotation of the rows: large wavenumbers decay quickly. Omitted and rounded parts change a coefficient by at most
/// `left_out`.
class KeptDistances {
   public:
    /// A coefficient is a sum of these numbers of MidwaySymbols, times factors of at most one; null means no
    /// contribution.
    using Terms = std::initializer_list<const std::vector<double>*>;

    KeptDistances(const MidwaySymbols& symbols, std::initializer_list<Terms> coefficients, double left_out);

    bool rounded() const { return rounded_; }
    /// Returns the number of significant rows before row I for a group, including I.
    std::size_t of(std::size_t group) const { return kept_[group]; }

   private:
    std::vector<std::size_t> kept_;
    bool rounded_ = false;
};

}  // namespace contactd
