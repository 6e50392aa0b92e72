// Profiles as tables of values.
#pragma once

#include <functional>
#include <vector>

#include "answers/rail_places.hpp"

namespace contactd::cases {

/// A question of cntc_getprofilevalues.
struct ProfileQuery {
    int task = 0;
    bool wheel = false;
    int sampling = 0;  ///< -1, 0: the points; 1: equally far apart; 2 and more: so many pieces from point to point
    double step = 1;   ///< of equally far apart ones (mm)
};

/// Its answer in mm and rad: 0 the number of points; 1 all y and all z of the profile; 2 the same in the track; 3 of a
/// rail the gauge face, the place of the profile and the point at the gauge height; 4 lengths along the profile;
/// 5 inclinations. Throws NotCovered for others.
std::vector<double> profile_values(const ProfileQuery& query, const RailOutlines& outlines,
                                   const std::function<RailFrames()>& frames);

}  // namespace contactd::cases
