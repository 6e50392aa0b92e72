// Returns results with one number per element.
#include <algorithm>

#include "answers/element_fields.hpp"
#include "interface/entry.hpp"
#include "problem/case_models.hpp"
#include "problem/rail_setup.hpp"

using namespace contactd;
using namespace contactd::cntc;

namespace {

using Values = std::vector<double>;

/// Converts numbers of the core to the caller's units. An array that the core leaves empty becomes zeros.
void fill(const Values& found, double unit, std::span<double> out, std::size_t elements) {
    for (std::size_t i = 0; i < elements; ++i) out[i] = found.empty() ? 0 : found[i] / unit;
}

/// A field of the solution and its unit.
struct Field {
    Values values;
    double unit = 1;
};

/// Returns the field of a code of cntc_getfielddata. Slip is relative in rolling, and in mm in a shift, whatever the
/// units. Unknown codes, plasticity without a layer that yields, and temperatures without heat are zero.
Field field_of(int code, ProblemCase& problem) {
    const Solved& solved = solution_of(problem);
    const ContactSolution& solution = solved.solution;
    const Units& units = problem.settings.units;
    const bool on_rails = problem.settings.module == module_number::wheel_rail;
    const auto displacements = [&] {
        const bool found = !solution.displacement_x.empty();  // computed with the solution, for rotated rows
        if (found || (on_rails && models_of(problem.settings).model != Model::full))
            return Displacements{solution.displacement_x, solution.displacement_y, solution.displacement_z};
        if (on_rails)
            return problem.solver.displacements_on_rail(solved.problem, solution, on_left_side(problem.settings));
        return problem.solver.displacements(solved.problem, solution);
    };
    switch (code) {
        case 1:
            return {distance_of(solved), units.length};
        case 2:
            return {friction_of(solved)};
        case 3:
            return {solution.traction_x, units.body * units.stress()};
        case 4:
            return {solution.traction_y, units.body * units.stress()};
        case 5:
            return {solution.pressure, units.stress()};
        case 7:
            return {in_contact(displacements().x, solution), units.length};
        case 8:
            return {in_contact(displacements().y, solution), units.length};
        case 9:
            return {in_contact(displacements().z, solution), units.length};
        case 11:
            return {yield_stress(solved.problem, solution), units.stress()};
        case 12:
            return {solved.plastic.x, units.length};
        case 13:
            return {solved.plastic.y, units.length};
        case 15:
            return {solution.slip_x, units.body};
        case 16:
            return {solution.slip_y, units.body};
        case 20:
            return {solution.upper_temperature};
        case 21:
            return {solution.lower_temperature};
        case 22:
            return {rigid_slip_of(solved).x, units.body};
        case 23:
            return {rigid_slip_of(solved).y, units.body};
        default:
            return {};
    }
}

/// Returns several fields at a time, by their codes.
template <std::size_t count>
void get_fields(const char* function, const int* ire, const int* icp, const int* lenarr,
                const std::array<int, count>& codes, const std::array<double*, count>& out) {
    for (double* values : out) clear(values, lenarr);
    get(function, ire, icp, [&](ProblemCase& problem) {
        const std::size_t elements = solution_of(problem).problem.grid.size();
        std::array<std::span<double>, count> rooms;
        for (std::size_t i = 0; i < count; ++i) rooms[i] = room(out[i], lenarr, elements, "an array of elements");
        for (std::size_t i = 0; i < count; ++i) {
            const Field field = field_of(codes[i], problem);
            fill(field.values, field.unit, rooms[i], elements);
        }
    });
}

}  // namespace

extern "C" void cntc_getelementdivision(int* ire, int* icp, int* lenarr, int* division) {
    constexpr int unknown = -1;
    if (division != nullptr && lenarr != nullptr && *lenarr > 0) std::fill_n(division, *lenarr, unknown);
    get("cntc_getelementdivision", ire, icp, [&](const ProblemCase& problem) {
        const auto& found = solution_of(problem).solution.element_division;
        require(division, "division");
        const int length = integer(lenarr, "lenarr");
        if (length < 0 || static_cast<std::size_t>(length) < found.size())
            throw Refused(error_code::input, "division has " + std::to_string(length) + " values, but " +
                                                 std::to_string(found.size()) + " are required.");
        std::ranges::transform(found, division, [](ElementState state) { return static_cast<int>(state); });
    });
}
CONTACTD_FORTRAN_NAME(cntc_getelementdivision)

extern "C" void cntc_gettractions(int* ire, int* icp, int* lenarr, double* pn, double* px, double* py) {
    get_fields<3>("cntc_gettractions", ire, icp, lenarr, {5, 3, 4}, {pn, px, py});
}
CONTACTD_FORTRAN_NAME(cntc_gettractions)

extern "C" void cntc_getmicroslip(int* ire, int* icp, int* lenarr, double* sx, double* sy) {
    get_fields<2>("cntc_getmicroslip", ire, icp, lenarr, {15, 16}, {sx, sy});
}
CONTACTD_FORTRAN_NAME(cntc_getmicroslip)

extern "C" void cntc_getdisplacements(int* ire, int* icp, int* lenarr, double* un, double* ux, double* uy) {
    get_fields<3>("cntc_getdisplacements", ire, icp, lenarr, {9, 7, 8}, {un, ux, uy});
}
CONTACTD_FORTRAN_NAME(cntc_getdisplacements)

extern "C" void cntc_getfielddata(int* ire, int* icp, int* ifld, int* lenarr, double* values) {
    clear(values, lenarr);
    if (ifld == nullptr) {
        get("cntc_getfielddata", ire, icp, [&](const ProblemCase&) { require(ifld, "ifld"); });
        return;
    }
    get_fields<1>("cntc_getfielddata", ire, icp, lenarr, {*ifld}, {values});
}
CONTACTD_FORTRAN_NAME(cntc_getfielddata)
