#include "outline.hpp"

#include <cmath>
#include <numeric>

namespace contactd::fem {

double length_of(const OutlineLoop& loop) {
    return std::accumulate(loop.begin(), loop.end(), 0.0,
                           [](double sum, const OutlinePiece& piece) { return sum + piece.length; });
}

OutlinePosition position_at(const SectionOutline& outline, std::size_t loop, double s) {
    const OutlineLoop& pieces = outline.loops[loop];
    const double length = length_of(pieces), rounding = 1e-9 * length;
    s -= length * std::floor((s + rounding) / length);
    for (std::size_t piece = 0; piece < pieces.size(); ++piece) {
        if (s < pieces[piece].length - rounding || piece + 1 == pieces.size()) return {loop, piece, std::fmax(s, 0)};
        s -= pieces[piece].length;
    }
    return {};
}

OutlinePiece straight(const PlanePoint& from, const PlanePoint& to, bool clamped) {
    const double length = std::hypot(to.y - from.y, to.z - from.z);
    const PlanePoint along{(to.y - from.y) / length, (to.z - from.z) / length};
    return {length, clamped, [=](double s) { return PlanePoint{from.y + s * along.y, from.z + s * along.z}; },
            [=](double) { return PlanePoint{-along.z, along.y}; }};
}

OutlinePiece arc(const PlanePoint& centre, double radius, double from, double turn, bool clamped) {
    const double sense = turn > 0 ? 1 : -1;
    const auto angle = [=](double s) { return from + sense * s / radius; };
    return {radius * std::abs(turn), clamped,
            [=](double s) {
                return PlanePoint{centre.y + radius * std::cos(angle(s)), centre.z + radius * std::sin(angle(s))};
            },
            // The body lies on the right, which is inside an arc that turns clockwise.
            [=](double s) { return PlanePoint{-sense * std::cos(angle(s)), -sense * std::sin(angle(s))}; }};
}

}  // namespace contactd::fem
