/* The body of a wheelset on springs, across the track and about the vertical:
 *
 *     m y'' = -(Fy_left + Fy_right) - k_y y - c_y y'
 *     I yaw'' = -(Mz_left + Mz_right) - k_yaw yaw - c_yaw yaw'
 *
 * with the forces on the rails in the wheelset's axes, as contactd_wheel has them with coordinates = 2: the yaw of a
 * wheelset on its rails is too small to tell them from those of the track. Creep forces damp with creep coefficient
 * over velocity, some 1e6 N s/m: a step must be short against m over that. Units are N, mm, kg, s and rad: a force in N
 * over a mass in kg is an acceleration in m/s^2, 1000 of it mm/s^2. */
#include "part.h"

#include <math.h>

#include "part_variables.h"

void part_begin(double* values) {
    values[Y] = values[Y_START];
}

/* Velocities first and places by them: what swings keeps its energy but for the order of the step. */
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
