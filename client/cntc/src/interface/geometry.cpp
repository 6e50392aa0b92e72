// The potential contact area and the undeformed distance.
#include <algorithm>
#include <array>
#include <cmath>

#include "interface/entry.hpp"
#include "problem/given_distance.hpp"

using namespace contactd;
using namespace contactd::cntc;

namespace {

[[noreturn]] void refuse_option(const char* name, int option, const char* covered) {
    throw Refused(error_code::discretisation,
                  std::string(name) + " is " + std::to_string(option) + "; contactd supports " + covered + ".");
}

struct Elements {
    int mx, my;
};

Elements elements(const std::vector<double>& given) {
    const Elements result{whole(given[0], "mx"), whole(given[1], "my")};
    if (result.mx < 1 || result.my < 1 || static_cast<double>(result.mx) * result.my > double{max_grid_elements})
        throw Refused(error_code::discretisation,
                      "There are " + std::to_string(result.mx) + " x " + std::to_string(result.my) +
                          " elements; their number must lie between 1 and " + std::to_string(max_grid_elements) + ".");
    return result;
}

/// [mx, my, a, b towards -y, b towards +y, scale] of two half ellipses.
HertzArea half_ellipses(int option, const std::vector<double>& given, const Units& units) {
    const auto [mx, my] = elements(given);
    const double a = positive(given[2], "the semi-axis along x") * units.length,
                 negative = positive(given[3], "bneg") * units.length,
                 towards_y = positive(given[4], "bpos") * units.length;
    return {option, mx, my, a, (negative + towards_y) / 2, positive(given[5], "scale"), negative, towards_y};
}

HertzArea hertz_area(int option, const std::vector<double>& given, const Units& units) {
    const auto [mx, my] = elements(given);
    const double first_unit = option == -3 || option == -5 ? units.length : units.curvature();
    const double second_unit = option == -1 ? units.curvature() : option == -2 ? 1 : units.length;
    return {option,
            mx,
            my,
            positive(given[2], "the first curvature or semi-axis") * first_unit,
            positive(given[3], "the second curvature, ratio, semi-axis or half width") * second_unit,
            positive(given[4], "scale")};
}

/// Along one axis: the lower edge and the size of an element (mm).
struct Interval {
    double low, size;
};

/// From the numbers of cntc_setpotcontact: `from` is an edge or a centre, `to` the other one or the size.
Interval interval(int option, int elements, double from, double to) {
    const bool of_centres = option >= 3, by_size = option == 1 || option == 3;
    if (option == 4 && elements < 2)
        throw Refused(error_code::discretisation,
                      "The centres of the first and the last element do not determine the size of a single element; "
                      "use ipotcn 1, 2 or 3.");
    const double size = by_size ? to : (to - from) / (of_centres ? elements - 1 : elements);
    return {of_centres ? from - size / 2 : from, size};
}

Grid potential_contact(int option, const std::vector<double>& given, const Units& units) {
    const auto [mx, my] = elements(given);
    const Interval x = interval(option, mx, given[2] * units.length, given[4] * units.length);
    const Interval y = interval(option, my, given[3] * units.length, given[5] * units.length);
    const Grid grid{mx, my, x.size, y.size, x.low, y.low};
    validate(grid, "grid");
    return grid;
}

/// [dx, ds, not used] or [dx, ds, a_sep, d_sep, d_comb, d_turn], of which the last may be missing; what comes behind is
/// not read.
GivenElements rail_elements(int option, const std::vector<double>& given, const Units& units) {
    const double mm = units.length;
    GivenElements elements;
    elements.dx = positive(given[0], "dx") * mm;
    elements.ds = positive(given[1], "ds") * mm;
    if (option == 0) return elements;
    for (const std::size_t i : {2, 3, 4})
        if (given[i] < 0)
            throw Refused(error_code::discretisation, "a_sep, d_sep or d_comb is negative; they must be at least 0.");
    elements.angle_separate = given[2];
    elements.separate = given[3] * mm;
    elements.combine = given[4] * mm;
    elements.turn = given.size() > 5 ? given[5] * mm : 2 * elements.separate - elements.combine;
    return elements;
}

/// Elements are those of all patches, which nobody numbers before they are found.
void set_rail_elements(const int* ire, const int* icp, const int* ipotcn, const int* nparam, const double* rparam) {
    set_rail("cntc_setpotcontact", ire, "potential contact", [&](RailSettings& rail, const Units& units) {
        if (number_of(icp) > 0)
            throw Refused(error_code::handle, "Elements of a wheel on a rail are set for all patches; icp must be -1.");
        const int option = integer(ipotcn, "ipotcn");
        if (option != 0 && option != -1) refuse_option("ipotcn", option, "0 and -1 for a wheel on a rail");
        rail.elements = rail_elements(option, numbers(rparam, nparam, option == 0 ? 2 : 5, "rparam"), units);
    });
}

void get_rail_elements(const int* ire, double* dx, double* dy) {
    with_rail("cntc_getgriddiscretization", ire, [&](const RailCase& rail, const Settings& common) {
        require(dx, "dx");
        require(dy, "dy");
        if (!rail.settings.elements)
            throw Refused(error_code::discretisation, "No sizes of elements were set; call cntc_setpotcontact.");
        *dx = rail.settings.elements->dx / common.units.length;
        *dy = rail.settings.elements->ds / common.units.length;
    });
}

/// Copies as many of the numbers as the caller has room for.
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
        if (option < of_halves || option > -1) refuse_option("ipotcn", option, "the Hertz contacts -1 to -6");
        settings.area = option == of_halves ? half_ellipses(option, list(rparam, nparam, 6, "rparam"), settings.units)
                                            : hertz_area(option, list(rparam, nparam, 5, "rparam"), settings.units);
    });
}
CONTACTD_FORTRAN_NAME(cntc_sethertzcontact)

extern "C" void cntc_setpotcontact(int* ire, int* icp, int* ipotcn, int* nparam, double* rparam) {
    if (of_rail(ire)) return set_rail_elements(ire, icp, ipotcn, nparam, rparam);
    set("cntc_setpotcontact", ire, icp, "potential contact", [&](Settings& settings) {
        const int option = integer(ipotcn, "ipotcn");
        if (option < 1 || option > 4) refuse_option("ipotcn", option, "the potential contacts 1 to 4");
        settings.area = potential_contact(option, list(rparam, nparam, 6, "rparam"), settings.units);
    });
}
CONTACTD_FORTRAN_NAME(cntc_setpotcontact)

extern "C" void cntc_setundeformeddistc(int* ire, int* icp, int* ibase, int* nparam, double* prmudf) {
    set_basic("cntc_setundeformeddistc", ire, icp, "undeformed distance", [&](Settings& settings) {
        settings.distance = read_distance(integer(ibase, "ibase"), prmudf, nparam, settings.units);
    });
}
CONTACTD_FORTRAN_NAME(cntc_setundeformeddistc)

extern "C" void cntc_gethertzcontact(int* ire, int* icp, int* lenarr, double* values) {
    clear(values, lenarr);
    get("cntc_gethertzcontact", ire, icp, [&](const ContactCase& problem) {
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
    get("cntc_getpotcontact", ire, icp, [&](const ContactCase& problem) {
        const Grid grid = grid_of(problem.settings);
        const double mm = problem.settings.units.length;
        fill<6>({double(grid.nx), double(grid.ny), grid.x(0) / mm, grid.y(0) / mm, grid.dx / mm, grid.dy / mm}, values,
                lenarr);
    });
}
CONTACTD_FORTRAN_NAME(cntc_getpotcontact)

extern "C" void cntc_getnumelements(int* ire, int* icp, int* mx, int* my) {
    for (int* out : {mx, my})
        if (out != nullptr) *out = 0;
    get("cntc_getnumelements", ire, icp, [&](const ContactCase& problem) {
        require(mx, "mx");
        require(my, "my");
        if (const auto* area = std::get_if<HertzArea>(&problem.settings.area)) {  // their numbers need no load
            *mx = area->mx;
            *my = area->my;
            return;
        }
        const Grid grid = grid_of(problem.settings);
        *mx = grid.nx;
        *my = grid.ny;
    });
}
CONTACTD_FORTRAN_NAME(cntc_getnumelements)

extern "C" void cntc_getgriddiscretization(int* ire, int* icp, double* dx, double* dy) {
    clear(dx);
    clear(dy);
    if (of_rail(ire) && icp != nullptr && *icp == all_problems) return get_rail_elements(ire, dx, dy);
    get("cntc_getgriddiscretization", ire, icp, [&](const ContactCase& problem) {
        require(dx, "dx");
        require(dy, "dy");
        const Grid grid = grid_of(problem.settings);
        *dx = grid.dx / problem.settings.units.length;
        *dy = grid.dy / problem.settings.units.length;
    });
}
CONTACTD_FORTRAN_NAME(cntc_getgriddiscretization)
