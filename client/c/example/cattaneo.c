/*
 * Presses a sphere on a plane and shifts it in steps (Cattaneo). Slip starts at the edge.
 *
 *     contactd-c-example ipc:///run/contactd.sock
 */
#include <contactd.h>
#include <stdio.h>

/* Prints the error message, if any. */
static int failed(int32_t code, const void* handle) {
    if (code == CONTACTD_OK) return 0;
    fprintf(stderr, "%s: %s\n", contactd_code_name(code), contactd_last_error(handle));
    return 1;
}

static const struct {
    const char* path;
    double value;
} inputs[] = {
    {"grid.nx", 40},           {"grid.ny", 40},
    {"grid.dx", 0.06},                                    /* mm */
    {"grid.dy", 0.06},         {"bodies.upper.G", 200},   /* N/mm^2; the lower body equals the upper one */
    {"bodies.upper.nu", 0.42}, {"gap.paraboloid.Rx", 50}, /* mm */
    {"gap.paraboloid.Ry", 50}, {"approach", 0.02},        /* mm; or "Fn", a force (N) */
    {"friction.mu", 0.4},      {"friction.rigid_shift.x", 0.00817 / 2}, /* mm in each step */
};

/* Each call returns a code. The first code other than 0 skips the remaining calls. */
static int32_t set_up(contactd_contact* contact) {
    int32_t code = CONTACTD_OK;
    size_t i;
    for (i = 0; !code && i < sizeof inputs / sizeof inputs[0]; ++i)
        code = contactd_set(contact, inputs[i].path, inputs[i].value);
    return code ? code : contactd_start(contact);
}

static int32_t step(contactd_contact* contact) {
    double number, forces[4], adhesion, slip;
    int32_t code = contactd_step(contact);
    if (!code) code = contactd_get(contact, "step", &number);
    if (!code) code = contactd_get_array(contact, "forces", forces, 4); /* Fn, Fx, Fy, Mz */
    if (!code) code = contactd_get(contact, "elements.adhesion", &adhesion);
    if (!code) code = contactd_get(contact, "elements.slip", &slip);
    if (!code)
        printf("step %g: Fn %.8g N, Fx %.8g N, %g elements stick, %g slip\n", number, forces[0], forces[1], adhesion,
               slip);
    return code;
}

int main(int argc, char** argv) {
    contactd_connection* connection;
    contactd_contact* contact;
    int failure;
    if (argc != 2) {
        fprintf(stderr, "usage: %s ENDPOINT, e.g. ipc:///run/contactd.sock\n", argv[0]);
        return 2;
    }
    if (failed(contactd_open(argv[1], &connection), NULL)) return 1;
    failure = failed(contactd_new(connection, &contact), connection);
    if (!failure) {
        failure = failed(set_up(contact), contact) || failed(step(contact), contact) || failed(step(contact), contact);
        contactd_free(contact);
    }
    contactd_close(connection);
    return failure;
}
