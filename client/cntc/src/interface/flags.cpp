// Sets flags, which control a solve, as pairs of code and value; returns settings.
#include <algorithm>
#include <span>

#include "given/given_friction.hpp"
#include "handles/control_digits.hpp"
#include "interface/entry.hpp"

using namespace contactd;
using namespace contactd::cntc;

namespace {

struct Pairs {
    std::span<const int> codes, values;

    Pairs(const int* count, const int* codes_, const int* values_)
        : codes(integers(codes_, count, 0, "params")), values(integers(values_, count, 0, "values")) {}
};

/// Sets flags that apply to all problems of the process.
void set_global(int code, int value) {
    if (code == flag::own_output) print_errors(value > 0);
}

Units units_of(int code) {
    for (const Units& units : {units_mm_on_body_1, units_m_on_body_2, units_m_on_body_1})
        if (units.code == code) return units;
    throw Refused(error_code::input, "Flag 1933 is " + std::to_string(code) + "; it must be 1934, 1935 or 1936.");
}

void set_flag(Settings& settings, int code, int value) {
    require_known_flag(code);
    set_global(code, value);
    set_part(settings, "flag " + std::to_string(code), [&](Settings& all) {
        if (code == flag::units)
            all.units = units_of(value);
        else if (code == flag::most_elements)
            all.most_elements = std::clamp(value, least_patch_elements, most_patch_elements);
        else
            set_flag_digit(all, code, value);
    });
}

/// Sets all flags, even if one of them fails.
void set_flags(Settings& settings, const Pairs& pairs) {
    std::exception_ptr failed;
    for (std::size_t i = 0; i < pairs.codes.size(); ++i) try {
            if (pairs.codes[i] != flag::none) set_flag(settings, pairs.codes[i], pairs.values[i]);
        } catch (...) {
            failed = std::current_exception();
        }
    if (failed) std::rethrow_exception(failed);
}

int flag_of(const Settings& settings, int code) {
    if (code == flag::none) return 0;
    if (code == flag::units) return settings.units.code;
    if (code == flag::most_elements) return settings.most_elements;
    require_known_flag(code);
    if (const auto digit = digit_of(settings, code)) return *digit;
    throw Refused(error_code::input, "Flag " + std::to_string(code) + " is not supported and is ignored.");
}

/// Returns [velocity, chi, dq, centre of spin along x and y, tau_c0], which programs use to draw a solution.
std::vector<double> picture_back(const ProblemCase& problem) {
    const Settings& settings = problem.settings;
    const Units& units = settings.units;
    double chi = settings.chi, dq = settings.dq.value_or(0);
    if (problem.current && problem.solved->solution.motion)
        if (const auto* rolling = std::get_if<Rolling>(&*problem.solved->solution.motion)) {
            chi = rolling->chi;
            dq = rolling->dq > 0 ? rolling->dq : problem.solved->problem.grid.dx;
        }
    const bool yields = settings.layer && settings.layer->yields();
    return {settings.velocity.value_or(usual_velocity) / units.length,
            chi,
            dq / units.length,
            settings.spin_x / units.length,
            settings.spin_y / units.length,
            yields ? settings.layer->yield_stress / units.stress() : 0};
}

std::vector<double> material_back(const Settings& settings) {
    if (!settings.materials) throw Refused(error_code::input, "No material was set; call cntc_setmaterialparameters.");
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
    if (!settings.friction) throw Refused(error_code::input, "No friction was set; call cntc_setfrictionmethod.");
    return numbers_of(*settings.friction, settings.units);
}

std::vector<double> parameters_of(const ProblemCase& problem, int task) {
    enum Task { picture = 1, material = 2, friction = 3 };
    switch (task) {
        case picture:
            return picture_back(problem);
        case material:
            return material_back(problem.settings);
        case friction:
            return friction_back(problem.settings);
        default:
            throw Refused(error_code::input, "itask is " + std::to_string(task) + "; it must be 1, 2 or 3.");
    }
}

}  // namespace

extern "C" void cntc_setglobalflags(int* lenflg, int* params, int* values) {
    answer("cntc_setglobalflags", [&] {
        const Pairs pairs(lenflg, params, values);
        for (std::size_t i = 0; i < pairs.codes.size(); ++i) set_global(pairs.codes[i], pairs.values[i]);
    });
}
CONTACTD_FORTRAN_NAME(cntc_setglobalflags)

extern "C" void cntc_setflags(int* ire, int* icp, int* lenflg, int* params, int* values) {
    answer("cntc_setflags", [&] {
        const Pairs pairs(lenflg, params, values);
        for_each_settings(ire, icp, [&](Settings& settings) { set_flags(settings, pairs); });
    });
}
CONTACTD_FORTRAN_NAME(cntc_setflags)

extern "C" void cntc_getflags(int* ire, int* icp, int* lenflg, int* params, int* values) {
    constexpr int unknown = -1;  // no flag has this value
    const bool writable = lenflg != nullptr && values != nullptr;
    for (int i = 0; writable && i < *lenflg; ++i) values[i] = unknown;
    get_set("cntc_getflags", ire, icp, [&](const ProblemCase& problem) {
        const Pairs pairs(lenflg, params, values);
        std::exception_ptr failed;
        for (std::size_t i = 0; i < pairs.codes.size(); ++i) try {
                values[i] = flag_of(problem.settings, pairs.codes[i]);
            } catch (...) {
                failed = std::current_exception();
            }
        if (failed) std::rethrow_exception(failed);
    });
}
CONTACTD_FORTRAN_NAME(cntc_getflags)

extern "C" void cntc_setmetadata(int* ire, int* icp, int* lenmta, int* params, double* values) {
    answer("cntc_setmetadata", [&] {
        const auto codes = integers(params, lenmta, 0, "params");
        const auto data = numbers(values, lenmta, 0, "values");
        for_each_settings(ire, icp, [&](Settings& settings) {
            for (std::size_t i = 0; i < codes.size(); ++i)
                if (codes[i] != flag::none) settings.metadata[codes[i]] = data[i];
        });
    });
}
CONTACTD_FORTRAN_NAME(cntc_setmetadata)

extern "C" void cntc_getparameters(int* ire, int* icp, int* itask, int* lenarr, double* values) {
    clear(values, lenarr);
    get("cntc_getparameters", ire, icp, [&](const ProblemCase& problem) {
        const auto found = parameters_of(problem, integer(itask, "itask"));
        std::ranges::copy(found, room(values, lenarr, found.size(), "values").begin());
    });
}
CONTACTD_FORTRAN_NAME(cntc_getparameters)
