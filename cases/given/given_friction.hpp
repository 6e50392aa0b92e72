// Friction from the numbers in which CONTACT takes it.
#pragma once

#include <string>
#include <vector>

#include "given/given.hpp"
#include "given/units.hpp"

namespace contactd::cases {

/// Laws: the digit L. Polach's law is one of the C library.
namespace law {
inline constexpr int coulomb = 0, keeps = 1, linear = 2, rational = 3, exponential = 4, polach = 5, by_temperature = 6;
}  // namespace law
/// How friction varies: the digit V.
namespace varies {
inline constexpr int nowhere = 0, by_angle = 1, along_track = 2, by_row = 3;
}  // namespace varies

/// Returns how many numbers a law has, with those of its memory; 0 where there is no such law.
int friction_numbers(int law);

/// Numbers of a law at an angle (rad), a place or in a row.
struct FrictionAt {
    double place = 0;
    std::vector<double> numbers;
};

/// Returns friction from numbers in these units. Throws NotCovered where core has no such friction.
GivenFriction uniform_friction(int law, const std::vector<double>& numbers, const Units& units);
GivenFriction varying_friction(int law, int varies, const std::vector<FrictionAt>& places, const Units& units);

/// Returns the law at a place (mm) along the track, with each of its numbers interpolated.
FrictionLaw friction_at(const GivenFriction& friction, double place);
/// Says that a straight line between two places is a guess; empty where it is none.
std::string warning_of_places(const GivenFriction& friction, double place);

/// Returns the numbers of the law in these units; Polach's law has those of the exponential law that it is.
std::vector<double> numbers_of(const GivenFriction& friction, const Units& units);

}  // namespace contactd::cases
