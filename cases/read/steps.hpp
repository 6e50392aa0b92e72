// The parts of a case, in the order in which they stand in the file.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "groups.hpp"

namespace contactd::contact_files {

/// One part: a group of values, or what a function of its own reads.
struct Step {
    /// The group as read_values has it; empty where the digits of the case leave it out.
    std::string (*group)(const Reading&) = nullptr;
    /// Names of values that the group takes the place of.
    std::string_view replaces = {};
    void (*read)(Reading&) = nullptr;  ///< in place of `group`
};

void read_steps(Reading& reading, std::span<const Step> steps);

/// Module 1, a wheel on its rail, and module 3, basic contact.
std::span<const Step> steps_on_rails();
std::span<const Step> steps_alone();

// Steps that both modules have.
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
/// One set, sets by angle or place, or a set a row of elements, and the memory of friction behind them.
void read_friction(Reading& reading);
/// Returns the names of a law's numbers in the order of a set.
std::span<const std::string_view> names_of_friction(int law);
/// Output digits and blocks of points below the surface.
void read_subsurface(Reading& reading);

// Steps of module 3.
void read_grid(Reading& reading);
void read_gap(Reading& reading);

}  // namespace contactd::contact_files
