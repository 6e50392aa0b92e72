// Finds a sign change of a function of one variable.
#pragma once

#include <cmath>

namespace contactd::geometry {

/// Returns the root between `low` and `high`, where the values have different signs or one is zero, by the Illinois
/// method. It halves the interval if that converges slowly.
template <class Function>
double bracketed_root(double low, double high, double at_low, double at_high, double tolerance,
                      const Function& function) {
    if (at_low == 0) return low;
    if (at_high == 0) return high;
    for (int iteration = 0, side = 0; iteration < 200 && std::abs(high - low) > tolerance; ++iteration) {
        double middle = (low * at_high - high * at_low) / (at_high - at_low);
        if (iteration % 4 == 3 || !(middle > std::fmin(low, high) && middle < std::fmax(low, high)))
            middle = 0.5 * (low + high);
        const double value = function(middle);
        if (value == 0) return middle;
        if ((value > 0) == (at_high > 0)) {
            high = middle, at_high = value;
            if (side == 1) at_low /= 2;
            side = 1;
        } else {
            low = middle, at_low = value;
            if (side == -1) at_high /= 2;
            side = -1;
        }
    }
    return 0.5 * (low + high);
}

}  // namespace contactd::geometry
