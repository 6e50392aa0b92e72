/* A small FMU for co-simulation, FMI 2.0, all of whose variables are real: what a system of FMUs has beside the wheels.
 * Variables are those of __main__.py, which makes modelDescription.xml of them and part_variables.h: their names as
 * indices, and PART_STARTS, their start values. A part says how it makes a step. */
#ifndef CONTACTD_SSP_PART_H
#define CONTACTD_SSP_PART_H

enum { MOST_VARIABLES = 32 };

/* Outputs of the start. */
void part_begin(double* values);
/* From `time` (s) on by `size` (s). Returns 0, or 1 where a value cannot be used. */
int part_step(double* values, double time, double size);

#endif
