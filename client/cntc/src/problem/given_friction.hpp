// Friction as a program sets it: a method and its numbers.
#pragma once

#include <vector>

#include "problem/settings.hpp"

namespace contactd::cntc {

/// The method that keeps the friction set before.
inline constexpr int keeps_friction = 1;

/// Returns the friction of a method, the law plus ten times how it varies, from numbers in the caller's units. Throws
/// Refused where core has no such friction.
GivenFriction read_friction(int method, const double* params, const int* nparam, const Settings& settings);

/// Returns the law at a place (mm) along the track, with each of its numbers interpolated. Warns where a straight line
/// between two places is a guess.
FrictionLaw friction_at(const GivenFriction& friction, double place);

/// Returns the numbers of the law in these units; Polach's law has those of the exponential law that it is.
std::vector<double> numbers_of(const GivenFriction& friction, const Units& units);

}  // namespace contactd::cntc
