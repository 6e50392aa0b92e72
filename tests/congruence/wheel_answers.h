/* What the driver in C says of a wheel on its rail: wheel_telling.py has the order. */
#ifndef WHEEL_ANSWERS_H
#define WHEEL_ANSWERS_H

#include "telling.h"

static void tell_numbers(const double* v, int numbers, int32_t code) {
    for (int i = 0; i < numbers; ++i) tell(v[i], code);
}

static void tell_patch_arrays(contactd_wheel* wheel, int32_t patch, int32_t elements) {
    double* array = values(elements);
    int32_t* division = calloc((size_t)elements, sizeof *division);
    if (division == NULL || contactd_wheel_get_division(wheel, patch, division, elements) != CONTACTD_OK) exit(3);
    tell_division(division, elements);
    for (int32_t which = CONTACTD_PRESSURE; which <= CONTACTD_GAP; ++which) {
        /* Quick models have no gap. */
        if (contactd_wheel_get_array(wheel, patch, which, array, elements) != CONTACTD_OK) {
            if (which != CONTACTD_GAP) exit(3);
            memset(array, 0, (size_t)elements * sizeof *array);
        }
        tell_digest(array, elements);
    }
    free(array);
    free(division);
}

static void tell_place(contactd_wheel* wheel, int32_t patch, int32_t n[2]) {
    double v[4] = {0};
    int32_t code = contactd_wheel_get_place(wheel, patch, v, v + 1, v + 2, v + 3);
    tell_numbers(v, 4, code);
    code = contactd_wheel_get_grid(wheel, patch, n, n + 1, v, v + 1, v + 2, v + 3);
    tell_whole(n[0], code);
    tell_whole(n[1], code);
    tell_numbers(v, 4, code);
    code = contactd_wheel_get_creepages(wheel, patch, v, v + 1, v + 2, v + 3);
    tell_numbers(v, 4, code);
    code = contactd_wheel_get_radii(wheel, patch, v, v + 1, v + 2, v + 3);
    tell_numbers(v, 4, code);
}

static void tell_patch(contactd_wheel* wheel, int32_t patch) {
    double v[6] = {0};
    int32_t grid[2] = {0}, n[4] = {0}, code;
    tell_place(wheel, patch, grid);
    code = contactd_wheel_get_contact_forces(wheel, patch, v, v + 1, v + 2, v + 3);
    tell_numbers(v, 4, code);
    for (int32_t in = CONTACTD_IN_TRACK; in <= CONTACTD_IN_WHEELSET; ++in) {
        code = contactd_wheel_get_patch_forces(wheel, patch, in, v);
        tell_numbers(v, 6, code);
    }
    code = contactd_wheel_get_pressure(wheel, patch, v, v + 1);
    tell_numbers(v, 2, code);
    code = contactd_wheel_get_areas(wheel, patch, v, v + 1, v + 2);
    tell_numbers(v, 3, code);
    code = contactd_wheel_get_counts(wheel, patch, n, n + 1, n + 2, n + 3);
    for (int i = 0; i < 4; ++i) tell_whole(n[i], code);
    tell_patch_arrays(wheel, patch, grid[0] * grid[1]);
}

static void tell_wheel_warnings(contactd_wheel* wheel) {
    int32_t warnings = 0;
    uint64_t sum = 0;
    char text[2000];
    contactd_wheel_get_warnings(wheel, &warnings);
    for (int32_t i = 0; i < warnings; ++i) {
        contactd_wheel_get_warning(wheel, i, text, sizeof text);
        for (const char* c = text; *c != '\0'; ++c) sum = digest(sum, (unsigned char)*c);
    }
    printf(" %" PRId32 " %" PRIu64, warnings, sum);
}

static void tell_wheel(contactd_wheel* wheel) {
    const int32_t searches[] = {CONTACTD_FORCE, CONTACTD_PITCH, CONTACTD_RAIL_SHIFT};
    double v[6] = {0};
    int32_t n = 0, converged = 0, code = contactd_wheel_get_motion(wheel, v, v + 1);
    tell_numbers(v, 2, code);
    code = contactd_wheel_get_clearance(wheel, v);
    tell(v[0], code);
    for (int32_t in = CONTACTD_IN_TRACK; in <= CONTACTD_IN_WHEELSET; ++in) {
        code = contactd_wheel_get_forces(wheel, in, v);
        tell_numbers(v, 6, code);
    }
    for (int32_t by = CONTACTD_BY_POSITION_Y; by <= CONTACTD_BY_VELOCITY_PITCH; ++by) {
        code = contactd_wheel_get_derivative(wheel, by, v);
        tell_numbers(v, 6, code);
    }
    code = contactd_wheel_get_converged(wheel, &converged);
    tell_whole(converged, code);
    code = contactd_wheel_get_rail_shift(wheel, v, v + 1);
    tell_numbers(v, 2, code);
    for (int search = 0; search < 3; ++search) {
        code = contactd_wheel_get_evidence(wheel, searches[search], &n, v, &converged);
        tell_whole(n, code);
        tell(v[0], code);
        tell_whole(converged, code);
    }
    tell_wheel_warnings(wheel);
    code = contactd_wheel_get_patches(wheel, &n);
    tell_whole(n, code);
    for (int32_t patch = 0; patch < n; ++patch) tell_patch(wheel, patch);
}

#endif
