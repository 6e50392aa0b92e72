// Thermal properties of the bodies, and the largest temperatures.
#include <algorithm>

#include "interface/entry.hpp"

using namespace contactd;
using namespace contactd::cntc;

namespace {

enum Method { none = 0, keep = 1, given = 3 };

/// [bulk temperature, heat capacity (J/(kg K)), conductivity (W/(length K)), density (kg/length^3)] of one body.
ThermalBody body_of(const double* values, const Units& units) {
    constexpr double metre = 1000;  // mm
    const double length = metre / units.length;
    ThermalBody body;
    body.bulk_temperature = values[0];
    body.heat_capacity = values[1];
    body.conductivity = values[2] * length;
    body.density = values[3] * length * length * length;
    return body;
}

ThermalBodies bodies_of(const std::vector<double>& values, const Units& units) {
    const ThermalBodies bodies{body_of(&values[0], units), body_of(&values[4], units)};
    validate(bodies, "heat");
    return bodies;
}

/// Returns that of both surfaces in contact, which have one temperature there; 0 without heat.
double largest_of(const ContactCase& problem) {
    const auto& temperature = solution_of(problem).solution.temperature;
    return temperature ? temperature->largest : 0;
}

}  // namespace

extern "C" void cntc_settemperaturedata(int* ire, int* icp, int* imeth, int* nparam, double* rparam) {
    set("cntc_settemperaturedata", ire, icp, "temperature", [&](Settings& settings) {
        const int method = integer(imeth, "imeth");
        if (method == given) {
            // The ninth is the share of a layer's plastic work that becomes heat, which a layer that yields would need.
            settings.heat = bodies_of(numbers(rparam, nparam, 8, "rparam"), settings.units);
        } else if (method != none && method != keep) {
            throw Refused(error_code::input, "Method " + std::to_string(method) +
                                                 " is asked for; it is 0 for none, 1 to keep what there is, or 3.");
        } else if (method == keep && !settings.heat) {
            throw Refused(error_code::input, "Method 1 keeps what there is, and nothing was set.");
        }
        settings.digits.set(flag::heat, method);
        settings.refused.erase("flag " + std::to_string(flag::heat));
    });
}
CONTACTD_FORTRAN_NAME(cntc_settemperaturedata)

extern "C" void cntc_getmaximumtemperature(int* ire, int* icp, double* t1max, double* t2max) {
    clear(t1max);
    clear(t2max);
    get("cntc_getmaximumtemperature", ire, icp, [&](const ContactCase& problem) {
        const double largest = largest_of(problem);
        for (double* value : {t1max, t2max})
            if (value != nullptr) *value = largest;
    });
}
CONTACTD_FORTRAN_NAME(cntc_getmaximumtemperature)
