#include "contactd/strip_memory.hpp"

#include <algorithm>
#include <cmath>

namespace contactd {
namespace {

// These are numbers for each pair, measured as the growth of a daemon, for making tables and for products.
constexpr double of_one_table = 27, of_each_further = 15;
constexpr double of_products = 27, of_whole_steps = 33, of_fractional_steps = 52;

// These are the bytes of rotated half-spaces, measured as the growth of a process, for 1,000 to 28,000 elements in 34
// to 146 rows.
constexpr double of_rotated_patch = 32e6, of_rotated_element = 2000, of_rotated_pair = 40;

}  // namespace

StripRolling strip_rolling(double elements) {
    constexpr double rounding = 1e-9;
    if (elements == 0) return StripRolling::none;
    return std::abs(elements - std::round(elements)) <= rounding ? StripRolling::whole : StripRolling::fractional;
}

double strip_bytes(double pairs, int tables, StripRolling step) {
    if (tables <= 0) return 0;
    const double making = of_one_table + of_each_further * (tables - 1);
    const double using_them = step == StripRolling::fractional ? of_fractional_steps
                              : step == StripRolling::whole    ? of_whole_steps
                                                               : of_products;
    return sizeof(double) * pairs * std::max(making, using_them);
}

double rotated_bytes(double elements, double pairs) {
    return of_rotated_patch + elements * of_rotated_element + pairs * of_rotated_pair;
}

}  // namespace contactd
