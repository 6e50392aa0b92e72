#include "covered_digits.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "given/not_covered.hpp"

namespace contactd::cases {
namespace {

struct Digit {
    int Digits::* member;
    const char* name;
    std::vector<int> basic;        ///< values that are covered; none: the digit means nothing there
    std::vector<int> on_rails;     ///< of a wheel on a rail
    const char* why_not;           ///< of other values
    const char* why_not_on_rails;  ///< the same there
};

const std::vector<Digit>& digits() {
    static const std::vector<Digit> all{
        {&Digits::configuration,
         "C1",
         {},
         {0, 1, 4, 5},
         "",
         "it is 0, 1, 4 or 5: left or right, on rails or on rollers"},
        {&Digits::previous,
         "P",
         {0, 1, 2, 3},
         {0, 1, 2, 3},
         "0 continues from the last case, 2 starts anew, and 3 repeats the last case",
         "0 continues from the last case, 2 starts anew, and 3 repeats the last case"},
        {&Digits::bound,
         "B",
         {0, 1, 2, 3, 4, 5, 6},
         {0, 1, 5, 6},
         "it is 0 for pressures of the full theory, 1 for a thin sheet that a file sets, 2 or 3 for the ellipse or "
         "parabola of Hertz's contact, 4 for two "
         "half ellipses, 5 for KPEC, or 6 for ANALYN",
         "of a wheel on a rail it is 0 for pressures of the full theory, 1 for a thin sheet that a file sets, 5 for "
         "KPEC, or 6 for ANALYN"},
        {&Digits::tangential, "T", {0, 1, 2, 3}, {0, 1, 2, 3}, "it is 0, 1, 2 or 3", "it is 0, 1, 2 or 3"},
        {&Digits::normal, "N", {0, 1}, {0, 1}, "it is 0 or 1", "it is 0 or 1"},
        {&Digits::force,
         "F",
         {0, 1, 2},
         {0, 1, 3},
         "it is 0, 1 or 2",
         "of a wheel on a rail it is 0, 1 for a longitudinal force, or 3 for a massless flexible rail"},
        {&Digits::friction_law,
         "L",
         {0, 2, 3, 4, 6},
         {0, 2, 3, 4, 6},
         "contactd has the laws 0, 2, 3, 4 and 6",
         "contactd has the laws 0, 2, 3, 4 and 6"},
        {&Digits::discretisation,
         "D",
         {},
         {2, 3, 4, 5},
         "",
         "contactd has planes (2), planes with the slip of the surfaces (3), curved contact (4) and a search on a mesh "
         "(5)"},
        {&Digits::influence,
         "C",
         {2, 3, 9},
         {2, 4},
         "contactd has half-spaces here, 2 with constant and 3 with bilinear tractions, and 9 for coefficients from a "
         "file",
         "of a wheel on a rail contactd has half-spaces (2), and those that turn where the contact is curved (4)"},
        {&Digits::material,
         "M",
         {0, 1, 3, 4, 5},
         {0, 3, 4, 5},
         "contactd has elastic bodies here, 0, viscoelastic ones, 1, elastic ones with an interfacial layer, 4, and of "
         "these the simplified theory by FASTSIM, 3, or FaStrip, 5",
         "contactd has elastic bodies here, 0, with an interfacial layer, 4, and of these the simplified theory by "
         "FASTSIM, 3, or FaStrip, 5"},
        {&Digits::extra_slip,
         "E",
         {0, 1, 2, 3, 9},
         {0},
         "it is 0, 2 or 3 for spin that acts along x or y alone, or 1 or 9 for a rigid slip of each element",
         "a wheel on a rail has no extra rigid slip"},
        {&Digits::heat,
         "H",
         {0, 1, 3},
         {0, 1, 3},
         "it is 0 for none, or 1 or 3 for temperatures",
         "it is 0 for none, or 1 or 3 for temperatures"},
        {&Digits::estimate,
         "I",
         {0, 1, 2, 3},
         {0, 1, 2, 3},
         "it is 0, or 1 to 3 for the previous case",
         "it is 0, or 1 to 3 for the previous case"},
        {&Digits::result, "R", {0, 1, 2, 3}, {0, 1, 2, 3}, "it is 0, 1, 2 or 3", "it is 0, 1, 2 or 3"},
        {&Digits::sensitivities, "S", {0, 1, 2, 3}, {0, 1, 2, 3}, "it is 0, 2 or 3", "it is 0, 2 or 3"},
        {&Digits::variant, "VARIANT", {}, {1, 2, 3, 4}, "", "variants of half-spaces that turn are 1 to 4"},
    };
    return all;
}

const Digit& digit_of(int Digits::* member) {
    return *std::ranges::find(digits(), member, &Digit::member);
}

const std::vector<int>& values_of(const Digit& digit, bool on_rails) {
    return on_rails ? digit.on_rails : digit.basic;
}

}  // namespace

bool has_meaning(int Digits::* digit, bool on_rails) {
    return !values_of(digit_of(digit), on_rails).empty();
}

const char* why_not_covered(int Digits::* digit, int value, bool on_rails) {
    const Digit& found = digit_of(digit);
    const std::vector<int>& covered = values_of(found, on_rails);
    if (std::ranges::find(covered, value) != covered.end()) return nullptr;
    return on_rails ? found.why_not_on_rails : found.why_not;
}

void set_digit(Digits& digits, int Digits::* digit, int value, bool on_rails) {
    if (const char* reason = why_not_covered(digit, value, on_rails))
        throw NotCovered(Subject::input,
                         std::string(digit_of(digit).name) + " = " + std::to_string(value) + ": " + reason + ".");
    digits.*digit = value;
}

}  // namespace contactd::cases
