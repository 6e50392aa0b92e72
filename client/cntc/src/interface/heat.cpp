// Sets thermal properties of the bodies, and returns the largest temperatures.
#include "given/given_bodies.hpp"
#include "interface/entry.hpp"

using namespace contactd;
using namespace contactd::cntc;

namespace {

enum Method { none = 0, keep = 1, given = 3 };

/// Returns zeros if there is no heat.
ContactTemperature temperature_of(const ProblemCase& problem) {
    return solution_of(problem).solution.temperature.value_or(ContactTemperature{});
}

}  // namespace

extern "C" void cntc_settemperaturedata(int* ire, int* icp, int* imeth, int* nparam, double* rparam) {
    set("cntc_settemperaturedata", ire, icp, "temperature", [&](Settings& settings) {
        const int method = integer(imeth, "imeth");
        if (method == given) {
            settings.heat = thermal_bodies(numbers(rparam, nparam, 8, "rparam"), settings.units);
        } else if (method != none && method != keep) {
            throw Refused(error_code::input, "Temperature method " + std::to_string(method) +
                                                 " is not supported; use 0 for none, 1 to keep the data, or 3.");
        } else if (method == keep && !settings.heat) {
            throw Refused(error_code::input, "Temperature method 1 keeps the data, but none were set. Use method 3.");
        }
        settings.digits.heat = method;
        settings.refused.erase("flag " + std::to_string(flag::heat));
    });
}
CONTACTD_FORTRAN_NAME(cntc_settemperaturedata)

extern "C" void cntc_getmaximumtemperature(int* ire, int* icp, double* t1max, double* t2max) {
    clear(t1max);
    clear(t2max);
    get("cntc_getmaximumtemperature", ire, icp, [&](const ProblemCase& problem) {
        const ContactTemperature temperature = temperature_of(problem);
        if (t1max != nullptr) *t1max = temperature.largest_upper;
        if (t2max != nullptr) *t2max = temperature.largest_lower;
    });
}
CONTACTD_FORTRAN_NAME(cntc_getmaximumtemperature)
