#include "influence/layered/layered_table.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "influence/layered/load_integrals.hpp"

namespace contactd {
namespace {

// `shift` < 1 moves the octaves of the radial functions, and with them all points at which they are computed.
std::vector<SurfaceCoefficients> coefficients(const Layers& body, LoadShape load_shape, const EdgeLines& lines,
                                              double shift, const std::vector<OffsetLattice>& lattices,
                                              const Observer& observer) {
    std::vector<SurfaceCoefficients> result;
    const auto compute = [&](const auto& load) {
        for (const OffsetLattice& offsets : lattices) {
            const auto some = load.at(offsets, observer);
            result.insert(result.end(), some.begin(), some.end());
        }
    };
    if (load_shape == LoadShape::constant)
        compute(ConstantLoad(body, lines.least * shift, lines.largest));
    else
        compute(BilinearLoad(body, lines.least * shift, lines.largest));
    return result;
}

}  // namespace

std::vector<SurfaceCoefficients> layered_coefficients(const Layers& body, LoadShape load_shape,
                                                      const OffsetLattice& offsets, const Observer& observer) {
    return coefficients(body, load_shape, EdgeLines(offsets, load_shape), 1, {offsets}, observer);
}

IcTable layered_table(const Layers& body, LoadShape load_shape, int nx, int ny, double dx, double dy,
                      const Observer& observer) {
    const OffsetLattice offsets{.nx = nx, .ny = ny, .dx = dx, .dy = dy};
    const auto values = layered_coefficients(body, load_shape, offsets, observer);
    IcTable table(nx, ny);
    using enum Axis;
    for (int l = 0; l < ny; ++l)
        for (int k = 0; k < nx; ++k) {
            SurfaceCoefficients at = values[offsets.index(k, l)];
            if (k == 0) at.xz = at.xy = 0;  // These are odd.
            if (l == 0) at.yz = at.xy = 0;
            table(x, x, k, l) = at.xx;
            table(y, y, k, l) = at.yy;
            table(z, z, k, l) = at.zz;
            table(x, y, k, l) = table(y, x, k, l) = at.xy;
            table(x, z, k, l) = at.xz;
            table(z, x, k, l) = -at.xz;
            table(y, z, k, l) = at.yz;
            table(z, y, k, l) = -at.yz;
        }
    return table;
}

IcErrors layered_errors(const Layers& body, LoadShape load_shape, const IcTable& table, double dx, double dy) {
    constexpr double octave_shift = 0.7, margin = 3, rounding = 1e-13;
    const OffsetLattice all{.nx = table.nx, .ny = table.ny, .dx = dx, .dy = dy};
    std::vector<std::pair<int, int>> places;
    for (const int l : {0, 1, table.ny / 2, table.ny - 1})
        for (const int k : {0, 1, table.nx / 2, table.nx - 1})
            if (k < table.nx && l < table.ny) places.emplace_back(k, l);
    std::vector<OffsetLattice> lattices;
    for (const auto& [k, l] : places) lattices.push_back({k * dx, l * dy, 1, 1, dx, dy});
    const auto again = coefficients(body, load_shape, EdgeLines(all, load_shape), octave_shift, lattices, {});

    using enum Axis;
    const Layer& top = body.layers.front();
    const double scale = std::max(table(z, z, 0, 0), 1e-3 * top.thickness / top.G);
    IcErrors errors{
        .xx = ComponentError{}, .yy = ComponentError{}, .zz = ComponentError{}, .scaled_xy = 0, .scaled_xz = 0};
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto& [k, l] = places[i];
        const SurfaceCoefficients& other = again[i];
        const auto relative = [&](Axis axis, double value, ComponentError& error) {
            const double difference = margin * (table(axis, axis, k, l) - value) / scale;
            if (k == 0 && l == 0) error.origin = difference;
            error.largest = std::max({error.largest, std::abs(difference), rounding});
        };
        relative(x, other.xx, *errors.xx);
        relative(y, other.yy, *errors.yy);
        relative(z, other.zz, *errors.zz);
        const double unit = margin * 2 * std::numbers::pi * top.G * std::hypot(k * dx, l * dy) / (dx * dy);
        const auto scaled = [&](Axis axis, Axis load, double value, double& error) {
            error = std::max(error, unit * std::abs(table(axis, load, k, l) - value));
        };
        scaled(x, y, other.xy, *errors.scaled_xy);
        scaled(x, z, other.xz, *errors.scaled_xz);
        scaled(y, z, other.yz, *errors.scaled_xz);
    }
    return errors;
}

}  // namespace contactd
