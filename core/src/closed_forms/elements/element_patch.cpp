#include "element_patch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "printed_coefficients.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

// The height of an ellipse's paraboloid is twice the mean, and that of Hertz's pressure 3/2 of the mean.
void make_parabolic(const EllipticContact& contact, std::vector<double>& pressure) {
    const double p0 = contact.pmax(), factor = 4.0 / 3 / p0;
    for (double& p : pressure) p *= factor * p;
}

}  // namespace

std::optional<SemiAxes> equivalent_ellipse(const Grid& grid, const std::vector<double>& values) {
    std::vector<bool> columns(static_cast<std::size_t>(grid.nx));
    std::size_t elements = 0, rows = 0, i = 0;
    for (int iy = 0; iy < grid.ny; ++iy) {
        const std::size_t before = elements;
        for (int ix = 0; ix < grid.nx; ++ix, ++i) {
            if (!(values[i] > 0)) continue;
            ++elements;
            columns[static_cast<std::size_t>(ix)] = true;
        }
        rows += elements > before;
    }
    if (elements == 0) return {};
    const double length = static_cast<double>(std::ranges::count(columns, true)) * grid.dx;
    const double width = static_cast<double>(rows) * grid.dy;
    const double mean = static_cast<double>(elements) * grid.element_area() / std::numbers::pi;
    return SemiAxes{std::sqrt(mean * length / width), std::sqrt(mean * width / length)};
}

ElementPatch patch_of(const Grid& grid, const EllipticContact& contact, TractionBound bound) {
    ElementPatch patch;
    patch.bound.resize(grid.size());
    patch.combined = contact.combined;
    if (contact.empty()) return patch;
    patch.bound = hertz_pressure(grid, contact);
    patch.axes = contact.axes;
    patch.counted = equivalent_ellipse(grid, patch.bound).value_or(contact.axes);
    patch.Fn = contact.Fn;
    patch.area = contact.area();
    if (bound == TractionBound::parabolic) make_parabolic(contact, patch.bound);
    return patch;
}

ElementPatch patch_of(const Grid& grid, const std::vector<double>& pressure, const Material& combined) {
    ElementPatch patch;
    patch.bound = pressure;
    patch.combined = combined;
    const auto ellipse = equivalent_ellipse(grid, pressure);
    if (!ellipse) return patch;
    patch.axes = patch.counted = *ellipse;
    for (const double p : pressure) {
        patch.Fn += p * grid.element_area();
        if (p > 0) patch.area += grid.element_area();
    }
    return patch;
}

KalkerCoefficients coefficients_of(const SemiAxes& rolling, double nu, CreepageCoefficients from) {
    const double ratio = rolling.a / rolling.b;
    if (!has_kalker_coefficients(ratio))
        throw InvalidArgument(
            "gap", "results in a contact ellipse with semi-axes of " + number_text(rolling.a) + " mm along and " +
                       number_text(rolling.b) + " mm across the rolling direction, a ratio of " + number_text(ratio) +
                       "; simplified models have Kalker's coefficients for ratios of 1/32 to 32: use model "
                       "full");
    return from == CreepageCoefficients::printed ? printed_coefficients(ratio, nu) : kalker_coefficients(ratio, nu);
}

}  // namespace contactd
