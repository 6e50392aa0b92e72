#include "kept_distances.hpp"

#include <algorithm>
#include <cmath>

namespace contactd {

KeptDistances::KeptDistances(const MidwaySymbols& symbols, std::initializer_list<Terms> coefficients, double left_out)
    : kept_(symbols.groups(), left_out > 0 ? 1 : symbols.rows) {
    if (left_out <= 0) return;
    constexpr std::size_t lanes = Waves::lanes;
    double largest = 0;
    for (const Terms& terms : coefficients) {
        std::vector<double> beyond(symbols.rows);  // sums over the wavenumbers of both signs, from the largest ones on
        for (std::size_t group = kept_.size(); group > 0; --group)
            for (std::size_t row = 0; row < symbols.rows; ++row) {
                const std::size_t first = ((group - 1) * symbols.rows + row) * lanes;
                for (const std::vector<double>* numbers : terms)
                    for (std::size_t lane = 0; numbers != nullptr && lane < lanes; ++lane)
                        beyond[row] += 2 * std::abs((*numbers)[first + lane]);
                if (beyond[row] > 0.5 * left_out) kept_[group - 1] = std::max(kept_[group - 1], row + 1);
            }
        largest = std::max(largest, *std::max_element(beyond.begin(), beyond.end()));
    }
    rounded_ = SymbolNumbers::may_be_rounded(largest, left_out);
}

}  // namespace contactd
