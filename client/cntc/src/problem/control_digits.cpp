#include "control_digits.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "edge/codes.hpp"
#include "edge/refused.hpp"

namespace contactd::cntc {
namespace {

struct Digit {
    int code;
    int value;                     ///< at the start
    std::vector<int> covered;      ///< of basic contact; none: the code means nothing there
    std::vector<int> on_rails;     ///< of wheel on rail
    const char* why_not;           ///< of other values
    const char* why_not_on_rails;  ///< the same there
};

const std::vector<Digit>& digits() {
    static const std::vector<Digit> all{
        {flag::configuration, 0, {}, {0, 1, 4, 5}, "", "it is 0, 1, 4 or 5: left or right, on rails or on rollers"},
        {flag::previous,
         2,
         {0, 1, 2, 3},
         {0, 1, 2, 3},
         "0 continues from the last case, 2 starts anew, and 3 repeats the last case",
         "0 continues from the last case, 2 starts anew, and 3 repeats the last case"},
        {flag::bound,
         0,
         {0, 2, 3, 4, 5, 6},
         {0, 5, 6},
         "it is 0 for pressures of the full theory, 2 or 3 for the ellipse or parabola of Hertz's contact, 4 for two "
         "half ellipses, 5 for KPEC, or 6 for ANALYN",
         "of a wheel on a rail it is 0 for pressures of the full theory, 5 for KPEC, or 6 for ANALYN"},
        {flag::tangential, 3, {0, 1, 2, 3}, {0, 1, 2, 3}, "it is 0, 1, 2 or 3", "it is 0, 1, 2 or 3"},
        {flag::normal, 1, {0, 1}, {0, 1}, "it is 0 or 1", "it is 0 or 1"},
        {flag::force,
         0,
         {0, 1, 2},
         {0, 1, 3},
         "it is 0, 1 or 2",
         "of a wheel on a rail it is 0, 1 for a longitudinal force, or 3 for a massless flexible rail"},
        {flag::friction_law,
         0,
         {0, 2, 3, 4, 6},
         {0, 2, 3, 4, 6},
         "contactd has the laws 0, 2, 3, 4 and 6",
         "contactd has the laws 0, 2, 3, 4 and 6"},
        {flag::discretisation,
         2,
         {},
         {2, 3, 4, 5},
         "",
         "contactd has planes (2), planes with the slip of the surfaces (3), curved contact (4) and a search on a mesh "
         "(5)"},
        {flag::influence,
         2,
         {2, 3},
         {2, 4},
         "contactd has half-spaces here, 2 with constant and 3 with bilinear tractions",
         "of a wheel on a rail contactd has half-spaces (2), and those that turn where the contact is curved (4)"},
        {flag::material,
         0,
         {0, 1, 3, 4, 5},
         {0, 3, 4, 5},
         "contactd has elastic bodies here, 0, viscoelastic ones, 1, elastic ones with an interfacial layer, 4, and of "
         "these the simplified theory by FASTSIM, 3, or FaStrip, 5",
         "contactd has elastic bodies here, 0, with an interfacial layer, 4, and of these the simplified theory by "
         "FASTSIM, 3, or FaStrip, 5"},
        {flag::extra_slip,
         0,
         {0, 1, 9},
         {0},
         "it is 0, or 1 or 9 for a rigid slip of each element",
         "a wheel on a rail has no extra rigid slip"},
        {flag::heat,
         0,
         {0, 1, 3},
         {0, 1, 3},
         "it is 0 for none, or 1 or 3 for temperatures",
         "it is 0 for none, or 1 or 3 for temperatures"},
        {flag::estimate,
         0,
         {0, 1, 2, 3},
         {0, 1, 2, 3},
         "it is 0, or 1 to 3 for the previous case",
         "it is 0, or 1 to 3 for the previous case"},
        {flag::result, 0, {0, 1, 2, 3}, {0, 1, 2, 3}, "it is 0, 1, 2 or 3", "it is 0, 1, 2 or 3"},
        {flag::sensitivities, 0, {0, 1, 2, 3}, {0, 1, 2, 3}, "it is 0, 2 or 3", "it is 0, 2 or 3"},
        {flag::variant, 4, {}, {1, 2, 3, 4}, "", "variants of half-spaces that turn are 1 to 4"},
    };
    return all;
}

const Digit* find(int code) {
    const auto found = std::ranges::find(digits(), code, &Digit::code);
    return found == digits().end() ? nullptr : &*found;
}

const std::vector<int>& values_of(const Digit& digit, int module) {
    return module == module_number::basic_contact ? digit.covered : digit.on_rails;
}

/// Output, limits and threads of the other program.
bool means_nothing(int code) {
    static constexpr std::array codes{1981, 1984, 1985, 1987, 1989, 1991, 1992, flag::most_elements};
    return std::ranges::find(codes, code) != codes.end() || (code >= 2000 && code <= 2009);
}

}  // namespace

ControlDigits::ControlDigits(int module) : module_(module) {
    for (const Digit& digit : digits())
        if (!values_of(digit, module).empty()) values_[digit.code] = digit.value;
}

void ControlDigits::require_known(int code) {
    if (code == flag::units || means_nothing(code) || find(code) != nullptr) return;
    throw Refused(error_code::input, "Flag " + std::to_string(code) + " is not known; it has no effect.");
}

void ControlDigits::set(int code, int value) {
    const Digit* digit = find(code);
    if (digit == nullptr || !knows(code)) return;
    const bool on_rails = module_ != module_number::basic_contact;
    const bool keeps = value == 0 || value == 1;
    if (keeps && (code == flag::discretisation || code == flag::influence)) return;
    const std::vector<int>& covered = values_of(*digit, module_);
    if (std::ranges::find(covered, value) == covered.end())
        throw Refused(error_code::input, "Flag " + std::to_string(code) + " is " + std::to_string(value) + "; " +
                                             (on_rails ? digit->why_not_on_rails : digit->why_not) + ".");
    values_[code] = value;
}

}  // namespace contactd::cntc
