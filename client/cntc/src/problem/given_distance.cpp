#include "given_distance.hpp"

#include <array>
#include <cstddef>
#include <string>

#include "edge/arguments.hpp"
#include "edge/codes.hpp"

namespace contactd::cntc {
namespace {

/// [number, xm, rm, y1, dy1, and so many heights].
RoundProfile round_profile_of(const double* prmudf, const int* nparam, const Units& units) {
    constexpr int before_heights = 5;
    auto given = numbers(prmudf, nparam, before_heights, "prmudf");
    const int count = whole(given[0], "the number of heights");
    if (count < 1 || given.size() != static_cast<std::size_t>(before_heights) + static_cast<std::size_t>(count))
        throw Refused(error_code::input, "prmudf has " + std::to_string(given.size()) + " values; ibase 2 has 5, and " +
                                             std::to_string(count) + " heights, of which there must be one at least.");
    for (double& value : given) value *= units.length;
    if (given[2] == 0) throw Refused(error_code::input, "rm = 0: the radius along x must not be zero.");
    if (count > 1) positive(given[4], "dy1");
    return {given[1], given[2], given[3], given[4], {given.begin() + before_heights, given.end()}};
}

/// [b1, .. b8]: amplitudes, numbers of waves, phases and radii.
Waves waves_of(const std::vector<double>& given, const Units& units) {
    Waves waves;
    for (std::size_t i = 0; i < waves.b.size(); ++i) {
        const bool is_wavenumber = i == 1 || i == 4;
        waves.b[i] = given[i] * (is_wavenumber ? units.curvature() : units.length);
    }
    if (waves.b[6] == 0 || waves.b[7] == 0)
        throw Refused(error_code::input, "b7 or b8 is 0: they are radii. Give a large one where a direction is flat.");
    return waves;
}

}  // namespace

Distance read_distance(int base, const double* prmudf, const int* nparam, const Units& units) {
    constexpr int quadratic = 1, round_profile = 2, waves = 3, of_elements = 9;
    if (base != quadratic && base != round_profile && base != waves && base != of_elements)
        throw Refused(error_code::input, "ibase is " + std::to_string(base) + "; contactd has 1, 2, 3 and 9.");
    if (base == round_profile) return round_profile_of(prmudf, nparam, units);
    if (base == waves) return waves_of(list(prmudf, nparam, 8, "prmudf"), units);
    if (base == of_elements) {
        auto given = numbers(prmudf, nparam, 1, "prmudf");
        for (double& h : given) h *= units.length;
        return given;
    }
    const auto given = list(prmudf, nparam, 6, "prmudf");
    Quadratic h;
    const double curved = units.curvature(), flat = 1;
    const std::array<double, 6> scales{curved, curved, curved, flat, flat, units.length};
    for (std::size_t i = 0; i < scales.size(); ++i) h.b[i] = given[i] * scales[i];
    return h;
}

}  // namespace contactd::cntc
