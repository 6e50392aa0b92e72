// Finds the parameter of a curve at which an ascending function has a value.
#pragma once

#include <cmath>

namespace contactd::geometry {

/// Holds a value and its derivative.
struct Sloped {
    double value = 0, slope = 0;
};

/// Searches by Newton's method from `s` between shrinking bounds. Sets `s` and returns true if the function meets the
/// value to 1e-10 mm, or jumps across it. `function` returns a Sloped, which ascends from `low` to `high`. If the last
/// step would be `near` or less (of s), it is left to the caller.
template <class Function>
bool find_ascending(const Function& function, double target, double low, double high, double& s, double near = 0) {
    constexpr double tolerance = 1e-10;
    constexpr int most_iterations = 60;
    if (!(high > low)) return false;
    double at = s > low ? (s < high ? s : high) : low;
    const double first = low, last = high;
    bool first_is_open = true, last_is_open = true;  // Neither end was evaluated yet.
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
        const Sloped here = function(at);
        const double excess = here.value - target;
        if (std::abs(excess) <= tolerance || std::abs(excess) <= near * here.slope) {
            s = at;
            return true;
        }
        if ((excess > 0 && at <= first) || (excess < 0 && at >= last) || std::isnan(excess)) return false;
        (excess > 0 ? high : low) = at;
        if (at >= last) last_is_open = false;
        if (at <= first) first_is_open = false;
        double next = here.slope > 0 ? at - excess / here.slope : 0.5 * (low + high);
        if (next >= last && last_is_open) {
            next = last;  // The value at the end determines whether there is a solution.
        } else if (next <= first && first_is_open) {
            next = first;
        } else if (!(next > low && next < high)) {
            next = 0.5 * (low + high);
        }
        if (next == at) break;
        at = next;
    }
    s = at;
    return high - low <= 1e-9 * (1 + std::abs(high));
}

}  // namespace contactd::geometry
