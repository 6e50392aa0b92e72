// Returns profiles as tables of values.
#pragma once

#include <functional>
#include <vector>

#include "answers/rail_places.hpp"

namespace contactd::cases {

/// Holds the arguments of cntc_getprofilevalues.
struct ProfileQuery {
    int task = 0;
    bool wheel = false;
    int sampling = 0;  ///< -1, 0: the points; 1: equidistant points; n >= 2: n pieces between neighbouring points
    double step = 1;   ///< distance of equidistant points (mm)
};

/// Returns the values of a task in mm and rad. Task 0: the number of points; 1: all y and all z of the profile; 2: the
/// same in track coordinates; 3: gauge face, position of the profile and point at the gauge height of a rail; 4:
/// lengths along the profile; 5: inclinations. Throws NotCovered for other tasks.
std::vector<double> profile_values(const ProfileQuery& query, const RailOutlines& outlines,
                                   const std::function<RailFrames()>& frames);

}  // namespace contactd::cases
