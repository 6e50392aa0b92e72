// The difference of rolling radii as a function of the shift, and what a wheelset does under it.
#pragma once

#include <functional>
#include <vector>

#include "geometry/profile/interval_finder.hpp"

namespace contactd::geometry {

/// Shifts at which a function is known (mm).
struct Reach {
    double low = 0, high = 0;  ///< negative, and positive

    bool operator==(const Reach&) const = default;
};

class RadiusDifference {
   public:
    /// Straight lines between values, so close that the function half-way between two differs from their mean by
    /// `tolerance` at most; at jumps, a micrometre apart.
    RadiusDifference(Reach reach, double tolerance, std::function<double(double)> difference);
    /// Looks farther on both sides, or as far.
    void extend(Reach reach);
    const Reach& reach() const { return reach_; }

    double operator()(double shift) const;
    /// Its integral from the least shift on.
    double potential(double shift) const;

    /// Where it swings with an amplitude: the ends have the same potential. Not a number where they nowhere have.
    double centre(double amplitude) const;
    /// Where such a centre may still lie: below what is known (-1), above (1), or neither (0), be it found or not.
    int side_of_centre(double amplitude) const;
    /// Whether there is none to speak of in a swing around a centre, or around 0 where there is no centre.
    bool vanishes(double amplitude) const;

    /// 1/(pi A) times the integral of half the difference at y + A sin t, times sin t, over a turn; y is where the mean
    /// over the turn vanishes.
    double harmonic(double amplitude) const;

    /// The integral of dy / sqrt(2 (potential at the ends - potential)) from side to side, whose ends are two
    /// amplitudes apart and have the same potential: half a wavelength by sqrt(2e r0). Infinite where the difference
    /// vanishes; not a number where it does not swing back.
    double half_swing(double amplitude) const;

   private:
    struct Sample {
        double shift, value;
    };

    std::vector<Sample> sampled(const std::vector<double>& shifts) const;
    void fill(std::vector<Sample>& samples, const Sample& from, const Sample& to) const;
    void take(const std::vector<Sample>& samples);
    /// Where the function of the centre vanishes; its value is larger for larger centres.
    double centre(double amplitude, const std::function<double(double)>& function) const;
    double unevenness(double amplitude, double centre) const;
    double moment(double amplitude, double centre, bool weighted) const;
    double half_swing_around(double amplitude, double centre) const;
    double largest_between(double from, double to) const;

    Reach reach_;
    double tolerance_;
    std::function<double(double)> difference_;
    std::vector<double> values_, integrals_;  // at the shifts of find_
    IntervalFinder find_;
};

}  // namespace contactd::geometry
