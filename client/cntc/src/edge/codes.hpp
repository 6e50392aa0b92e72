// Numbers of the interface, from docs/cntc.md.
#pragma once

namespace contactd::cntc {

/// The negative answers of cntc_calculate.
namespace error_code {
inline constexpr int search = -25;          ///< of a contact of wheel and rail found none
inline constexpr int total_force = -26;     ///< no height or pitch rate brings it
inline constexpr int normal = -27;          ///< did not converge
inline constexpr int tangential = -28;      ///< did not converge
inline constexpr int tolerance = -29;       ///< stopped above it
inline constexpr int handle = -31;          ///< no such result element or contact problem
inline constexpr int profile = -32;         ///< of a wheel or a rail, cannot be used
inline constexpr int friction = -33;        ///< cannot be used
inline constexpr int discretisation = -34;  ///< of elements or steps, cannot be used
inline constexpr int input = -39;           ///< another one that cannot be used, or is missing
inline constexpr int other = -99;
}  // namespace error_code

/// Codes of the flags.
namespace flag {
inline constexpr int none = 0;
inline constexpr int units = 1933;
inline constexpr int configuration = 1967;
inline constexpr int previous = 1970;
inline constexpr int bound = 1971;
inline constexpr int tangential = 1972;
inline constexpr int normal = 1973;
inline constexpr int force = 1974;
inline constexpr int friction_law = 1976;
inline constexpr int discretisation = 1977;
inline constexpr int influence = 1978;
inline constexpr int material = 1979;
inline constexpr int extra_slip = 1980;
inline constexpr int heat = 1982;
inline constexpr int estimate = 1983;
inline constexpr int result = 1986;
inline constexpr int sensitivities = 1988;
inline constexpr int variant = 1990;        ///< of half-spaces that turn
inline constexpr int most_elements = 1993;  ///< of a patch on rails
inline constexpr int own_output = 2000;
}  // namespace flag

/// Modules of the program: wheel on rail, the same with another program's inputs, and basic contact.
namespace module_number {
inline constexpr int wheel_rail = 1;
inline constexpr int wheel_rail_inputs = 11;
inline constexpr int basic_contact = 3;
}  // namespace module_number

/// All contact problems of a result element, where one is asked for.
inline constexpr int all_problems = -1;

/// Version of the interface.
inline constexpr int interface_version = 1;

}  // namespace contactd::cntc
