#include "control_digits.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "given/covered_digits.hpp"

namespace contactd::cntc {
namespace {

struct Flag {
    int code;
    int Digits::* digit;
};

constexpr std::array flags{
    Flag{flag::configuration, &Digits::configuration},
    Flag{flag::previous, &Digits::previous},
    Flag{flag::bound, &Digits::bound},
    Flag{flag::tangential, &Digits::tangential},
    Flag{flag::normal, &Digits::normal},
    Flag{flag::force, &Digits::force},
    Flag{flag::friction_law, &Digits::friction_law},
    Flag{flag::discretisation, &Digits::discretisation},
    Flag{flag::influence, &Digits::influence},
    Flag{flag::material, &Digits::material},
    Flag{flag::extra_slip, &Digits::extra_slip},
    Flag{flag::heat, &Digits::heat},
    Flag{flag::estimate, &Digits::estimate},
    Flag{flag::result, &Digits::result},
    Flag{flag::sensitivities, &Digits::sensitivities},
    Flag{flag::variant, &Digits::variant},
};

const Flag* find(int code) {
    const auto found = std::ranges::find(flags, code, &Flag::code);
    return found == flags.end() ? nullptr : &*found;
}

bool on_rails(const Settings& settings) {
    return settings.module != module_number::basic_contact;
}

/// Returns whether the code concerns output, limits or threads of the other program.
bool means_nothing(int code) {
    static constexpr std::array codes{1981, 1984, 1985, 1987, 1989, 1991, 1992, flag::most_elements};
    return std::ranges::find(codes, code) != codes.end() || (code >= 2000 && code <= 2009);
}

/// Returns whether the value requires numbers that no function accepts: those of a thin sheet, or coefficients from a
/// file.
bool is_of_files(int code, int value) {
    return (code == flag::bound && value == 1) || (code == flag::influence && value == 9);
}

}  // namespace

std::optional<int> digit_of(const Settings& settings, int code) {
    const Flag* known = find(code);
    if (known == nullptr || !has_meaning(known->digit, on_rails(settings))) return std::nullopt;
    return settings.digits.*known->digit;
}

void require_known_flag(int code) {
    if (code == flag::units || means_nothing(code) || find(code) != nullptr) return;
    throw Refused(error_code::input, "Flag " + std::to_string(code) + " is unknown and has no effect.");
}

void set_flag_digit(Settings& settings, int code, int value) {
    if (!digit_of(settings, code)) return;
    const bool keeps = value == 0 || value == 1;
    if (keeps && (code == flag::discretisation || code == flag::influence)) return;
    const auto digit = find(code)->digit;
    if (is_of_files(code, value) && settings.digits.*digit != value)
        throw Refused(error_code::input, "Flag " + std::to_string(code) + " = " + std::to_string(value) +
                                             " requires data that only an input file can set. Call cntc_readinpfile.");
    if (const char* reason = why_not_covered(digit, value, on_rails(settings)))
        throw Refused(error_code::input, "Flag " + std::to_string(code) + " = " + std::to_string(value) +
                                             " is not supported. " + reason + ".");
    settings.digits.*digit = value;
}

}  // namespace contactd::cntc
