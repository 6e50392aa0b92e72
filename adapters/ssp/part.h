/* Declares a small FMU for co-simulation, FMI 2.0, with real variables only: the parts of a system beside the wheels.
 * __main__.py lists the variables, and generates modelDescription.xml and part_variables.h from them. The header
 * contains their names as indices, and PART_STARTS, their start values. Each part implements a step. */
#ifndef CONTACTD_SSP_PART_H
#define CONTACTD_SSP_PART_H

enum { MOST_VARIABLES = 32 };

/* Outputs of the start. */
void part_begin(double* values);
/* Makes a step from `time` (s) of length `size` (s). Returns 0, or 1 for an invalid value. */
int part_step(double* values, double time, double size);

#endif
