// Defines systems of units, and the body that forces act on. Internal values are in mm, N, s and rad, and forces act on
// the upper body, as in core.
#pragma once

namespace contactd::cases {

/// Factors that multiply inputs and divide outputs.
struct Units {
    int code = 1934;
    double length = 1;  ///< also for velocities (mm, mm/s)
    double body = 1;    ///< 1: forces act on the upper body, body 1; -1: on body 2

    double stress() const { return 1 / (length * length); }  ///< (N/mm^2); forces are in N in all systems
    double moment() const { return length; }                 ///< (N mm)
    double area() const { return length * length; }          ///< (mm^2)
    double curvature() const { return 1 / length; }          ///< also for spin (1/mm, rad/mm)
};

inline constexpr Units units_mm_on_body_1{1934, 1, 1};
inline constexpr Units units_m_on_body_2{1935, 1000, -1};
inline constexpr Units units_m_on_body_1{1936, 1000, 1};

}  // namespace contactd::cases
