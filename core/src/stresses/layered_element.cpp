// With c, s the direction cosines of the wave vector, n and t the stresses in its plane under normal and tangential
// unit tractions, q = yz and r = xy those across it, the transforms of stresses under a load along z are
//   zz  n_zz                      xx  n_yy + c^2 (n_xx - n_yy)    yy  n_yy + s^2 (n_xx - n_yy)
//   xy  c s (n_xx - n_yy)         xz  -i c n_xz                   yz  -i s n_xz
// and under one along x, with h = t_xx - t_yy - 2 r,
//   zz  i c t_zz                  xx  i c (t_yy + 2 r + c^2 h)    yy  i c (t_xx - 2 r - c^2 h)
//   xy  i s (r + c^2 h)           xz  q + c^2 (t_xz - q)          yz  c s (t_xz - q)
// Those under a load along y follow by exchanging x and y. i c/k and i s/k are derivatives; c^2 is (J_0 - cos 2 theta
// J_2)/2 in space.
#include "layered_element.hpp"

#include <cmath>

namespace contactd {

using enum StressRadial::Function;

LayeredElement::LayeredElement(const StressWaves& waves, double largest)
    : radials_(waves, largest), rule_(waves.scale()) {}

void LayeredElement::add(const StressRadial::Values& values, double cos, double sin, double weight,
                         EdgeSums& sums) const {
    for (std::size_t f = 0; f < sums.x.size(); ++f) {
        sums.x[f] += weight * cos * values[f];
        sums.y[f] += weight * sin * values[f];
    }
    for (std::size_t f = normal_xz; f < third; ++f) sums.scalar[f] += weight * values[f];
    sums.scalar[third] += weight * (cos * cos - sin * sin) * values[third];
}

LayeredElement::EdgeSums LayeredElement::across_x(double x, double from, double to) const {
    EdgeSums sums;
    rule_.along(x, from, to,
                [&](double y, double rho, double weight) { add(radials_.at(rho), x / rho, y / rho, weight, sums); });
    return sums;
}

LayeredElement::EdgeSums LayeredElement::across_y(double y, double from, double to) const {
    EdgeSums sums;
    rule_.along(y, from, to,
                [&](double x, double rho, double weight) { add(radials_.at(rho), x / rho, y / rho, weight, sums); });
    return sums;
}

// Stresses are xx, yy, zz, xy, xz, yz.
ElementStresses LayeredElement::stresses(const EdgeSums& left, const EdgeSums& right, const EdgeSums& bottom,
                                         const EdgeSums& top) {
    const auto d_x = [&](auto member, std::size_t f) { return (right.*member)[f] - (left.*member)[f]; };
    const auto d_y = [&](auto member, std::size_t f) { return (top.*member)[f] - (bottom.*member)[f]; };
    constexpr auto x = &EdgeSums::x, y = &EdgeSums::y;
    constexpr auto scalar = &EdgeSums::scalar;
    const auto divergence = [&](std::size_t f) { return d_x(x, f) + d_y(y, f); };

    const double normal_rest = divergence(normal_yy), shear_rest = divergence(across_yz);
    const double shear_mixed = d_x(y, shear_difference);
    // These are parts of c^2 h, by sides across x and across y.
    const auto h = [&](const auto& d) { return d(scalar, shear_xx) - d(scalar, shear_yy) - 2 * d(scalar, across_xy); };
    const double h_x = h(d_x) / 2, h_y = h(d_y) / 2, third_x = d_x(scalar, third) / 2, third_y = d_y(scalar, third) / 2;
    const double r_x = d_x(scalar, across_xy), r_y = d_y(scalar, across_xy);
    return {StressComponents{d_x(scalar, shear_yy) + 2 * r_x + h_x - third_x,
                             d_x(scalar, shear_xx) - 2 * r_x - h_x + third_x, d_x(scalar, shear_zz),
                             r_y + h_y - third_y, shear_rest + d_x(x, shear_difference), shear_mixed},
            StressComponents{d_y(scalar, shear_xx) - 2 * r_y - h_y - third_y,
                             d_y(scalar, shear_yy) + 2 * r_y + h_y + third_y, d_y(scalar, shear_zz),
                             r_x + h_x + third_x, shear_mixed, shear_rest + d_y(y, shear_difference)},
            StressComponents{normal_rest + d_x(x, normal_difference), normal_rest + d_y(y, normal_difference),
                             divergence(normal_zz), d_x(y, normal_difference), -d_x(scalar, normal_xz),
                             -d_y(scalar, normal_xz)}};
}

std::vector<ElementStresses> LayeredElement::at(const OffsetLattice& offsets, const Observer& observer) const {
    const EdgeLines lines(offsets, LoadShape::constant);
    const auto nx = static_cast<std::size_t>(offsets.nx), ny = static_cast<std::size_t>(offsets.ny);
    const auto row_line = [&](std::size_t j) {
        std::vector<EdgeSums> line;
        for (std::size_t i = 0; i < nx; ++i) line.push_back(across_y(lines.y[j], lines.x[i], lines.x[i + 1]));
        return line;
    };
    std::vector<ElementStresses> result;
    result.reserve(nx * ny);
    std::vector<EdgeSums> below = row_line(0);
    for (std::size_t j = 0; j < ny; ++j) {
        observer.throw_if_cancelled();
        const std::vector<EdgeSums> above = row_line(j + 1);
        EdgeSums left = across_x(lines.x[0], lines.y[j], lines.y[j + 1]);
        for (std::size_t i = 0; i < nx; ++i) {
            const EdgeSums right = across_x(lines.x[i + 1], lines.y[j], lines.y[j + 1]);
            result.push_back(stresses(left, right, below[i], above[i]));
            left = right;
        }
        below = above;
    }
    return result;
}

}  // namespace contactd
