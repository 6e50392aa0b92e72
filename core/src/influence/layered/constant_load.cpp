#include <algorithm>

#include "influence/layered/load_integrals.hpp"

namespace contactd {
namespace {

using Kernel = RadialFunction::Kernel;

constexpr std::array<RadialFunction, 4> functions{
    RadialFunction{[](const WaveCompliance& wave) { return wave.c; }, 1, Kernel::J1},               // D
    RadialFunction{[](const WaveCompliance& wave) { return wave.a - wave.d; }, 1, Kernel::J1},      // E
    RadialFunction{[](const WaveCompliance& wave) { return wave.d; }, 1, Kernel::J1},               // F
    RadialFunction{[](const WaveCompliance& wave) { return wave.b; }, 1, Kernel::J0_regularised}};  // Phi

}  // namespace

/// Holds sums along an edge, with n the axis across it and s the one along it.
struct ConstantLoad::EdgeSums {
    double D = 0, F = 0, E = 0;  ///< times n/rho
    double E_along = 0;          ///< E s/rho
    double Phi = 0;
};

ConstantLoad::ConstantLoad(const Layers& body, double least, double largest)
    : least_(least), radial_(body, functions, least, largest), rule_(least) {}

ConstantLoad::EdgeSums ConstantLoad::sums(double across, double from, double to) const {
    EdgeSums edge;
    rule_.along(across, from, to, [&](double t, double rho, double weight) {
        const auto [D, E, F, Phi] = radial_.at(rho);
        const double per_rho = weight / std::max(rho, least_);
        edge.D += per_rho * across * D;
        edge.F += per_rho * across * F;
        edge.E += per_rho * across * E;
        edge.E_along += per_rho * t * E;
        edge.Phi += weight * Phi;
    });
    return edge;
}

std::vector<SurfaceCoefficients> ConstantLoad::at(const OffsetLattice& offsets, const Observer& observer) const {
    const EdgeLines lines(offsets, LoadShape::constant);
    std::vector<SurfaceCoefficients> result(offsets.index(0, offsets.ny));
    std::vector<EdgeSums> below, above;  // for the edges y = constant of a row
    const auto fill_row = [&](int j) {
        above.clear();
        for (int k = 0; k < offsets.nx; ++k) {
            const auto i = static_cast<std::size_t>(k);
            above.push_back(sums(lines.y[static_cast<std::size_t>(j)], lines.x[i], lines.x[i + 1]));
        }
    };
    fill_row(0);
    for (int l = 0; l < offsets.ny; ++l) {
        observer.throw_if_cancelled();
        std::swap(below, above);
        fill_row(l + 1);
        const auto j = static_cast<std::size_t>(l);
        EdgeSums right = sums(lines.x[0], lines.y[j], lines.y[j + 1]);
        for (int k = 0; k < offsets.nx; ++k) {
            const auto i = static_cast<std::size_t>(k);
            const EdgeSums left = right;
            right = sums(lines.x[i + 1], lines.y[j], lines.y[j + 1]);
            SurfaceCoefficients& at = result[offsets.index(k, l)];
            const double both = (right.F - left.F) + (above[i].F - below[i].F);
            at.zz = (right.D - left.D) + (above[i].D - below[i].D);
            at.xx = both + (right.E - left.E);
            at.yy = both + (above[i].E - below[i].E);
            at.xy = above[i].E_along - below[i].E_along;
            at.xz = left.Phi - right.Phi;
            at.yz = below[i].Phi - above[i].Phi;
        }
    }
    return result;
}

}  // namespace contactd
