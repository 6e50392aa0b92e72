// Flags, which control a solve: pairs of code and value.
#include <span>

#include "interface/entry.hpp"

using namespace contactd::cntc;

namespace {

struct Pairs {
    std::span<const int> codes, values;

    Pairs(const int* count, const int* codes_, const int* values_)
        : codes(integers(codes_, count, 0, "params")), values(integers(values_, count, 0, "values")) {}
};

/// Those that hold for all problems of the process.
void set_global(int code, int value) {
    if (code == flag::own_output) print_errors(value > 0);
}

Units units_of(int code) {
    for (const Units& units : {units_mm_on_body_1, units_m_on_body_2, units_m_on_body_1})
        if (units.code == code) return units;
    throw Refused(error_code::input, "Flag 1933 is " + std::to_string(code) + "; units are 1934, 1935 or 1936.");
}

void set_flag(Settings& settings, int code, int value) {
    ControlDigits::require_known(code);
    set_global(code, value);
    set_part(settings, "flag " + std::to_string(code), [&](Settings& all) {
        if (code == flag::units)
            all.units = units_of(value);
        else
            all.digits.set(code, value);
    });
}

/// All of them, whatever becomes of one.
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
    ControlDigits::require_known(code);
    if (!settings.digits.knows(code))
        throw Refused(error_code::input, "Flag " + std::to_string(code) + " has no effect, and is not kept.");
    return settings.digits(code);
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
    get_set("cntc_getflags", ire, icp, [&](const ContactCase& problem) {
        const Pairs pairs(lenflg, params, values);
        for (std::size_t i = 0; i < pairs.codes.size(); ++i) values[i] = flag_of(problem.settings, pairs.codes[i]);
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
