// Solves, and returns single numbers.
#include <cmath>

#include "answers/sensitivities.hpp"
#include "handles/stopwatch.hpp"
#include "interface/entry.hpp"

using namespace contactd;
using namespace contactd::cntc;

namespace {

/// Returns the largest number of elements at the border. If problems fail, throws the first error after all have been
/// solved.
int calculate_all(int ire, int icp) {
    int border = 0;
    std::exception_ptr failed;
    for (const CasePtr& problem : Registry::of_process().existing(ire, icp)) {
        const std::scoped_lock lock(problem->mutex);
        try {
            border = std::max(border, calculate(*problem));
        } catch (...) {
            if (!failed) failed = std::current_exception();
        }
    }
    if (failed) std::rethrow_exception(failed);
    return border;
}

/// Makes contact problems from the patches, valid until the next solve.
int show_patches(const RailCase& rail, int ire, const Settings& settings, const CalculationTime& time) {
    const auto found = rail.current ? ordered_patches(rail) : std::vector<const WheelRailPatch*>();
    const auto problems = Registry::of_process().patches(ire, found.size(), settings);
    int border = 0;
    for (std::size_t i = 0; i < problems.size(); ++i) {
        const std::scoped_lock lock(problems[i]->mutex);
        problems[i]->current = false;
        if (i >= found.size()) continue;
        show(*found[i], rail, settings, *problems[i]);
        problems[i]->time = time;
        border = std::max(border, found[i]->solution.elements.border);
    }
    return border;
}

int calculate_rail(int ire) {
    const auto [rail, common] = Registry::of_process().rail(ire);
    const std::scoped_lock lock(rail->mutex);
    const auto as_set = [&] {
        const std::scoped_lock common_lock(common->mutex);
        return std::pair(common->settings, common->time);
    };
    auto [settings, time] = as_set();
    std::exception_ptr failed;
    try {
        const Stopwatch stopwatch(time);
        calculate(*rail, settings);
    } catch (...) {
        failed = std::current_exception();
    }
    const int border = show_patches(*rail, ire, settings, time);
    {
        const std::scoped_lock common_lock(common->mutex);
        common->time = time;
    }
    if (failed) std::rethrow_exception(failed);
    return border;
}

/// A wheel on a rail is solved as a whole, with the number of all problems.
int calculate_element(int ire, int icp) {
    if (!Registry::of_process().is_wheel_rail(ire)) return calculate_all(ire, icp);
    if (icp > 0) throw Refused(error_code::handle, "Patches of a wheel on a rail are solved together; icp must be -1.");
    return calculate_rail(ire);
}

template <class Solve>
void run(const char* function, int* ierror, const Solve& solve) {
    int border = 0;
    const int code = answer(function, [&] {
        border = solve();
        require(ierror, "ierror");
    });
    if (ierror != nullptr) *ierror = code < 0 ? code : border;
}

}  // namespace

extern "C" void cntc_calculate(int* ire, int* icp, int* ierror) {
    run("cntc_calculate", ierror, [&] { return calculate_element(number_of(ire), number_of(icp)); });
}
CONTACTD_FORTRAN_NAME(cntc_calculate)

extern "C" void cntc_calculate1(int* ire, int* ierror) {
    run("cntc_calculate1", ierror, [&] { return calculate_rail(number_of(ire)); });
}
CONTACTD_FORTRAN_NAME(cntc_calculate1)

extern "C" void cntc_calculate3(int* ire, int* icp, int* ierror) {
    run("cntc_calculate3", ierror, [&] {
        const int element = number_of(ire);
        if (Registry::of_process().is_wheel_rail(element))
            throw Refused(error_code::handle,
                          "Result element " + std::to_string(element) + " is a wheel on a rail; call cntc_calculate1.");
        return calculate_all(element, number_of(icp));
    });
}
CONTACTD_FORTRAN_NAME(cntc_calculate3)

extern "C" void cntc_getcontactforces(int* ire, int* icp, double* fn, double* fx, double* fy, double* mz) {
    for (double* out : {fn, fx, fy, mz}) clear(out);
    get("cntc_getcontactforces", ire, icp, [&](const ProblemCase& problem) {
        for (const double* out : {fn, fx, fy, mz}) require(out, "a force");
        const Forces& forces = solution_of(problem).solution.forces;
        const Units& units = problem.settings.units;
        *fn = forces.Fn;
        *fx = units.body * forces.Fx;
        *fy = units.body * forces.Fy;
        *mz = units.body * forces.Mz / units.moment();
    });
}
CONTACTD_FORTRAN_NAME(cntc_getcontactforces)

extern "C" void cntc_getcontactpatchareas(int* ire, int* icp, double* contact, double* adhesion, double* slip) {
    for (double* out : {contact, adhesion, slip}) clear(out);
    get("cntc_getcontactpatchareas", ire, icp, [&](const ProblemCase& problem) {
        for (const double* out : {contact, adhesion, slip}) require(out, "an area");
        const Areas& area = solution_of(problem).solution.area;
        const double unit = problem.settings.units.area();
        *contact = area.contact / unit;
        *adhesion = area.adhesion / unit;
        *slip = area.slip / unit;
    });
}
CONTACTD_FORTRAN_NAME(cntc_getcontactpatchareas)

extern "C" void cntc_getmaximumpressure(int* ire, int* icp, double* pnmax) {
    clear(pnmax);
    get("cntc_getmaximumpressure", ire, icp, [&](const ProblemCase& problem) {
        require(pnmax, "pnmax");
        *pnmax = solution_of(problem).solution.pmax / problem.settings.units.stress();
    });
}
CONTACTD_FORTRAN_NAME(cntc_getmaximumpressure)

extern "C" void cntc_getmaximumtraction(int* ire, int* icp, double* ptmax) {
    clear(ptmax);
    get("cntc_getmaximumtraction", ire, icp, [&](const ProblemCase& problem) {
        require(ptmax, "ptmax");
        const ContactSolution& solution = solution_of(problem).solution;
        double largest = 0;
        for (std::size_t i = 0; i < solution.traction_x.size(); ++i)
            largest = std::max(largest, std::hypot(solution.traction_x[i], solution.traction_y[i]));
        *ptmax = largest / problem.settings.units.stress();
    });
}
CONTACTD_FORTRAN_NAME(cntc_getmaximumtraction)

extern "C" void cntc_getsensitivities(int* ire, int* icp, int* lenout, int* lenin, double* values) {
    if (lenout != nullptr && lenin != nullptr && *lenout > 0 && values != nullptr)
        for (int in = 0; in < *lenin; ++in) clear(values + static_cast<std::ptrdiff_t>(in) * *lenout, lenout);
    get("cntc_getsensitivities", ire, icp, [&](ProblemCase& problem) {
        const int outs = integer(lenout, "lenout"), ins = integer(lenin, "lenin");
        require(values, "values");
        if (outs < 1 || ins < 1 || outs > 4 || ins > 4)
            throw Refused(error_code::input, "lenout and lenin are " + std::to_string(outs) + " and " +
                                                 std::to_string(ins) + "; they must be 1 to 4.");
        solution_of(problem);
        Solved& solved = *problem.solved;
        // Sensitivities of a wheel on a rail are computed when they are first read, patch by patch.
        if (problem.settings.module == module_number::wheel_rail && !solved.sensitivities)
            if (const int digit = problem.settings.digits.sensitivities; digit >= 2) {
                if (solved.beyond != nullptr)
                    throw Refused(error_code::input,
                                  std::string("Sensitivities of ") + solved.beyond + " on a rail are not supported.");
                solved.sensitivities = sensitivities(solved.problem, solved.solution, problem.solver, digit == 3);
            }
        if (!solved.sensitivities)
            throw Refused(error_code::input, "No sensitivities were requested; set flag 1988 before the solve.");
        const Units& units = problem.settings.units;
        const bool rolls = std::holds_alternative<Rolling>(solved.problem.motion);
        // In all systems of units, these are derivatives of the forces on body 1 by the motion as it is set.
        const std::array out_units{1.0, 1.0, 1.0, 1 / units.moment()};
        const std::array in_units{units.length, rolls ? 1 : units.length, rolls ? 1 : units.length,
                                  rolls ? units.curvature() : 1};
        for (int in = 0; in < ins; ++in)
            for (int out = 0; out < outs; ++out)
                values[in * outs + out] = (*solved.sensitivities)[out][in] * out_units[out] * in_units[in];
    });
}
CONTACTD_FORTRAN_NAME(cntc_getsensitivities)

extern "C" void cntc_getcalculationtime(int* ire, int* icp, double* cpu, double* wall) {
    clear(cpu);
    clear(wall);
    get_whole("cntc_getcalculationtime", ire, icp, [&](const ProblemCase& problem) {
        require(cpu, "cpu");
        require(wall, "wall");
        *cpu = problem.time.cpu;
        *wall = problem.time.wall;
    });
}
CONTACTD_FORTRAN_NAME(cntc_getcalculationtime)

extern "C" void cntc_resetcalculationtime(int* ire, int* icp) {
    answer("cntc_resetcalculationtime", [&] {
        const int element = number_of(ire), number = number_of(icp);
        auto& registry = Registry::of_process();
        if (registry.is_wheel_rail(element)) {
            const CasePtr whole = registry.rail(element).common;
            const std::scoped_lock lock(whole->mutex);
            whole->time = {};
            if (number == all_problems) return;
        }
        for (const CasePtr& problem : registry.existing(element, number)) {
            const std::scoped_lock lock(problem->mutex);
            problem->time = {};
        }
    });
}
CONTACTD_FORTRAN_NAME(cntc_resetcalculationtime)
