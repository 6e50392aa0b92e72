// Lists the parts of a case, in the order of the file.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "groups.hpp"

namespace contactd::contact_files {

/// Describes one part: a group of values, or data that a function reads.
struct Step {
    /// Returns the group in the syntax of read_values, or an empty string if the digits of the case exclude it.
    std::string (*group)(const Reading&) = nullptr;
    /// Lists names of values that the group replaces.
    std::string_view replaces = {};
    void (*read)(Reading&) = nullptr;  ///< used instead of `group`
};

void read_steps(Reading& reading, std::span<const Step> steps);

/// Return the steps of module 1, a wheel on its rail, and of module 3, basic contact.
std::span<const Step> steps_on_rails();
std::span<const Step> steps_alone();

// Steps of both modules.
inline constexpr std::string_view solver_option_names =
    "OMEGAH OMEGAS INISLP OMGSLP FDECAY BETATH KDOWFB D_IFC D_LIN D_CNS D_SLP POW_S";
std::string solver_bounds(const Reading& reading);
std::string solver_options(const Reading& reading);
std::string elastic_constants(const Reading& reading);
std::string thin_sheet(const Reading& reading);
std::string material_constants(const Reading& reading);
std::string damping(const Reading& reading);
std::string heat_of_first(const Reading& reading);
std::string heat_of_second(const Reading& reading);
std::string plastic_heat(const Reading& reading);
/// Reads one set, sets by angle or place, or a set for each row of elements, followed by the memory of friction.
void read_friction(Reading& reading);
/// Returns the names of a law's numbers in the order of a set.
std::span<const std::string_view> names_of_friction(int law);
/// Reads output digits and blocks of points below the surface.
void read_subsurface(Reading& reading);

// Parts of module 3.
void read_grid(Reading& reading);
void read_gap(Reading& reading);

}  // namespace contactd::contact_files
