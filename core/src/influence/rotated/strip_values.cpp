#include "influence/rotated/strip_values.hpp"

#include <cmath>
#include <numbers>

#include "influence/half_space_model.hpp"

namespace contactd {
NineValues nine_values(const KernelIntegrals& integrals, double nu) {
    using enum Axis;
    HalfSpaceModel model(LoadShape::constant);
    model.a = 1 - nu;
    model.b = nu;
    model.c = 1 - 2 * nu;
    const double xs = model.coefficient(x, y, integrals), xn = model.coefficient(x, z, integrals),
                 sn = model.coefficient(y, z, integrals);
    const double nn = (1 - nu) * (integrals.xx + integrals.yy) / (2 * std::numbers::pi);
    return {model.coefficient(x, x, integrals), xs, xn, xs, model.coefficient(y, y, integrals), sn, -xn, -sn, nn};
}

StripView view_of(std::span<const StripFrame> frames, double ds, double perimeter, int observed, int loaded) {
    const double turn =
        frames[static_cast<std::size_t>(observed)].angle - frames[static_cast<std::size_t>(loaded)].angle;
    const double s = (observed - loaded) * ds;
    if (perimeter == 0 || std::abs(s) <= perimeter / 2) return {s, turn};
    return {std::remainder(s, perimeter), turn - std::copysign(2 * std::numbers::pi, turn)};
}

}  // namespace contactd
