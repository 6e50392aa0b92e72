/* Prints numbers and arrays for the drivers in C, with the words of telling.py. */
#ifndef TELLING_H
#define TELLING_H

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "contactd.h"

static double* values(int32_t n) {
    double* made = calloc((size_t)(n > 0 ? n : 1), sizeof *made);
    if (made == NULL) exit(3);
    return made;
}

static void tell(double value, int32_t code) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    if (code == CONTACTD_OK)
        printf(" %016" PRIX64, bits);
    else
        printf(" -");
}

static void tell_whole(int32_t value, int32_t code) {
    if (code == CONTACTD_OK)
        printf(" %" PRId32, value);
    else
        printf(" -");
}

static uint64_t digest(uint64_t so_far, uint64_t more) {
    return (so_far * 65599 + more) % 4294967291u;
}

/* Lists arrays over the grid, of which every solution has the first, a contact may have all but the last, and a wheel
 * all. */
static const char* const arrays[] = {"element_division", "pressure", "traction_x",           "traction_y",
                                     "slip_x",           "slip_y",   "pressure_by_approach", "gap"};
enum { sure_arrays = 6, contact_arrays = 7, wheel_arrays = 8 };

static void tell_division(const double* division, int32_t elements) {
    uint64_t sum = 0;
    for (int32_t i = 0; i < elements; ++i) sum = digest(sum, (uint64_t)division[i]);
    printf(" %" PRIu64, sum);
}

static void tell_digest(const double* array, int32_t elements) {
    uint64_t bits, sum = 0;
    for (int32_t i = 0; i < elements; ++i) {
        memcpy(&bits, &array[i], sizeof bits);
        sum = digest(digest(sum, bits >> 32), bits & 0xFFFFFFFFu);
    }
    printf(" %" PRIu64, sum);
}

#endif
