#include "wheel_rail/units.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "types/number_text.hpp"
#include "types/units/plain_text.hpp"
#include "types/units/plausibility.hpp"

namespace contactd {
namespace {

constexpr double stiffest = 1.2e5;  // N/mm^2: shear moduli of steels and irons are 4e4 to 8.5e4
constexpr double smallest = 150;    // mm: radius of a vehicle's wheel; those of models carry less, and roll more slowly

using Sentences = std::vector<std::string>;

void add(Sentences& sentences, std::optional<std::string> sentence) {
    if (sentence) sentences.push_back(std::move(*sentence));
}

void warn_of_modulus(const std::string& name, const Material& material, Sentences& warnings) {
    if (material.is_rigid() || material.G < stiffest) return;
    const std::string says = "bodies." + name + ".G is";
    if (is_doubtful(Quantity::shear_modulus, material.G))
        add(warnings, doubt(Quantity::shear_modulus, says, material.G));
    else
        warnings.push_back(
            says + " " + number_text(material.G) +
            " N/mm^2, larger than that of steel. Give the shear modulus, not Young's modulus: E/(2 (1 + nu)) "
            "would be " +
            number_text(std::round(material.G / (2 * (1 + material.nu)))) + " N/mm^2.");
}

void warn_of_slices(const WheelRailSetup& setup, Sentences& warnings) {
    const auto& slices = setup.rail_slices;
    if (slices.empty()) return;
    const double length = slices.back().x - slices.front().x;
    add(warnings, doubt(Quantity::track_length, "The distance from rail_slices[0] to the last one is", length));
}

bool is_of_vehicle(const WheelRailSetup& setup) {
    return setup.wheelset.nominal_radius > smallest;
}

/// Returns the speed of the rim about its axle (mm/s).
double rim_speed(const WheelRailSetup& setup, const WheelRailState& state) {
    return std::abs(state.velocity.pitch) * setup.wheelset.nominal_radius;
}

bool is_near(double value, double expected) {
    constexpr double largest_slide = 0.1;
    return std::abs(value / expected - 1) < largest_slide;
}

/// Warns of slices that are closer together than elements, with a wheel that is a thousand times as far away.
void warn_of_place(const WheelRailSetup& setup, const WheelRailState& state, Sentences& warnings) {
    constexpr double closest = 2, metre = 1000;  // mm
    const auto& slices = setup.rail_slices;
    if (slices.empty()) return;
    const double x = state.position.x, first = slices.front().x, last = slices.back().x;
    const auto has = [&](double place) { return place >= first && place <= last; };
    if (last - first > closest * static_cast<double>(slices.size() - 1) || has(x) || !has(x / metre)) return;
    warnings.push_back("position.x is " + plain_text(x) +
                       " mm, beyond rail_slices, which lie from x = " + plain_text(first) + " to " + plain_text(last) +
                       " mm and hold " + plain_text(x / metre) + ". Give places along the track in mm, not in m.");
}

}  // namespace

std::vector<std::string> unit_warnings(const WheelRailSetup& setup) {
    Sentences warnings;
    warn_of_slices(setup, warnings);
    if (setup.friction && !setup.friction->mu.empty())
        add(warnings, doubt(Quantity::friction_coefficient, "friction.mu is up to",
                            std::ranges::max_element(setup.friction->mu, {}, &FrictionAtAngle::mu)->mu));
    if (setup.bodies.pair) return warnings;
    warn_of_modulus("upper", setup.bodies.upper.material, warnings);
    if (setup.bodies.lower.material != setup.bodies.upper.material)
        warn_of_modulus("lower", setup.bodies.lower.material, warnings);
    return warnings;
}

std::vector<std::string> unit_warnings(const WheelRailSetup& setup, const WheelRailState& state) {
    Sentences warnings;
    for (const auto& [name, angle] :
         {std::pair("position.roll is", state.position.roll), std::pair("position.yaw is", state.position.yaw),
          std::pair("wheel.roll is", state.wheel.roll), std::pair("wheel.yaw is", state.wheel.yaw),
          std::pair("rail.roll is", state.rail.roll)})
        add(warnings, doubt(Quantity::angle, name, angle));
    if (state.Fz && *state.Fz > 0 && is_of_vehicle(setup))
        add(warnings, doubt(Quantity::vertical_force, "Fz is", *state.Fz,
                            " of radius " + short_text(setup.wheelset.nominal_radius) + " mm"));
    warn_of_place(setup, state, warnings);
    return warnings;
}

std::vector<std::string> unit_warnings_of_one(const WheelRailSetup& setup, const WheelRailState& state) {
    Sentences warnings;
    add(warnings, doubt(Quantity::lateral_position, "position.y is", state.position.y));
    const double speed = state.velocity.x;
    const bool rolls = state.Fx || is_near(rim_speed(setup, state), std::abs(speed));
    if (rolls && is_of_vehicle(setup) && !setup.track.roller_radius && state.motion != WheelRailMotion::shift)
        add(warnings, doubt(Quantity::vehicle_speed, "velocity.x is", speed));
    return warnings;
}

std::string unit_of_speed(const WheelRailSetup& setup, const WheelRailState& state) {
    constexpr double metre = 1000, km_per_h = 1e6 / 3600, walking = 1000;  // mm/s
    const double speed = std::abs(state.velocity.x), ratio = rim_speed(setup, state) / speed;
    if (!(speed > 0) || setup.track.roller_radius) return {};
    const std::string value = plain_text(state.velocity.x);
    if (is_near(ratio, metre) && speed > walking)
        return " velocity.pitch = " + plain_text(state.velocity.pitch) + " rad/s fits a nominal_radius in m.";
    for (const auto& [unit, size] : {std::pair("m/s", metre), std::pair("km/h", km_per_h)})
        if (is_near(ratio, size))
            return " velocity.x = " + value + " mm/s fits that rate if it is in " + unit + ": " + value + " " + unit +
                   " is " + plain_text(state.velocity.x * size) + " mm/s.";
    return {};
}

bool names_inputs_of_patches(std::string_view warning) {
    constexpr std::array names{"friction.rolling.", "friction.mu", "bodies.", "gap "};
    for (const std::string_view name : names)
        if (warning.starts_with(name)) return true;
    return false;
}

}  // namespace contactd
