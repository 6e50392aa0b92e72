// Integrates functions of the distance from the origin along the edges of elements.
#pragma once

#include <cmath>
#include <vector>

#include "influence/layered/gauss_legendre.hpp"

namespace contactd {

/// Distributes Gauss points along a straight edge, as many as its distance from the origin requires.
class EdgeRule {
   public:
    /// Smaller distances are replaced by `least`.
    explicit EdgeRule(double least) : least_(least), near_(gauss_legendre(14)), far_(gauss_legendre(7)) {}

    /// Integrates over an edge at `across` from `from` to `to` along it: calls `visit` with the coordinate along it,
    /// the distance from the origin, and the weight.
    template <class Visit>
    void along(double across, double from, double to, const Visit& visit) const {
        if (from < 0 && to > 0) {
            along(across, from, 0, visit);
            along(across, 0, to, visit);
            return;
        }
        const double length = to - from, closest = std::hypot(across, std::min(std::abs(from), std::abs(to)));
        if (closest < length && length > least_) {  // The functions change on the scale of the distance.
            const double middle = from + length / 2;
            along(across, from, middle, visit);
            along(across, middle, to, visit);
            return;
        }
        for (const auto& [node, weight] : closest < 4 * length ? near_ : far_) {
            const double t = from + node * length;
            visit(t, std::sqrt(across * across + t * t), weight * length);
        }
    }

   private:
    double least_;
    std::vector<GaussPoint> near_, far_;
};

}  // namespace contactd
