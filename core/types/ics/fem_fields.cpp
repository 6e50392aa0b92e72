#include "contactd/fem_fields.hpp"

#include <algorithm>
#include <cmath>

namespace contactd::fem_rules {
namespace {

bool is_whole(double value) {
    return std::abs(value - std::round(value)) < 1e-9 * std::max(1.0, std::abs(value));
}

bool is_even(double value) {
    return std::isfinite(value) && value >= 2 && is_whole(value / 2);
}

}  // namespace

const char* h_over_hs(const FemSpec& fem, LoadShape) {
    return is_even(fem.h_over_hs) ? nullptr : "be an even integer, so that the load's edge lies on element faces";
}

const char* l_over_h(const FemSpec& fem, LoadShape load) {
    if (!is_even(fem.h_over_hs)) return nullptr;  // The number must be corrected first.
    if (load == LoadShape::constant && !(std::isfinite(fem.l_over_h) && fem.l_over_h >= 0.5))
        return "be at least 0.5, so that the cube holds the load";
    if (load == LoadShape::bilinear && !(std::isfinite(fem.l_over_h) && fem.l_over_h >= 1))
        return "be at least 1, so that the cube holds the bilinear load";
    const double m = fem.l_over_h * fem.h_over_hs;
    if (!is_whole(m)) return "make l_over_h * h_over_hs an integer, so that the load's edge lies on element faces";
    return m <= 1000 ? nullptr : "keep l_over_h * h_over_hs, the elements per edge, below 1000";
}

const char* t1_over_hs(const FemSpec& fem, LoadShape) {
    const double t1 = fem.t1_over_hs;
    return t1 == 0 || (t1 >= 1e-3 && t1 <= 1e3) ? nullptr : "lie in [0.001, 1000], or be 0 for f";
}

const char* L_over_h(const FemSpec& fem, LoadShape) {
    return std::isfinite(fem.L_over_h) && fem.L_over_h > fem.l_over_h && fem.L_over_h <= 1e9
               ? nullptr
               : "be larger than l_over_h and at most 1e9";
}

}  // namespace contactd::fem_rules
