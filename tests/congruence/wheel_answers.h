/* Prints the results of a wheel on its rail for the driver in C, in the order of wheel_telling.py. */
#ifndef WHEEL_ANSWERS_H
#define WHEEL_ANSWERS_H

#include "telling.h"

static char path_text[200];

static const char* path_of(const char* prefix, const char* name) {
    snprintf(path_text, sizeof path_text, "%s%s", prefix, name);
    return path_text;
}

static void tell_field(contactd_wheel* wheel, const char* prefix, const char* path) {
    double value = 0;
    const int32_t code = contactd_get(wheel, path_of(prefix, path), &value);
    tell(value, code);
}

static void tell_whole_field(contactd_wheel* wheel, const char* prefix, const char* path) {
    double value = 0;
    const int32_t code = contactd_get(wheel, path_of(prefix, path), &value);
    tell_whole((int32_t)value, code);
}

/* Prints the numbers of an object. */
static void tell_object(contactd_wheel* wheel, const char* prefix, const char* path, int32_t count_of_numbers) {
    double v[6] = {0};
    const int32_t code = contactd_get_array(wheel, path_of(prefix, path), v, count_of_numbers);
    for (int32_t i = 0; i < count_of_numbers; ++i) tell(v[i], code);
}

static void tell_forces(contactd_wheel* wheel, const char* prefix) {
    tell_object(wheel, prefix, "forces.track", 6);
    tell_object(wheel, prefix, "forces.rail", 6);
    tell_object(wheel, prefix, "forces.wheelset", 6);
}

static void tell_patch_arrays(contactd_wheel* wheel, const char* prefix) {
    int32_t elements = 0;
    contactd_length(wheel, path_of(prefix, "solution.pressure"), &elements);
    double* array = values(elements);
    for (int which = 0; which < wheel_arrays; ++which) {
        const int is_gap = which == wheel_arrays - 1;
        path_of(prefix, is_gap ? "" : "solution.");
        strcat(path_text, arrays[which]);
        if (contactd_get_array(wheel, path_text, array, elements) != CONTACTD_OK) {
            if (which < sure_arrays) exit(3);
            memset(array, 0, (size_t)elements * sizeof *array);
        }
        which == 0 ? tell_division(array, elements) : tell_digest(array, elements);
    }
    free(array);
}

static void tell_place(contactd_wheel* wheel, const char* prefix) {
    const char* const sizes[] = {"place.grid.dx", "place.grid.dy", "place.grid.x0", "place.grid.y0"};
    const char* const creepages[] = {"place.creepages.xi", "place.creepages.eta", "place.creepages.phi",
                                     "place.creepages.velocity"};
    tell_object(wheel, prefix, "place.reference", 4);
    tell_whole_field(wheel, prefix, "place.grid.nx");
    tell_whole_field(wheel, prefix, "place.grid.ny");
    for (int i = 0; i < 4; ++i) tell_field(wheel, prefix, sizes[i]);
    for (int i = 0; i < 4; ++i) tell_field(wheel, prefix, creepages[i]);
    tell_object(wheel, prefix, "place.radii", 4);
}

static void tell_patch(contactd_wheel* wheel, int patch) {
    const char* const counts[] = {"solution.elements.contact", "solution.elements.adhesion", "solution.elements.slip",
                                  "solution.elements.border"};
    char prefix[40];
    snprintf(prefix, sizeof prefix, "patches[%d].", patch);
    tell_place(wheel, prefix);
    tell_object(wheel, prefix, "solution.forces", 4);
    tell_forces(wheel, prefix);
    tell_field(wheel, prefix, "solution.approach");
    tell_field(wheel, prefix, "solution.pmax");
    tell_object(wheel, prefix, "solution.area", 4);
    for (int i = 0; i < 4; ++i) tell_whole_field(wheel, prefix, counts[i]);
    tell_patch_arrays(wheel, prefix);
}

static void tell_wheel_warnings(contactd_wheel* wheel) {
    double warnings = 0;
    uint64_t sum = 0;
    char text[2000], path[40];
    contactd_get(wheel, "warnings", &warnings);
    for (int i = 0; i < warnings; ++i) {
        snprintf(path, sizeof path, "warnings[%d]", i);
        contactd_get_word(wheel, path, text, sizeof text);
        for (const char* c = text; *c != '\0'; ++c) sum = digest(sum, (unsigned char)*c);
    }
    printf(" %d %" PRIu64, (int)warnings, sum);
}

static void tell_wheel(contactd_wheel* wheel) {
    const char* const inputs[] = {"position.y", "position.z", "position.roll", "position.yaw", "velocity.x",
                                  "velocity.y", "velocity.z", "velocity.roll", "velocity.yaw", "velocity.pitch"};
    const char* const searches[] = {"force", "pitch_search", "rail_search"};
    double patches = 0;
    tell_field(wheel, "", "z");
    tell_field(wheel, "", "pitch_rate");
    tell_field(wheel, "", "clearance");
    tell_forces(wheel, "");
    for (int by = 0; by < 10; ++by) tell_object(wheel, "derivatives.", inputs[by], 6);
    tell_whole_field(wheel, "", "converged");
    tell_object(wheel, "", "rail_deflection", 2);
    for (int search = 0; search < 3; ++search) {
        tell_whole_field(wheel, searches[search], ".iterations");
        tell_field(wheel, searches[search], ".residual");
        tell_whole_field(wheel, searches[search], ".converged");
    }
    tell_wheel_warnings(wheel);
    tell_whole_field(wheel, "", "patches");
    contactd_get(wheel, "patches", &patches);
    for (int patch = 0; patch < patches; ++patch) tell_patch(wheel, patch);
}

#endif
