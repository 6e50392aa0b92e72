/* A small FMU for co-simulation, FMI 2.0, all of whose variables are real: what a system of FMUs has beside the wheels.
 * A part says what its variables are (part_starts, and modelDescription.xml beside it) and how it makes a step. */
#ifndef CONTACTD_SSP_PART_H
#define CONTACTD_SSP_PART_H

enum { MOST_VARIABLES = 32 };

/* Start values in the order of the value references, which begin at 0. Returns how many there are. */
int part_starts(double* values);
/* Outputs of the start. */
void part_begin(double* values);
/* From `time` (s) on by `size` (s). Returns 0, or 1 where a value cannot be used. */
int part_step(double* values, double time, double size);

#endif
