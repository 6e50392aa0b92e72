// Computes points of profiles given by formulae, in the order of ascending y. They are so dense that the curve through
// them stays within 1e-6 mm of the formula.
#pragma once

#include <vector>

#include "contactd/profile_spec.hpp"

namespace contactd::geometry {

/// EN 13715 defines the wheel by a straight line, two polynomials, and below them a straight line between four arcs.
/// The polynomial of the throat misses its neighbours by 1.2e-4 mm at y = -35 and 3.7e-5 mm at -26; the points bend to
/// them over 3 mm.
std::vector<ProfilePoint> formula_points(const S1002& wheel);
/// EN 13674-1 defines the rail by arcs R300, R80, R13 and sides of 1:20, down to where the head is widest.
std::vector<ProfilePoint> formula_points(const Rail60E1& rail);
/// Returns the points of S1002 and Rail60E1 for the names S1002 and UIC60, otherwise those of the head of a rail.
std::vector<ProfilePoint> formula_points(const StandardProfile& profile);
std::vector<ProfilePoint> formula_points(const ArcProfile& arc);
std::vector<ProfilePoint> formula_points(const ConeProfile& cone);

}  // namespace contactd::geometry
