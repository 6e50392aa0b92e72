// Materials of the bodies, and the friction between them.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "interface/entry.hpp"

using namespace contactd;
using namespace contactd::cntc;

namespace {

MaterialPair elastic(const std::vector<double>& given, const Units& units) {
    const MaterialPair pair{{given[2] * units.stress(), given[0]}, {given[3] * units.stress(), given[1]}};
    validate(pair.upper, "body 1", true);
    validate(pair.lower, "body 2", true);
    return pair;
}

[[noreturn]] void refuse_friction(const std::string& sentence) {
    throw Refused(error_code::friction, sentence);
}

enum Law { coulomb = 0, keep = 1, linear = 2, rational = 3, exponential = 4, by_temperature = 6 };

FrictionLaw coulomb_of(const std::vector<double>& given) {
    if (given[0] != given[1])
        refuse_friction(
            "fstat and fkin differ; friction that changes to another value at the first slip has no solution here. "
            "Give the same, or a law that falls with the slip velocity (2, 3 or 4).");
    if (given[0] < 0) refuse_friction("fstat is negative.");
    return {{given[0]}};
}

/// Slip velocity of a term of core's law that has halved at s.
double slip_velocity_of(int law, double s) {
    return law == linear ? 2 * s : law == exponential ? s / std::numbers::ln2 : s;
}

/// Terms f1 and f2 that have halved at s1 and s2: max(0, 1 - v/(2 s)), 2^(-v/s), or 1/(1 + v/s) and 1/(1 + (v/s)^2).
FrictionLaw falling_of(int law, const std::vector<double>& given) {
    const double fkin = given[0], distance = given[5], least_velocity = given[6];
    SecondTerm first{given[1], slip_velocity_of(law, given[2])}, second{given[3], slip_velocity_of(law, given[4])};
    if (fkin < 0 || first.fall < 0 || second.fall < 0) refuse_friction("fkin, f1 or f2 is negative.");
    if (first.fall == 0 && second.fall == 0) return {{fkin}};
    if (first.fall == 0 && law != rational) std::swap(first, second);
    if (first.fall == 0) first.slip_velocity = second.slip_velocity;
    if (!(first.slip_velocity > 0)) refuse_friction("s1 must be positive.");
    if (second.fall > 0 && !(second.slip_velocity > 0)) refuse_friction("s2 must be positive.");
    if (distance < 0 || least_velocity < 0) refuse_friction("memdst or mem_s0 is negative.");
    const SlipLaw name = law == linear ? SlipLaw::linear : law == rational ? SlipLaw::rational : SlipLaw::exponential;
    KineticFriction kinetic{name, fkin, first.slip_velocity};
    if (second.fall > 0) kinetic.second = second;
    if (distance > 0) kinetic.memory = FrictionMemory{distance, least_velocity};
    return {{fkin + first.fall + second.fall}, kinetic};
}

/// [fref, tref, dfheat, dtheat, memdst, mem_s0].
FrictionLaw heated_of(const std::vector<double>& given) {
    if (given[4] != 0) refuse_friction("memdst is not 0; contactd's friction has no memory.");
    FrictionLaw law{{given[0]}, {}, {}, TemperatureFriction{given[2], given[1], given[3]}};
    validate(*law.temperature, law.mu);
    return law;
}

int parameters_of(int law) {
    return law == coulomb ? 2 : law == by_temperature ? 6 : 7;
}

/// Parameters that are lengths or velocities, in mm.
std::vector<double> in_mm(int law, std::vector<double> parameters, double length) {
    if (law == coulomb) return parameters;
    if (law == by_temperature) {
        for (const std::size_t i : {4, 5}) parameters[i] *= length;
        return parameters;
    }
    for (const std::size_t i : {2, 4, 5, 6}) parameters[i] *= length;
    return parameters;
}

GivenFriction same_friction(int method, const std::vector<double>& parameters, const Units& units) {
    const auto given = in_mm(method, parameters, units.length);
    if (method == by_temperature) return {method, given, heated_of(given)};
    return {method, given, method == coulomb ? coulomb_of(given) : falling_of(method, given)};
}

enum Varies { by_angle = 1, along_track = 2 };

/// [number, and of each its angle or place, and the parameters of the law there].
GivenFriction varying_friction(int method, const std::vector<double>& given, const Units& units) {
    const int law = method % 10, varies = method / 10, size = 1 + (law == coulomb ? 2 : 7);
    const int count = given.empty() ? 0 : whole(given[0], "the number of places of friction");
    if (count < 1 || given.size() != 1 + static_cast<std::size_t>(count) * static_cast<std::size_t>(size))
        refuse_friction("Friction that varies has " + std::to_string(given.size()) + " values, which " +
                        std::to_string(count) + " places with " + std::to_string(size) + " values each are not.");
    GivenFriction friction;
    for (int k = 0; k < count; ++k) {
        const auto first = given.begin() + 1 + k * size;
        const GivenFriction here = same_friction(law, {first + 1, first + size}, units);
        const double place = *first * (varies == along_track ? units.length : 1);
        if (!friction.varying.empty() && place <= friction.varying.back().place)
            refuse_friction("Angles or places of friction must ascend.");
        if (k == 0) friction = here;
        friction.varying.push_back({place, here.law});
    }
    friction.method = method;
    return friction;
}

GivenFriction friction_of(const Settings& settings, int method, const double* params, const int* nparam) {
    const bool on_rails = settings.module == module_number::wheel_rail;
    const int law = method % 10, varies = method / 10;
    const bool has_law =
        law == coulomb || law == linear || law == rational || law == exponential || law == by_temperature;
    if (!has_law || varies < 0 || varies > along_track || (varies > 0 && (!on_rails || law == by_temperature)))
        refuse_friction("Method " + std::to_string(method) + " is asked for; contactd has 0, 2, 3, 4 and 6, " +
                        (on_rails ? "and all but the last plus 10 or 20." : "the same over the contact."));
    if (varies > 0) return varying_friction(method, numbers(params, nparam, 1, "params"), settings.units);
    return same_friction(method, list(params, nparam, parameters_of(law), "params"), settings.units);
}

/// The layer has the flexibility thickness/gg3; tau_c0 = 0 or 1e10 and more never yields.
InterfacialLayer layer(double gg3, double thickness, double tau_c0, double k_tau, const Units& units) {
    constexpr double never = 1e10;
    if (!(gg3 > 0) || !(thickness >= 0) || !(tau_c0 >= 0))
        throw Refused(error_code::input, "An interfacial layer has gg3 above 0, and laythk and tau_c0 not below.");
    InterfacialLayer layer{thickness * units.length / (gg3 * units.stress())};
    if (tau_c0 == 0 || tau_c0 >= never) return layer;
    layer.yield_stress = tau_c0 * units.stress();
    layer.hardening = k_tau * units.stress() / units.length;
    validate(layer);
    return layer;
}

/// [fg1, fg2, tc1, tc2], the last two in s.
std::array<Viscoelasticity, 2> creep(const std::vector<double>& given) {
    const std::array<Viscoelasticity, 2> bodies{{{given[4], given[6]}, {given[5], given[7]}}};
    for (const auto& [f, tau] : bodies)
        if (!(f >= 0 && tau >= 0))
            throw Refused(error_code::input, "Viscoelastic bodies have fg1, fg2, tc1 and tc2 not below 0.");
    return bodies;
}

/// Nothing is reduced at large creepages where k0 is not, whatever beta is.
SlopeReduction slope(double k0, double alpha, double beta) {
    if (!(k0 > 0 && alpha > 0 && beta >= 0))
        throw Refused(error_code::input, "A reduction of the slope has k0 and alpha above 0, and beta not below.");
    return {k0, alpha, beta};
}

std::vector<double> material_back(const Settings& settings) {
    if (!settings.materials) throw Refused(error_code::input, "No material was set.");
    const auto& [upper, lower] = *settings.materials;
    const double stress = settings.units.stress();
    std::vector<double> back{upper.nu, lower.nu, upper.G / stress, lower.G / stress};
    if (settings.creep) {
        const auto& [above, below] = *settings.creep;
        back.insert(back.end(), {above.f, below.f, above.tau, below.tau});
    }
    return back;
}

std::vector<double> friction_back(const Settings& settings) {
    if (!settings.friction) throw Refused(error_code::input, "No friction was set.");
    return in_mm(settings.friction->method % 10, settings.friction->parameters, 1 / settings.units.length);
}

}  // namespace

extern "C" void cntc_setmaterialparameters(int* ire, int* icp, int* imeth, int* nparam, double* rparam) {
    set("cntc_setmaterialparameters", ire, icp, "material", [&](Settings& settings) {
        const int method = integer(imeth, "imeth");
        constexpr int viscoelastic = 1, fastsim = 3, layered = 4, fastrip = 5;
        const bool is_simplified = method == fastsim || method == fastrip,
                   has_eight = method == viscoelastic || method == layered;
        if (method != 0 && !has_eight && !is_simplified)
            throw Refused(error_code::input,
                          "Method " + std::to_string(method) +
                              " is asked for; contactd has elastic bodies here, 0, viscoelastic ones, 1, elastic ones "
                              "with an interfacial layer, 4, and with the simplified theory, 3 or 5.");
        std::vector<double> given = list(rparam, nparam, is_simplified ? 7 : has_eight ? 8 : 4, "rparam");
        settings.slope = {};
        settings.layer.reset();
        settings.creep.reset();
        if (method == viscoelastic) settings.creep = creep(given);
        if (method == layered) settings.layer = layer(given[4], given[5], given[6], given[7], settings.units);
        if (is_simplified) settings.slope = slope(given[4], given[5], given[6]);
        given.resize(4);
        settings.materials = elastic(given, settings.units);
        settings.digits.set(flag::material, method);
        settings.refused.erase("flag " + std::to_string(flag::material));
    });
}
CONTACTD_FORTRAN_NAME(cntc_setmaterialparameters)

extern "C" void cntc_setfrictionmethod(int* ire, int* icp, int* imeth, int* nparam, double* params) {
    set("cntc_setfrictionmethod", ire, icp, "friction", [&](Settings& settings) {
        const int method = integer(imeth, "imeth");
        if (method == keep && settings.friction) return;
        settings.friction = friction_of(settings, method, params, nparam);
        settings.digits.set(flag::friction_law, method % 10);
        settings.refused.erase("flag " + std::to_string(flag::friction_law));
    });
}
CONTACTD_FORTRAN_NAME(cntc_setfrictionmethod)

extern "C" void cntc_getparameters(int* ire, int* icp, int* itask, int* lenarr, double* values) {
    clear(values, lenarr);
    get("cntc_getparameters", ire, icp, [&](const ContactCase& problem) {
        constexpr int material = 2, friction = 3;
        const int task = integer(itask, "itask");
        if (task != material && task != friction)
            throw Refused(error_code::input, "itask is " + std::to_string(task) + "; it is 2 or 3.");
        const auto found = task == material ? material_back(problem.settings) : friction_back(problem.settings);
        std::ranges::copy(found, room(values, lenarr, found.size(), "values").begin());
    });
}
CONTACTD_FORTRAN_NAME(cntc_getparameters)
