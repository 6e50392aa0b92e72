// The difference of rolling radii as a function of the shift, and what a wheelset does under it.
#pragma once

#include <functional>
#include <vector>

#include "geometry/profile/interval_finder.hpp"

namespace contactd::geometry {

class RadiusDifference {
   public:
    /// Straight lines between values from -reach to reach, so close that the function half-way between two differs from
    /// their mean by `tolerance` at most; at jumps, a micrometre apart.
    RadiusDifference(double reach, double tolerance, const std::function<double(double)>& difference);

    double operator()(double shift) const;
    /// Its integral from the least shift on.
    double potential(double shift) const;

    /// 1/(pi A) times the integral of half the difference at y + A sin t, times sin t, over a turn; y is where the mean
    /// over the turn vanishes.
    double harmonic(double amplitude) const;

    /// The integral of dy / sqrt(2 (potential at the ends - potential)) from side to side, whose ends are two
    /// amplitudes apart and have the same potential: half a wavelength by sqrt(2e r0). Not a number where it does not
    /// swing back.
    double half_swing(double amplitude) const;

   private:
    /// Where the function of the centre vanishes; its value is larger for larger centres. 0 when it does so there.
    double centre(double amplitude, const std::function<double(double)>& function) const;

    double reach_;
    std::vector<double> values_, integrals_;  // at the shifts of find_
    IntervalFinder find_;
};

}  // namespace contactd::geometry
