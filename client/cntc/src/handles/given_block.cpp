#include "given_block.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "edge/arguments.hpp"
#include "edge/codes.hpp"
#include "edge/refused.hpp"

namespace contactd::cntc {
namespace {

bool layers(int kind) {
    return kind <= 3;
}

std::vector<double> across(int kind, const GivenArray& given, double length, const char* name) {
    if (all_centres(kind)) return {};
    auto values = numbers(given.values, given.count, range_of_elements(kind) ? 3 : 1, name);
    if (kind == 9)
        for (double& x : values) x *= length;
    else
        for (const double number : values) whole(number, name);
    return values;
}

std::vector<double> depths(int kind, const GivenArray& given, double length) {
    auto values = numbers(given.values, given.count, layers(kind) ? 3 : 1, "z");
    if (!layers(kind)) {
        for (double& z : values) z *= length;
        return values;
    }
    const int count = whole(values[0], "nz");
    constexpr int most = 100'000;
    if (count < 1 || count > most)
        throw Refused(error_code::input,
                      "nz is " + std::to_string(count) + "; it must be 1 to " + std::to_string(most) + ".");
    std::vector<double> z;
    for (int k = 0; k < count; ++k) z.push_back((values[1] + k * values[2]) * length);
    return z;
}

}  // namespace

GivenBlock read_block(int kind, const GivenArray& x, const GivenArray& y, const GivenArray& z, double length) {
    constexpr std::array kinds{1, 2, 3, 5, 6, 7, 9};
    if (std::ranges::find(kinds, kind) == kinds.end())
        throw Refused(error_code::input, "isubs is " + std::to_string(kind) + "; it must be 1, 2, 3, 5, 6, 7 or 9.");
    return {kind, across(kind, x, length, "x"), across(kind, y, length, "y"), depths(kind, z, length)};
}

}  // namespace contactd::cntc
