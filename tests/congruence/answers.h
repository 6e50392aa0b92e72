/* What the driver in C says of a step: telling.py has the order. */
#ifndef ANSWERS_H
#define ANSWERS_H

#include "telling.h"

static void tell_arrays(contactd_contact* contact, int32_t elements) {
    double* array = values(elements);
    for (int which = 0; which < contact_arrays; ++which) {
        if (contactd_get_array(contact, arrays[which], array, elements) != CONTACTD_OK) exit(3);
        which == 0 ? tell_division(array, elements) : tell_digest(array, elements);
    }
    free(array);
}

static void tell_warnings(contactd_contact* contact) {
    int32_t warnings = 0;
    uint64_t sum = 0;
    char text[2000];
    contactd_get_warnings(contact, &warnings);
    for (int32_t i = 0; i < warnings; ++i) {
        contactd_get_warning(contact, i, text, sizeof text);
        for (const char* c = text; *c != '\0'; ++c) sum = digest(sum, (unsigned char)*c);
    }
    printf(" %" PRId32 " %" PRIu64, warnings, sum);
}

static void tell_solvers(contactd_contact* contact) {
    int32_t iterations = 0, converged = 0, across = 0, code;
    double v[4] = {0};
    contactd_get_converged(contact, &converged);
    tell_whole(converged, CONTACTD_OK);
    for (int32_t solver = CONTACTD_NORMAL; solver <= CONTACTD_FORCE; ++solver) {
        code = contactd_get_evidence(contact, solver, &iterations, v, &converged);
        tell_whole(iterations, code);
        tell(v[0], code);
        tell_whole(converged, code);
    }
    code = contactd_get_discretisation(contact, &across, v, v + 1, v + 2);
    tell_whole(across, code);
    for (int i = 0; i < 3; ++i) tell(v[i], code);
}

static void tell_resultant(contactd_contact* contact) {
    double forces[6] = {0};
    const int32_t code = contactd_get_resultant(contact, forces);
    for (int i = 0; i < 6; ++i) tell(forces[i], code);
}

static void tell_step(contactd_contact* contact, int32_t elements) {
    double v[4] = {0};
    int32_t n[4] = {0}, code = contactd_get_step(contact, n);
    tell_whole(n[0], code);
    code = contactd_get_forces(contact, v, v + 1, v + 2, v + 3);
    for (int i = 0; i < 4; ++i) tell(v[i], code);
    code = contactd_get_approach(contact, v);
    tell(v[0], code);
    code = contactd_get_pmax(contact, v);
    tell(v[0], code);
    code = contactd_get_areas(contact, v, v + 1, v + 2);
    for (int i = 0; i < 3; ++i) tell(v[i], code);
    code = contactd_get_counts(contact, n, n + 1, n + 2, n + 3);
    for (int i = 0; i < 4; ++i) tell_whole(n[i], code);
    code = contactd_get_creepages(contact, v, v + 1, v + 2);
    if (code != CONTACTD_OK) code = contactd_get_shift(contact, v, v + 1, v + 2);
    for (int i = 0; i < 3; ++i) tell(v[i], code);
    code = contactd_get_frictional_work(contact, v);
    tell(v[0], code);
    code = contactd_get_frictional_power(contact, v);
    tell(v[0], code);
    tell_solvers(contact);
    for (int32_t of = CONTACTD_OF_FX; of <= CONTACTD_OF_APPROACH; ++of)
        for (int32_t by = CONTACTD_BY_X; by <= CONTACTD_BY_MU; ++by) {
            code = contactd_get_derivative(contact, of, by, v);
            tell(v[0], code);
        }
    tell_warnings(contact);
    tell_arrays(contact, elements);
    tell_resultant(contact);
}

#endif
