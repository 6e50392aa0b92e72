// Determines the potential contact area and the undeformed distance from CONTACT's numbers.
#pragma once

#include <vector>

#include "given/given.hpp"
#include "given/given_rail.hpp"
#include "given/units.hpp"

namespace contactd::cases {

/// Reads a Hertzian contact, IPOTCN -1 to -6: MX, MY and its numbers. All functions throw NotCovered.
HertzArea hertz_area(int option, const std::vector<double>& numbers, const Units& units);
/// Reads a rectangle, IPOTCN 1 to 4.
Grid potential_contact(int option, const std::vector<double>& numbers, const Units& units);
/// Reads the sizes for patches on rails: DX and DS, and with the option -1 also A_SEP, D_SEP, D_COMB and an optional
/// D_TURN.
GivenElements rail_elements(int option, const std::vector<double>& numbers, const Units& units);

/// Returns the least number of values of a kind of distance, IBASE, or 0 for an unknown kind. Profiles and distances of
/// each element may have more.
int distance_numbers(int base);
Distance given_distance(int base, std::vector<double> numbers, const Units& units);

}  // namespace contactd::cases
