// Computes the inverse of a convolution with an addition to its diagonal, as if the grid were periodic.
#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <utility>

#include "contactd/step_operator.hpp"
#include "influence/shifted_table.hpp"
#include "padded_fft.hpp"
#include "tangential_symbols.hpp"

namespace contactd {

/// Creates inverses of one table, and keeps the last few. It is safe to use from several threads at once.
class PeriodicInverses {
   public:
    explicit PeriodicInverses(const ShiftedTable& table);

    std::shared_ptr<const StepInverse> get(double added) const;

   private:
    class Inverse;

    TangentialSymbols inverted(double added) const;

    static constexpr std::size_t most_cached = 4;
    std::shared_ptr<const PaddedFft> fft_;
    const TangentialSymbols symbols_;  // of the table
    mutable std::mutex mutex_;
    mutable std::deque<std::pair<double, std::shared_ptr<const StepInverse>>> cache_;  // sorted from oldest to newest
};

}  // namespace contactd
