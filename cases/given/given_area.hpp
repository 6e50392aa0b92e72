// The potential contact area and the undeformed distance from the numbers in which CONTACT takes them.
#pragma once

#include <vector>

#include "given/given.hpp"
#include "given/given_rail.hpp"
#include "given/units.hpp"

namespace contactd::cases {

/// Reads Hertz's contact, IPOTCN -1 to -6: MX, MY and its numbers. All throw NotCovered.
HertzArea hertz_area(int option, const std::vector<double>& numbers, const Units& units);
/// Reads a rectangle, IPOTCN 1 to 4.
Grid potential_contact(int option, const std::vector<double>& numbers, const Units& units);
/// Reads the sizes for patches on rails: DX, DS, and with the option -1 A_SEP, D_SEP, D_COMB and D_TURN, which may be
/// missing.
GivenElements rail_elements(int option, const std::vector<double>& numbers, const Units& units);

/// Returns how many numbers a kind of distance, IBASE, has at least; 0 where there is no such kind. Those of profiles
/// and of elements may have more.
int distance_numbers(int base);
Distance given_distance(int base, std::vector<double> numbers, const Units& units);

}  // namespace contactd::cases
