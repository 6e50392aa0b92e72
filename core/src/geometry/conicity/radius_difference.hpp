// Represents the difference of rolling radii as a function of the shift, and the oscillation of a wheelset under it.
#pragma once

#include <functional>
#include <vector>

#include "geometry/profile/interval_finder.hpp"

namespace contactd::geometry {

/// Holds the range of shifts in which a function is known (mm).
struct Reach {
    double low = 0, high = 0;  ///< negative, and positive

    bool operator==(const Reach&) const = default;
};

class RadiusDifference {
   public:
    /// The function is linear between samples that are so close that half-way between two it differs from their mean by
    /// at most `tolerance`; at jumps, they are 1e-5 mm apart or less.
    RadiusDifference(Reach reach, double tolerance, std::function<double(double)> difference);
    /// Extends the range to the larger reach on each side.
    void extend(Reach reach);
    const Reach& reach() const { return reach_; }

    double operator()(double shift) const;
    /// Returns the integral from the least shift on.
    double potential(double shift) const;

    /// Returns the centre of an oscillation with this amplitude, whose ends have the same potential, or NaN if there is
    /// none.
    double centre(double amplitude) const;
    /// Returns the side on which such a centre may still lie: below the known range (-1), above (1), or neither (0),
    /// whether or not it was found.
    int side_of_centre(double amplitude) const;
    /// Returns whether the difference is negligible in an oscillation around the centre, or around 0 if there is no
    /// centre.
    bool vanishes(double amplitude) const;

    /// Returns 1/(pi A) times the integral of half the difference at y + A sin t, times sin t, over a turn, with y so
    /// that the mean over the turn vanishes.
    double harmonic(double amplitude) const;

    /// Returns the integral of dy / sqrt(2 (potential at the ends - potential)) from side to side, whose ends are two
    /// amplitudes apart and have the same potential. It is half a wavelength over sqrt(2e r0). It is infinite if the
    /// difference vanishes, and NaN without oscillation.
    double half_swing(double amplitude) const;

   private:
    struct Sample {
        double shift, value;
    };

    std::vector<Sample> sampled(const std::vector<double>& shifts) const;
    void fill(std::vector<Sample>& samples, const Sample& from, const Sample& to) const;
    void take(const std::vector<Sample>& samples);
    /// Returns the centre at which the function vanishes; its value increases with the centre.
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
