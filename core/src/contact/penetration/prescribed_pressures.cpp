#include "prescribed_pressures.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <variant>

#include "closed_forms/undeformed_distance.hpp"

namespace contactd {
PenetrationContact prescribed_contact(const ContactProblem& problem) {
    const Grid& grid = problem.grid;
    const HertzContact ellipse = hertz_of(problem);
    const auto* given = std::get_if<HalfEllipses>(&*problem.gap);
    const HalfEllipses halves = given ? *given : HalfEllipses{ellipse.a, ellipse.b, ellipse.b};
    PenetrationContact contact;
    contact.evidence.converged = true;
    contact.approach = ellipse.approach;
    contact.pressure.resize(grid.size());
    if (!(ellipse.a > 0 && ellipse.b > 0 && ellipse.Fn > 0)) return contact;
    const bool parabolic = problem.normal_model == NormalModel::parabolic;
    const double p0 = (parabolic ? 2 : 1.5) * ellipse.Fn / (std::numbers::pi * ellipse.a * ellipse.b);
    for (int iy = 0; iy < grid.ny; ++iy) {
        const double y = grid.y(iy) - halves.joint(), s = y / (y > 0 ? halves.b_positive : halves.b_negative);
        double* row = &contact.pressure[static_cast<std::size_t>(iy) * static_cast<std::size_t>(grid.nx)];
        for (int ix = 0; ix < grid.nx; ++ix) {
            const double x = grid.x(ix) / ellipse.a, e = 1 - x * x - s * s;
            if (e > 0) row[ix] = p0 * (parabolic ? e : std::sqrt(e));
        }
    }
    for (const double p : contact.pressure) {
        contact.Fn += p * grid.element_area();
        contact.pmax = std::max(contact.pmax, p);
    }
    return contact;
}

}  // namespace contactd
