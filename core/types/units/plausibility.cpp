#include "types/units/plausibility.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "types/units/plain_text.hpp"

namespace contactd {
namespace {

/// Describes a unit that values may be in by mistake, and its size in the unit of the field.
struct OtherUnit {
    std::string_view name{};
    double size = 0;
};

/// Describes doubtful values between `from` and `to`, which are both usual, and the message about them.
struct DoubtfulRange {
    Quantity quantity;
    double from, to;
    std::string_view unit;     ///< unit of the field; empty for ratios
    std::string_view meaning;  ///< follows the value
    std::string_view remedy;   ///< precedes the units in which it should not be given
    std::array<OtherUnit, 2> others;
};

constexpr double none = std::numeric_limits<double>::infinity();
constexpr OtherUnit nothing_else{};

constexpr std::array table{
    DoubtfulRange{Quantity::angle,
                  0.1,
                  none,
                  "rad",
                  "but wheelsets on rails rotate by hundredths of a radian",
                  "Give angles in rad",
                  {{{"degrees", std::numbers::pi / 180}, nothing_else}}},
    DoubtfulRange{Quantity::friction_coefficient,
                  2,
                  none,
                  "",
                  "but friction coefficients are below 2",
                  "Give it as a ratio",
                  {{{"percent", 0.01}, nothing_else}}},
    DoubtfulRange{Quantity::lateral_position,
                  5e-4,
                  0.015,
                  "mm",
                  "micrometres from the track centre",
                  "Give lengths in mm",
                  {{{"m", 1000}, nothing_else}}},
    DoubtfulRange{Quantity::lateral_amplitude,
                  0,
                  0.05,
                  "mm",
                  "smaller than any motion of a wheelset on its track",
                  "Give amplitudes in mm",
                  {{{"m", 1000}, nothing_else}}},
    DoubtfulRange{Quantity::contact_distance,
                  0,
                  20,
                  "mm",
                  "less than the distance of the rails of any track",
                  "Give it in mm",
                  {{{"m", 1000}, nothing_else}}},
    DoubtfulRange{Quantity::track_length,
                  0,
                  5,
                  "mm",
                  "less than a contact is long",
                  "Give places along the track in mm",
                  {{{"m", 1000}, nothing_else}}},
    DoubtfulRange{Quantity::vehicle_speed,
                  5,
                  slowest_vehicle,
                  "mm/s",
                  "slower than vehicles run",
                  "Give velocities in mm/s",
                  {{{"m/s", 1000}, {"km/h", 1e6 / 3600}}}},
    DoubtfulRange{Quantity::vertical_force,
                  0,
                  200,
                  "N",
                  "very small for a wheel",
                  "Give forces in N",
                  {{{"kN", 1000}, nothing_else}}},
    DoubtfulRange{Quantity::shear_modulus,
                  1e7,
                  none,
                  "N/mm^2",
                  "larger than that of any material",
                  "Give moduli in N/mm^2",
                  {{{"Pa", 1e-6}, nothing_else}}},
};

const DoubtfulRange& range_of(Quantity quantity) {
    return *std::ranges::find(table, quantity, &DoubtfulRange::quantity);
}

}  // namespace

bool is_doubtful(Quantity quantity, double value) {
    const DoubtfulRange& range = range_of(quantity);
    return std::abs(value) > range.from && std::abs(value) < range.to;
}

std::optional<std::string> doubt(Quantity quantity, std::string_view says, double value, std::string_view more) {
    if (!is_doubtful(quantity, value)) return {};
    const DoubtfulRange& range = range_of(quantity);
    const auto in_unit = [&](double number) {
        return range.unit.empty() ? plain_text(number) : plain_text(number) + " " + std::string(range.unit);
    };
    std::string names, values;
    for (const OtherUnit& other : range.others) {
        if (other.name.empty()) continue;
        names += (names.empty() ? "" : " or ") + std::string(other.name);
        values += (values.empty() ? "If it is in " : "; if in ") + std::string(other.name) +
                  (values.empty() ? ", it is " : ", ") + in_unit(value * other.size);
    }
    return std::string(says) + " " + in_unit(value) + ", " + std::string(range.meaning) + std::string(more) + ". " +
           std::string(range.remedy) + ", not in " + names + ". " + values + ".";
}

}  // namespace contactd
