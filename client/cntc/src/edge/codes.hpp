// Numbers of the interface, as in docs/cntc.md.
#pragma once

namespace contactd::cntc {

/// Negative results of cntc_calculate.
namespace error_code {
inline constexpr int search = -25;          ///< the contact search of wheel and rail failed
inline constexpr int total_force = -26;     ///< no height or pitch rate produces it
inline constexpr int normal = -27;          ///< did not converge
inline constexpr int tangential = -28;      ///< did not converge
inline constexpr int tolerance = -29;       ///< stopped above it
inline constexpr int handle = -31;          ///< no such result element or contact problem
inline constexpr int profile = -32;         ///< of a wheel or a rail: invalid
inline constexpr int friction = -33;        ///< invalid
inline constexpr int discretisation = -34;  ///< of elements or steps: invalid
inline constexpr int input = -39;           ///< any other invalid or missing input
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
inline constexpr int variant = 1990;        ///< of half-spaces rotated from row to row
inline constexpr int most_elements = 1993;  ///< of a patch on rails
inline constexpr int own_output = 2000;
}  // namespace flag

/// Modules of the program: wheel on rail, the same with inputs of another program, and basic contact.
namespace module_number {
inline constexpr int wheel_rail = 1;
inline constexpr int wheel_rail_inputs = 11;
inline constexpr int basic_contact = 3;
}  // namespace module_number

/// Stands for all contact problems of a result element.
inline constexpr int all_problems = -1;

/// Version of the interface.
inline constexpr int interface_version = 1;

}  // namespace contactd::cntc
