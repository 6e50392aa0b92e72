// Defines one table of values that are valid but probably meant in another unit.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace contactd {

/// Selects the physical quantity of a field.
enum class Quantity {
    angle,                 ///< angles of wheelsets and rails (rad)
    friction_coefficient,  ///< as a ratio
    lateral_position,      ///< of a wheelset (mm)
    lateral_amplitude,     ///< largest amplitude of the kinematic motion of a wheelset (mm)
    contact_distance,      ///< distance between the contacts of both wheels (mm)
    track_length,          ///< from the first slice of a rail to the last (mm)
    vehicle_speed,         ///< speed of a wheel on its rail (mm/s)
    vertical_force,        ///< on the wheel of a vehicle (N)
    shear_modulus,         ///< modulus of wheels and rails (N/mm^2)
};

/// Trains run at 5 to 100 m/s, or 20 to 400 km/h. A smaller number (mm/s) is probably in one of these units; tests at
/// such low speeds run on rollers.
inline constexpr double slowest_vehicle = 400;

/// Returns whether a value is probably meant in another unit.
bool is_doubtful(Quantity quantity, double value);

/// Returns a sentence about a doubtful value, with its size in the units that it may be confused with; nothing for
/// other values. `says` is the field with its verb, such as "position.y is"; `more` is added to the reason for doubt.
std::optional<std::string> doubt(Quantity quantity, std::string_view says, double value, std::string_view more = {});

}  // namespace contactd
