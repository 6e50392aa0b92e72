/* Simulates the body of a wheelset on springs, across the track and about the vertical axis:
 *
 *     m y'' = -(Fy_left + Fy_right) - k_y y - c_y y'
 *     I yaw'' = -(Mz_left + Mz_right) - k_yaw yaw - c_yaw yaw'
 *
 * The forces on the rails are in the wheelset's axes, as from contactd_wheel with coordinates = 2. The yaw of a
 * wheelset is too small to distinguish them from the axes of the track. Creep forces damp with the creep coefficient
 * divided by the velocity, about 1e6 N s/m, and a step must be short compared with m divided by this damping. Units are
 * N, mm, kg, s and rad: a force in N divided by a mass in kg is an acceleration in m/s^2, which is 1000 mm/s^2. */
#include "part.h"

#include <math.h>

#include "part_variables.h"

void part_begin(double* values) {
    values[Y] = values[Y_START];
}

/* Updates velocities before positions, so that oscillations keep their energy to the order of the step. */
int part_step(double* v, double time, double size) {
    (void)time;
    if (!(v[MASS] > 0 && v[INERTIA] > 0)) return 1;
    const double force = -(v[FY_LEFT] + v[FY_RIGHT]) - v[K_Y] * v[Y] - v[C_Y] * v[Y_RATE];
    const double moment = -(v[MZ_LEFT] + v[MZ_RIGHT]) - v[K_YAW] * v[YAW] - v[C_YAW] * v[YAW_RATE];
    v[Y_RATE] += size * 1e3 * force / v[MASS];
    v[YAW_RATE] += size * 1e-3 * moment / v[INERTIA];
    v[Y] += size * v[Y_RATE];
    v[YAW] += size * v[YAW_RATE];
    return isfinite(v[Y]) && isfinite(v[YAW]) ? 0 : 1;
}
