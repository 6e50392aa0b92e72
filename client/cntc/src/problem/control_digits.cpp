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
    int value;  ///< at the start
    std::vector<int> covered;
    const char* why_not;  ///< of other values
};

const std::vector<Digit>& digits() {
    static const std::vector<Digit> all{
        {flag::previous, 2, {0, 2}, "0 continues from the last case, and 2 starts anew"},
        {flag::bound, 0, {0}, "the bound of friction follows from the pressures; contactd has no other here"},
        {flag::tangential, 3, {0, 1, 2, 3}, "it is 0, 1, 2 or 3"},
        {flag::normal, 1, {0, 1}, "it is 0 or 1"},
        {flag::force, 0, {0, 1, 2}, "it is 0, 1 or 2"},
        {flag::friction_law, 0, {0, 2, 4}, "contactd has the laws 0, 2 and 4"},
        {flag::influence, 2, {2, 3}, "contactd has half-spaces here, 2 with constant and 3 with bilinear tractions"},
        {flag::material, 0, {0}, "contactd has elastic bodies here, 0"},
        {flag::extra_slip, 0, {0, 9}, "it is 0, or 9 for a rigid slip of each element"},
        {flag::heat, 0, {0}, "contactd computes no temperatures"},
        {flag::estimate, 0, {0, 3}, "it is 0, or 3 for the previous case"},
        {flag::result, 0, {0, 1, 2, 3}, "it is 0, 1, 2 or 3"},
        {flag::sensitivities, 0, {0, 2, 3}, "it is 0, 2 or 3"},
    };
    return all;
}

const Digit* find(int code) {
    const auto found = std::ranges::find(digits(), code, &Digit::code);
    return found == digits().end() ? nullptr : &*found;
}

/// Output, limits and threads of the other program, and its control of wheel on rail.
bool means_nothing(int code) {
    static constexpr std::array codes{1967, 1977, 1981, 1984, 1985, 1987, 1989, 1990, 1991, 1992, 1993};
    return std::ranges::find(codes, code) != codes.end() || (code >= 2000 && code <= 2009);
}

}  // namespace

ControlDigits::ControlDigits() {
    for (const Digit& digit : digits()) values_[digit.code] = digit.value;
}

void ControlDigits::require_known(int code) {
    if (code == flag::units || means_nothing(code) || find(code) != nullptr) return;
    throw Refused(error_code::input, "Flag " + std::to_string(code) + " is not known; it has no effect.");
}

void ControlDigits::set(int code, int value) {
    const Digit* digit = find(code);
    if (digit == nullptr) return;
    if (std::ranges::find(digit->covered, value) == digit->covered.end())
        throw Refused(error_code::input,
                      "Flag " + std::to_string(code) + " is " + std::to_string(value) + "; " + digit->why_not + ".");
    values_[code] = value;
}

}  // namespace contactd::cntc
