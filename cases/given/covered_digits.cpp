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
    int flag;                      ///< its code in the C library
    std::vector<int> basic;        ///< supported values in basic contact; empty if the digit has no effect there
    std::vector<int> on_rails;     ///< supported values for a wheel on a rail
    const char* why_not;           ///< the supported values in words
    const char* why_not_on_rails;  ///< the same for a wheel on a rail
};

const std::vector<Digit>& digits() {
    static const std::vector<Digit> all{
        {&Digits::configuration,
         "Control digit C1",
         1967,
         {},
         {0, 1, 4, 5},
         "",
         "Use 0 or 1 for a left or right wheel on a rail, or 4 or 5 for one on a roller"},
        {&Digits::previous,
         "Control digit P",
         1970,
         {0, 1, 2, 3},
         {0, 1, 2, 3},
         "Use 0 to continue from the last case, 2 to start anew, or 3 to repeat the last case",
         "Use 0 to continue from the last case, 2 to start anew, or 3 to repeat the last case"},
        {&Digits::bound,
         "Control digit B",
         1971,
         {0, 1, 2, 3, 4, 5, 6},
         {0, 1, 5, 6},
         "Use 0 for the full theory, 1 for a thin sheet from a file, 2 or 3 for Hertz's ellipse or parabola, 4 for two "
         "half ellipses, 5 for KPEC, or 6 for ANALYN",
         "For a wheel on a rail, use 0 for the full theory, 1 for a thin sheet from a file, 5 for KPEC, or 6 for "
         "ANALYN"},
        {&Digits::tangential,
         "Control digit T",
         1972,
         {0, 1, 2, 3},
         {0, 1, 2, 3},
         "Use 0, 1, 2 or 3",
         "Use 0, 1, 2 or 3"},
        {&Digits::normal, "Control digit N", 1973, {0, 1}, {0, 1}, "Use 0 or 1", "Use 0 or 1"},
        {&Digits::force,
         "Control digit F",
         1974,
         {0, 1, 2},
         {0, 1, 3},
         "Use 0, 1 or 2",
         "For a wheel on a rail, use 0, 1 for a longitudinal force, or 3 for a massless flexible rail"},
        {&Digits::friction_law,
         "Control digit L",
         1976,
         {0, 2, 3, 4, 6},
         {0, 2, 3, 4, 6},
         "Use 0, 2, 3, 4 or 6",
         "Use 0, 2, 3, 4 or 6"},
        {&Digits::discretisation,
         "Control digit D",
         1977,
         {},
         {2, 3, 4, 5},
         "",
         "For a wheel on a rail, use 2 for planar contact, 3 for planar contact with the slip of the surfaces, 4 for "
         "curved contact, or 5 for a search on a mesh"},
        {&Digits::influence,
         "Control digit C",
         1978,
         {2, 3, 9},
         {2, 4},
         "Use 2 or 3 for half-spaces with constant or bilinear tractions, or 9 for coefficients from a file",
         "For a wheel on a rail, use 2 for half-spaces, or 4 for half-spaces that rotate in a curved contact"},
        {&Digits::material,
         "Control digit M",
         1979,
         {0, 1, 3, 4, 5},
         {0, 3, 4, 5},
         "Use 0 for elastic bodies, 1 for viscoelastic bodies, 3 for FASTSIM, 4 for an interfacial layer, or 5 for "
         "FaStrip",
         "For a wheel on a rail, use 0 for elastic bodies, 3 for FASTSIM, 4 for an interfacial layer, or 5 for "
         "FaStrip"},
        {&Digits::extra_slip,
         "Control digit E",
         1980,
         {0, 1, 2, 3, 9},
         {0},
         "Use 0 for none, 2 or 3 for spin along x or y alone, or 1 or 9 for a rigid slip of each element",
         "A wheel on a rail has no extra rigid slip. Use 0"},
        {&Digits::heat,
         "Control digit H",
         1982,
         {0, 1, 3},
         {0, 1, 3},
         "Use 0 for none, or 1 or 3 for temperatures",
         "Use 0 for none, or 1 or 3 for temperatures"},
        {&Digits::estimate,
         "Control digit I",
         1983,
         {0, 1, 2, 3},
         {0, 1, 2, 3},
         "Use 0 for no estimate, or 1, 2 or 3 for one from the previous case",
         "Use 0 for no estimate, or 1, 2 or 3 for one from the previous case"},
        {&Digits::result, "Control digit R", 1986, {0, 1, 2, 3}, {0, 1, 2, 3}, "Use 0, 1, 2 or 3", "Use 0, 1, 2 or 3"},
        {&Digits::sensitivities,
         "Control digit S",
         1988,
         {0, 1, 2, 3},
         {0, 1, 2, 3},
         "Use 0, 1, 2 or 3",
         "Use 0, 1, 2 or 3"},
        {&Digits::variant, "VARIANT", 1990, {}, {1, 2, 3, 4}, "", "Use 3 or 4"},
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
        throw NotCovered(Subject::input, std::string(digit_of(digit).name) + " = " + std::to_string(value) + " (flag " +
                                             std::to_string(digit_of(digit).flag) + ") is not supported. " + reason +
                                             ".");
    digits.*digit = value;
}

}  // namespace contactd::cases
