// Sets the potential contact area and the undeformed distance.
#include <algorithm>
#include <array>
#include <cmath>

#include "given/given_area.hpp"
#include "interface/entry.hpp"
#include "problem/area.hpp"

using namespace contactd;
using namespace contactd::cntc;

namespace {

/// Sets the elements of all patches together, because patches have no numbers before they are found.
void set_rail_elements(const int* ire, const int* icp, const int* ipotcn, const int* nparam, const double* rparam) {
    set_rail("cntc_setpotcontact", ire, "potential contact", [&](RailSettings& rail, const Units& units) {
        if (number_of(icp) > 0)
            throw Refused(error_code::handle,
                          "All patches of a wheel on a rail have the same elements; icp must be -1.");
        const int option = integer(ipotcn, "ipotcn");
        rail.elements = rail_elements(option, numbers(rparam, nparam, option == 0 ? 2 : 5, "rparam"), units);
    });
}

void get_rail_elements(const int* ire, double* dx, double* dy) {
    with_rail("cntc_getgriddiscretization", ire, [&](const RailCase& rail, const Settings& common) {
        require(dx, "dx");
        require(dy, "dy");
        if (!rail.settings.elements)
            throw Refused(error_code::discretisation, "Element sizes are missing; call cntc_setpotcontact.");
        *dx = rail.settings.elements->dx / common.units.length;
        *dy = rail.settings.elements->ds / common.units.length;
    });
}

/// Copies as many numbers as the caller has room for.
template <std::size_t count>
void fill(const std::array<double, count>& found, double* values, const int* lenarr) {
    const auto out = room(values, lenarr, 1, "values");
    std::copy_n(found.begin(), std::min(count, out.size()), out.begin());
}

}  // namespace

extern "C" void cntc_sethertzcontact(int* ire, int* icp, int* ipotcn, int* nparam, double* rparam) {
    set_basic("cntc_sethertzcontact", ire, icp, "potential contact", [&](Settings& settings) {
        const int option = integer(ipotcn, "ipotcn");
        constexpr int of_halves = -6;
        settings.area = hertz_area(option, list(rparam, nparam, option == of_halves ? 6 : 5, "rparam"), settings.units);
    });
}
CONTACTD_FORTRAN_NAME(cntc_sethertzcontact)

extern "C" void cntc_setpotcontact(int* ire, int* icp, int* ipotcn, int* nparam, double* rparam) {
    if (of_rail(ire)) return set_rail_elements(ire, icp, ipotcn, nparam, rparam);
    set("cntc_setpotcontact", ire, icp, "potential contact", [&](Settings& settings) {
        const int option = integer(ipotcn, "ipotcn");
        settings.area = potential_contact(option, list(rparam, nparam, 6, "rparam"), settings.units);
    });
}
CONTACTD_FORTRAN_NAME(cntc_setpotcontact)

extern "C" void cntc_setundeformeddistc(int* ire, int* icp, int* ibase, int* nparam, double* prmudf) {
    set_basic("cntc_setundeformeddistc", ire, icp, "undeformed distance", [&](Settings& settings) {
        const int base = integer(ibase, "ibase"), least = distance_numbers(base);
        const bool has_more = base == 2 || base == 9;
        settings.distance = given_distance(
            base, has_more ? numbers(prmudf, nparam, least, "prmudf") : list(prmudf, nparam, least, "prmudf"),
            settings.units);
    });
}
CONTACTD_FORTRAN_NAME(cntc_setundeformeddistc)

extern "C" void cntc_gethertzcontact(int* ire, int* icp, int* lenarr, double* values) {
    clear(values, lenarr);
    get("cntc_gethertzcontact", ire, icp, [&](const ProblemCase& problem) {
        const HertzResult hertz = hertz_of(problem.settings);
        const Units& units = problem.settings.units;
        const double a1 = hertz.a1 / units.curvature(), b1 = hertz.b1 / units.curvature();
        const double a = hertz.axes.a / units.length, b = hertz.axes.b / units.length;
        const double negative = hertz.negative / units.length, positive = hertz.positive / units.length;
        fill<10>({a1, b1, a, b, 2 / (a1 + b1), std::sqrt(a * b), hertz.scale, negative, positive, a / b}, values,
                 lenarr);
    });
}
CONTACTD_FORTRAN_NAME(cntc_gethertzcontact)

extern "C" void cntc_getpotcontact(int* ire, int* icp, int* lenarr, double* values) {
    clear(values, lenarr);
    get("cntc_getpotcontact", ire, icp, [&](const ProblemCase& problem) {
        const Grid grid = grid_of(problem);
        const double mm = problem.settings.units.length;
        fill<6>({double(grid.nx), double(grid.ny), grid.x(0) / mm, grid.y(0) / mm, grid.dx / mm, grid.dy / mm}, values,
                lenarr);
    });
}
CONTACTD_FORTRAN_NAME(cntc_getpotcontact)

extern "C" void cntc_getnumelements(int* ire, int* icp, int* mx, int* my) {
    for (int* out : {mx, my})
        if (out != nullptr) *out = 0;
    get("cntc_getnumelements", ire, icp, [&](const ProblemCase& problem) {
        require(mx, "mx");
        require(my, "my");
        if (const auto* area = std::get_if<HertzArea>(&problem.settings.area)) {  // their numbers require no load
            *mx = area->mx;
            *my = area->my;
            return;
        }
        const Grid grid = grid_of(problem);
        *mx = grid.nx;
        *my = grid.ny;
    });
}
CONTACTD_FORTRAN_NAME(cntc_getnumelements)

extern "C" void cntc_getgriddiscretization(int* ire, int* icp, double* dx, double* dy) {
    clear(dx);
    clear(dy);
    if (of_rail(ire) && icp != nullptr && *icp == all_problems) return get_rail_elements(ire, dx, dy);
    get("cntc_getgriddiscretization", ire, icp, [&](const ProblemCase& problem) {
        require(dx, "dx");
        require(dy, "dy");
        const Grid grid = grid_of(problem);
        *dx = grid.dx / problem.settings.units.length;
        *dy = grid.dy / problem.settings.units.length;
    });
}
CONTACTD_FORTRAN_NAME(cntc_getgriddiscretization)
