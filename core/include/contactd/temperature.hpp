// Defines surface temperatures in steady rolling as plain values: thermal properties of bodies, and the answers of a
// contact. Friction heats both surfaces (flash temperature). Heat flows only into the depth, which is valid for a large
// Peclet number (Ertz and Knothe, Wear 253, 2002; Carslaw and Jaeger, section 2.9).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "contactd/grid.hpp"

namespace contactd {

/// Holds the thermal properties of a body, which do not depend on its temperature. The defaults are those of steel.
struct ThermalBody {
    double bulk_temperature = 0;  ///< away from the contact (degrees Celsius)
    double conductivity = 50;     ///< (W/(m K)), >= 0; a body with 0 absorbs no heat
    double heat_capacity = 450;   ///< (J/(kg K)), > 0
    double density = 7850;        ///< (kg/m^3), > 0

    bool operator==(const ThermalBody&) const = default;
    /// Returns the thermal effusivity sqrt(conductivity density heat_capacity) (N/(mm s^0.5 K)).
    double effusivity() const;
    /// Returns the thermal diffusivity, conductivity over density and heat capacity (mm^2/s).
    double diffusivity() const;
};

struct ThermalBodies {
    ThermalBody upper{};
    std::optional<ThermalBody> lower{};  ///< absent: equal to the upper one
    double plastic_share = 1;            ///< fraction of a layer's plastic work that becomes heat, 0 to 1

    bool operator==(const ThermalBodies&) const = default;
    const ThermalBody& below() const { return lower ? *lower : upper; }
};

/// Holds the thermal answers of a contact other than element temperatures.
struct ContactTemperature {
    double largest =
        0;  ///< in contact, common to both surfaces (degrees Celsius); without contact, the larger bulk temperature
    double x = 0, y = 0;                    ///< centre of its element, the first of equal ones (mm)
    double largest_upper = 0;               ///< largest of all elements, also before and behind the contact (degrees
                                            ///< Celsius)
    double largest_lower = 0;               ///< likewise
    double rise = 0;                        ///< largest one by friction alone (K)
    double heat_upper = 0, heat_lower = 0;  ///< frictional power into each body (N mm/s)
    /// This is the smaller value of both bodies, U L/(2 diffusivity), with U the speed of the surface through the
    /// contact and L the length of the longest row. Bodies without conductivity do not count. It is 0 without contact.
    double peclet = 0;

    bool operator==(const ContactTemperature&) const = default;
};

/// Holds the temperatures of both surfaces, each of shape [ny, nx] (degrees Celsius), in and behind the contact.
struct SurfaceTemperatures {
    std::vector<double> upper_temperature, lower_temperature;
    ContactTemperature temperature;
    std::vector<std::string> warnings;  ///< sentences
};

/// Requests temperatures, with tractions and slips of a steady rolling solution, all of shape [ny, nx].
struct TemperatureRequest {
    Grid grid;
    ThermalBodies temperature;
    double velocity = 0;                         ///< rolling velocity V (mm/s), > 0
    double chi = 0;                              ///< rolling direction (rad), 0 or pi: along x
    std::vector<double> pressure;                ///< > 0 in contact (N/mm^2)
    std::vector<double> traction_x, traction_y;  ///< on the upper body (N/mm^2)
    std::vector<double> slip_x, slip_y;  ///< relative slip of the upper body over the lower, per distance rolled
    std::vector<double> flow_x, flow_y;  ///< plastic flow of a layer per distance rolled, along the tractions; or empty
    /// The upper surface passes through the contact at the speed U1 (mm/s), the same in all rows; the lower one passes
    /// at U2 = U1 + V w, with w the slip of its row along the rolling direction. If absent, the speeds are V (1 - w/2)
    /// and V (1 + w/2).
    std::optional<double> upper_speed{};
};

/// Returns whether chi is 0 or pi to 1e-9, so that particles roll along rows.
bool rolls_along_x(double chi);

/// Throws InvalidArgument, which names `field` or a field below it, such as "temperature.upper.density".
void validate(const ThermalBodies& bodies, const std::string& field);

}  // namespace contactd
