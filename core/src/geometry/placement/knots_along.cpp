#include "geometry/placement/knots_along.hpp"

#include <algorithm>

namespace contactd::geometry {

std::size_t KnotsAlong::wrapped(std::ptrdiff_t knot) const {
    const auto count = static_cast<std::ptrdiff_t>(knots_.size());
    return static_cast<std::size_t>(((knot % count) + count) % count);
}

double KnotsAlong::place(std::ptrdiff_t knot) const {
    const auto within = static_cast<std::ptrdiff_t>(wrapped(knot));
    const auto periods = static_cast<double>((knot - within) / static_cast<std::ptrdiff_t>(knots_.size()));
    return knots_[static_cast<std::size_t>(within)] + periods * period_;
}

double KnotsAlong::support(std::ptrdiff_t piece) const {
    constexpr double much = 2, none = 4;
    double beside = 0;
    for (const std::ptrdiff_t other : {piece - 1, piece + 1})
        if (exists(other)) beside = std::max(beside, width(other));
    if (beside == 0) return 1;
    return std::clamp((none - width(piece) / beside) / (none - much), 0.0, 1.0);
}

}  // namespace contactd::geometry
