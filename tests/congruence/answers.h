/* Prints the results of a step for the driver in C, in the order of telling.py. */
#ifndef ANSWERS_H
#define ANSWERS_H

#include "telling.h"

static int32_t get(contactd_contact* contact, const char* above, const char* field_name, double* value) {
    char path[100];
    snprintf(path, sizeof path, "%s.%s", above, field_name);
    return contactd_get(contact, path, value);
}

static void tell_field(contactd_contact* contact, const char* path) {
    double value = 0;
    const int32_t code = contactd_get(contact, path, &value);
    tell(value, code);
}

static void tell_whole_field(contactd_contact* contact, const char* path) {
    double value = 0;
    const int32_t code = contactd_get(contact, path, &value);
    tell_whole((int32_t)value, code);
}

static void tell_fields(contactd_contact* contact, const char* path, int count_of_fields) {
    double values_of_fields[6] = {0};
    const int32_t code = contactd_get_array(contact, path, values_of_fields, count_of_fields);
    for (int i = 0; i < count_of_fields; ++i) tell(values_of_fields[i], code);
}

static void tell_arrays(contactd_contact* contact) {
    for (int which = 0; which < contact_arrays; ++which) {
        int32_t elements = 0;
        if (contactd_length(contact, "pressure", &elements) != CONTACTD_OK) exit(3);
        double* array = values(elements);
        if (contactd_get_array(contact, arrays[which], array, elements) != CONTACTD_OK && which < sure_arrays) exit(3);
        which == 0 ? tell_division(array, elements) : tell_digest(array, elements);
        free(array);
    }
}

static void tell_warnings(contactd_contact* contact) {
    double warnings = 0;
    uint64_t sum = 0;
    char path[40], text[2000];
    if (contactd_get(contact, "warnings", &warnings) != CONTACTD_OK) exit(3);
    for (int i = 0; i < warnings; ++i) {
        snprintf(path, sizeof path, "warnings[%d]", i);
        contactd_get_word(contact, path, text, sizeof text);
        for (const char* c = text; *c != '\0'; ++c) sum = digest(sum, (unsigned char)*c);
    }
    printf(" %" PRId32 " %" PRIu64, (int32_t)warnings, sum);
}

static void tell_solvers(contactd_contact* contact) {
    static const char* const solvers[] = {"evidence.normal", "evidence.tangential", "evidence.outer", "evidence.force"};
    static const char* const fine = "evidence.discretisation";
    double value = 0;
    int32_t code;
    tell_whole_field(contact, "converged");
    for (int solver = 0; solver < 4; ++solver) {
        code = get(contact, solvers[solver], "iterations", &value);
        tell_whole((int32_t)value, code);
        code = get(contact, solvers[solver], "residual", &value);
        tell(value, code);
        code = get(contact, solvers[solver], "converged", &value);
        tell_whole((int32_t)value, code);
    }
    code = get(contact, fine, "elements_across", &value);
    tell_whole((int32_t)value, code);
    tell_field(contact, "evidence.discretisation.force_error");
    tell_field(contact, "evidence.discretisation.pmax_error");
    if (get(contact, fine, "rolling_error", &value) != CONTACTD_OK) value = 0;
    tell(value, code);
}

static void tell_motion(contactd_contact* contact) {
    static const char* const paths[2][3] = {{"motion.xi", "motion.eta", "motion.phi"},
                                            {"motion.rigid_shift.x", "motion.rigid_shift.y", "motion.rotation"}};
    double value = 0;
    const int kind = contactd_get(contact, "motion.xi", &value) == CONTACTD_OK ? 0 : 1;
    for (int i = 0; i < 3; ++i) tell_field(contact, paths[kind][i]);
}

/* Uses whichever of these exists. */
static void tell_derivatives(contactd_contact* contact) {
    static const char* const of[] = {"derivatives.Fx", "derivatives.Fy", "derivatives.Mz", "derivatives.Fn",
                                     "derivatives.approach"};
    static const char* const by[5][2] = {
        {"xi", "rigid_shift.x"}, {"eta", "rigid_shift.y"}, {"phi", "rotation"}, {"approach", "Fn"}, {"mu", "mu"}};
    for (int i = 0; i < 5; ++i)
        for (int k = 0; k < 5; ++k) {
            double value = 0;
            int32_t code = get(contact, of[i], by[k][0], &value);
            if (code != CONTACTD_OK) code = get(contact, of[i], by[k][1], &value);
            tell(value, code);
        }
}

static void tell_step(contactd_contact* contact) {
    tell_whole_field(contact, "step");
    tell_fields(contact, "forces", 4);
    tell_field(contact, "approach");
    tell_field(contact, "pmax");
    tell_fields(contact, "area", 4);
    tell_whole_field(contact, "elements.contact");
    tell_whole_field(contact, "elements.adhesion");
    tell_whole_field(contact, "elements.slip");
    tell_whole_field(contact, "elements.border");
    tell_motion(contact);
    tell_field(contact, "frictional_work");
    tell_field(contact, "frictional_power");
    tell_solvers(contact);
    tell_derivatives(contact);
    tell_warnings(contact);
    tell_arrays(contact);
    tell_fields(contact, "resultant", 6);
}

#endif
