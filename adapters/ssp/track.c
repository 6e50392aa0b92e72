/* Simulates the alignment of a track: y displaces both rails, by a bump (a raised cosine) that a wheelset passes,
 *
 *     y = height/2 (1 - cos(2 pi s/length)),   s = velocity time - begins,   0 <= s <= length
 *
 * in mm, mm/s and s. */
#include "part.h"

#include <math.h>

#include "part_variables.h"

static int place(double* v, double time) {
    const double s = v[VELOCITY] * time - v[BEGINS], turn = 2 * 3.14159265358979323846 / v[LENGTH];
    const int on = v[LENGTH] > 0 && s >= 0 && s <= v[LENGTH];
    v[Y] = on ? v[HEIGHT] / 2 * (1 - cos(turn * s)) : 0;
    v[Y_RATE] = on ? v[HEIGHT] / 2 * turn * sin(turn * s) * v[VELOCITY] : 0;
    return v[LENGTH] > 0 ? 0 : 1;
}

void part_begin(double* values) {
    place(values, 0);
}
int part_step(double* values, double time, double size) {
    return place(values, time + size);
}
