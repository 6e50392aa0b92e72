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

/// [4 values of each body, the share of plastic work that becomes heat: of an interfacial layer, else left out].
ThermalBodies bodies_of(const std::vector<double>& values, const Units& units) {
    ThermalBodies bodies{body_of(&values[0], units), body_of(&values[4], units)};
    if (values.size() > 8) bodies.plastic_share = values[8];
    validate(bodies, "heat");
    return bodies;
}

/// Zero without heat.
ContactTemperature temperature_of(const ContactCase& problem) {
    return solution_of(problem).solution.temperature.value_or(ContactTemperature{});
}

}  // namespace

extern "C" void cntc_settemperaturedata(int* ire, int* icp, int* imeth, int* nparam, double* rparam) {
    set("cntc_settemperaturedata", ire, icp, "temperature", [&](Settings& settings) {
        const int method = integer(imeth, "imeth");
        if (method == given) {
            settings.heat = bodies_of(numbers(rparam, nparam, 8, "rparam"), settings.units);
        } else if (method != none && method != keep) {
            throw Refused(error_code::input, "Temperature method " + std::to_string(method) +
                                                 " is not supported; use 0 for none, 1 to keep the data, or 3.");
        } else if (method == keep && !settings.heat) {
            throw Refused(error_code::input, "Method 1 keeps the data, but none was set; use method 3.");
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
        const ContactTemperature temperature = temperature_of(problem);
        if (t1max != nullptr) *t1max = temperature.largest_upper;
        if (t2max != nullptr) *t2max = temperature.largest_lower;
    });
}
CONTACTD_FORTRAN_NAME(cntc_getmaximumtemperature)
