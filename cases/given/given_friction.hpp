// Determines friction from CONTACT's numbers.
#pragma once

#include <string>
#include <vector>

#include "given/given.hpp"
#include "given/units.hpp"

namespace contactd::cases {

/// Friction laws, the values of the digit L. Only the C library has Polach's law.
namespace law {
inline constexpr int coulomb = 0, keeps = 1, linear = 2, rational = 3, exponential = 4, polach = 5, by_temperature = 6;
}  // namespace law
/// Names variation of friction, the values of the digit V.
namespace varies {
inline constexpr int nowhere = 0, by_angle = 1, along_track = 2, by_row = 3;
}  // namespace varies

/// Returns the number of values of a law, including those of its memory, or 0 for an unknown law.
int friction_numbers(int law);

/// Holds the numbers of a law at an angle (rad), at a place or in a row.
struct FrictionAt {
    double place = 0;
    std::vector<double> numbers;
};

/// Returns friction from numbers in these units. Throws NotCovered if core does not support it.
GivenFriction uniform_friction(int law, const std::vector<double>& numbers, const Units& units);
GivenFriction varying_friction(int law, int varies, const std::vector<FrictionAt>& places, const Units& units);

/// Returns the law at a place (mm) along the track. Each of its numbers is interpolated.
FrictionLaw friction_at(const GivenFriction& friction, double place);
/// Returns a warning about uncertain interpolation between two places, or an empty string.
std::string warning_of_places(const GivenFriction& friction, double place);

/// Returns the numbers of the law in these units. Polach's law has the numbers of the equivalent exponential law.
std::vector<double> numbers_of(const GivenFriction& friction, const Units& units);

}  // namespace contactd::cases
