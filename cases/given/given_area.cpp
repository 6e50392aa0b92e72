#include "given_area.hpp"

#include <array>
#include <cstddef>
#include <string>

#include "contactd/contact.hpp"
#include "given/checks.hpp"
#include "given/not_covered.hpp"

namespace contactd::cases {
namespace {

constexpr int of_halves = -6;
enum Base { quadratic = 1, round_profile = 2, waves = 3, of_elements = 9 };

constexpr const char* options_of_basic_contact =
    "Use -6 to -1 for a Hertzian contact (cntc_sethertzcontact), or 1 to 4 for a rectangle (cntc_setpotcontact)";

[[noreturn]] void refuse_option(int option, const char* cure) {
    throw NotCovered(Subject::discretisation,
                     "IPOTCN = " + std::to_string(option) + " is not supported here. " + cure + ".");
}

struct Elements {
    int mx, my;
};

Elements elements(const std::vector<double>& given) {
    const Elements result{whole(given[0], "MX"), whole(given[1], "MY")};
    if (result.mx < 1 || result.my < 1 || static_cast<double>(result.mx) * result.my > double{max_grid_elements})
        throw NotCovered(Subject::discretisation,
                         "MX = " + std::to_string(result.mx) + ", MY = " + std::to_string(result.my) +
                             ": both must be at least 1, and MX MY at most " + std::to_string(max_grid_elements) + ".");
    return result;
}

/// Reads two half ellipses from [mx, my, a, b towards -y, b towards +y, scale].
HertzArea half_ellipses(const std::vector<double>& given, const Units& units) {
    const auto [mx, my] = elements(given);
    const double a = positive(given[2], "AA") * units.length, negative = positive(given[3], "BNEG") * units.length,
                 towards_y = positive(given[4], "BPOS") * units.length;
    return {of_halves, mx, my, a, (negative + towards_y) / 2, positive(given[5], "SCALE"), negative, towards_y};
}

/// Holds the lower edge of the grid and the size of an element along one axis (mm).
struct Interval {
    double low, size;
};

/// Returns the interval from an edge or a centre `from`, and the opposite one or the element size `to`.
Interval interval(int option, int elements, double from, double to) {
    const bool of_centres = option >= 3, by_size = option == 1 || option == 3;
    if (option == 4 && elements < 2)
        throw NotCovered(Subject::discretisation,
                         "IPOTCN = 4 requires MX and MY of at least 2, because the first and the last centre determine "
                         "the size of the elements. Use IPOTCN = 1, 2 or 3.");
    const double size = by_size ? to : (to - from) / (of_centres ? elements - 1 : elements);
    return {of_centres ? from - size / 2 : from, size};
}

/// Reads a profile from [number of heights, xm, rm, y1, dy1, heights].
RoundProfile round_profile_of(std::vector<double> given, const Units& units) {
    constexpr std::size_t before_heights = 5;
    const int count = whole(given[0], "NN");
    if (count < 1 || given.size() != before_heights + static_cast<std::size_t>(count))
        throw NotCovered(Subject::input, "IBASE = 2 requires NN, XM, RM, Y1, DY1 and NN >= 1 heights, but NN = " +
                                             std::to_string(count) + ", and there are " + std::to_string(given.size()) +
                                             " values (prmudf of cntc_setundeformeddistc).");
    for (double& value : given) value *= units.length;
    if (given[2] == 0) throw NotCovered(Subject::input, "RM = 0: the radius along x must not be zero.");
    if (count > 1) positive(given[4], "DY1");
    return {given[1], given[2], given[3], given[4], {given.begin() + before_heights, given.end()}};
}

/// Reads waves from [b1, .. b8]: amplitudes, wavenumbers, phases and radii.
Waves waves_of(const std::vector<double>& given, const Units& units) {
    Waves waves;
    for (std::size_t i = 0; i < waves.b.size(); ++i) {
        const bool is_wavenumber = i == 1 || i == 4;
        waves.b[i] = given[i] * (is_wavenumber ? units.curvature() : units.length);
    }
    if (waves.b[6] == 0 || waves.b[7] == 0)
        throw NotCovered(Subject::input, "B7 or B8 is 0, but both are radii. Use a large radius for a flat direction.");
    return waves;
}

}  // namespace

HertzArea hertz_area(int option, const std::vector<double>& numbers, const Units& units) {
    if (option < of_halves || option > -1) refuse_option(option, options_of_basic_contact);
    if (option == of_halves) return half_ellipses(numbers, units);
    const auto [mx, my] = elements(numbers);
    const double first_unit = option == -3 || option == -5 ? units.length : units.curvature();
    const double second_unit = option == -1 ? units.curvature() : option == -2 ? 1 : units.length;
    return {option,
            mx,
            my,
            positive(numbers[2], option == -3 || option == -5 ? "AA" : "A1") * first_unit,
            positive(numbers[3], option == -1   ? "B1"
                                 : option == -2 ? "AOB"
                                                : "BB") *
                second_unit,
            positive(numbers[4], "SCALE")};
}

Grid potential_contact(int option, const std::vector<double>& numbers, const Units& units) {
    if (option < 1 || option > 4) refuse_option(option, options_of_basic_contact);
    const auto [mx, my] = elements(numbers);
    const Interval x = interval(option, mx, numbers[2] * units.length, numbers[4] * units.length);
    const Interval y = interval(option, my, numbers[3] * units.length, numbers[5] * units.length);
    const Grid grid{mx, my, x.size, y.size, x.low, y.low};
    validate(grid, "grid");
    return grid;
}

GivenElements rail_elements(int option, const std::vector<double>& numbers, const Units& units) {
    if (option != 0 && option != -1) refuse_option(option, "For a wheel on a rail, use 0 or -1 (cntc_setpotcontact)");
    const double mm = units.length;
    GivenElements elements;
    elements.dx = positive(numbers[0], "DX") * mm;
    elements.ds = positive(numbers[1], "DS") * mm;
    if (option == 0) return elements;
    for (const std::size_t i : {2, 3, 4})
        if (numbers[i] < 0) throw NotCovered(Subject::discretisation, "A_SEP, D_SEP and D_COMB must be at least 0.");
    elements.angle_separate = numbers[2];
    elements.separate = numbers[3] * mm;
    elements.combine = numbers[4] * mm;
    elements.turn = numbers.size() > 5 ? numbers[5] * mm : 2 * elements.separate - elements.combine;
    return elements;
}

int distance_numbers(int base) {
    switch (base) {
        case quadratic:
            return 6;
        case round_profile:
            return 5;
        case waves:
            return 8;
        case of_elements:
            return 1;
        default:
            return 0;
    }
}

Distance given_distance(int base, std::vector<double> numbers, const Units& units) {
    if (base == round_profile) return round_profile_of(std::move(numbers), units);
    if (base == waves) return waves_of(numbers, units);
    if (base == of_elements) {
        for (double& h : numbers) h *= units.length;
        return numbers;
    }
    if (base != quadratic)
        throw NotCovered(Subject::input, "IBASE = " + std::to_string(base) + " is not supported. Use 1, 2, 3 or 9.");
    Quadratic h;
    const double curved = units.curvature(), flat = 1;
    const std::array<double, 6> scales{curved, curved, curved, flat, flat, units.length};
    for (std::size_t i = 0; i < scales.size(); ++i) h.b[i] = numbers[i] * scales[i];
    return h;
}

}  // namespace contactd::cases
