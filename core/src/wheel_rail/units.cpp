#include "wheel_rail/units.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "types/number_text.hpp"

namespace contactd {
namespace {

constexpr double stiffest = 1.2e5;  // N/mm^2: shear moduli of steels and irons are 4e4 to 8.5e4
constexpr double pascals = 1e7;     // of what is larger
constexpr double lightest = 200;    // N: what a wheel of a vehicle carries is a hundred times as much
constexpr double smallest = 150;    // mm: radius of such a wheel; those of models carry less

void warn_of_modulus(const std::string& name, const Material& material, std::vector<std::string>& warnings) {
    if (material.is_rigid() || material.G < stiffest) return;
    const std::string is = "bodies." + name + ".G is " + number_text(material.G) + " N/mm^2, ";
    if (material.G >= pascals)
        warnings.push_back(is + "more than any material has. Give moduli in N/mm^2, not in Pa.");
    else
        warnings.push_back(
            is + "more than steel has. Give the shear modulus, not Young's modulus: E/(2 (1 + nu)) would be " +
            number_text(std::round(material.G / (2 * (1 + material.nu)))) + " N/mm^2.");
}

}  // namespace

std::vector<std::string> unit_warnings(const WheelRailSetup& setup) {
    std::vector<std::string> warnings;
    if (setup.bodies.pair) return warnings;
    warn_of_modulus("upper", setup.bodies.upper.material, warnings);
    if (setup.bodies.lower.material != setup.bodies.upper.material)
        warn_of_modulus("lower", setup.bodies.lower.material, warnings);
    return warnings;
}

std::vector<std::string> unit_warnings(const WheelRailSetup& setup, const WheelRailState& state) {
    std::vector<std::string> warnings;
    if (state.Fz && *state.Fz > 0 && *state.Fz < lightest && setup.wheelset.nominal_radius > smallest)
        warnings.push_back("Fz is " + short_text(*state.Fz) + " N, next to nothing for a wheel of radius " +
                           short_text(setup.wheelset.nominal_radius) + " mm. Give forces in N, not in kN.");
    return warnings;
}

std::vector<std::string> position_warnings(const WheelRailState& state) {
    constexpr double least = 5e-4, largest = 0.015;  // of positions in metres
    const double y = state.position.y;
    if (std::abs(y) < least || std::abs(y) > largest) return {};
    return {"position.y is " + short_text(y) +
            " mm, micrometres off the middle of the track. Give lengths in mm, not in m."};
}

bool names_inputs_of_patches(std::string_view warning) {
    constexpr std::array names{"friction.rolling.", "bodies."};
    for (const std::string_view name : names)
        if (warning.starts_with(name)) return true;
    return false;
}

}  // namespace contactd
