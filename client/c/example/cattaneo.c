/*
 * A sphere pressed on a plane and shifted (Cattaneo), in steps: it slips at the edge first.
 *
 *     contactd-c-example ipc:///run/contactd.sock
 */
#include <contactd.h>
#include <stdio.h>

/* Says what went wrong, if anything did. */
static int failed(int32_t code, const void* handle) {
    if (code == CONTACTD_OK) return 0;
    fprintf(stderr, "%s: %s\n", contactd_code_name(code), contactd_last_error(handle));
    return 1;
}

/* Each call answers a code, and the first that is not 0 ends the rest. */
static int32_t set_up(contactd_contact* contact) {
    int32_t code = contactd_set_grid_centred(contact, 40, 40, 0.06, 0.06);      /* elements, and the size of one (mm) */
    if (!code) code = contactd_set_material(contact, CONTACTD_BOTH, 200, 0.42); /* G (N/mm^2), nu */
    if (!code) code = contactd_set_paraboloid(contact, 50, 50);                 /* radii (mm) */
    if (!code) code = contactd_set_approach(contact, 0.02); /* mm; or contactd_set_Fn, a force (N) */
    if (!code) code = contactd_set_mu(contact, 0.4);
    if (!code) code = contactd_set_shift(contact, 0.00817 / 2, 0, 0); /* mm in each step */
    if (!code) code = contactd_start(contact);
    return code;
}

static int32_t step(contactd_contact* contact) {
    double Fn, Fx, Fy, Mz;
    int32_t number, all, adhesion, slip, border, code = contactd_step(contact);
    if (!code) code = contactd_get_step(contact, &number);
    if (!code) code = contactd_get_forces(contact, &Fn, &Fx, &Fy, &Mz);
    if (!code) code = contactd_get_counts(contact, &all, &adhesion, &slip, &border);
    if (!code) printf("step %d: Fn %.8g N, Fx %.8g N, %d elements stick, %d slip\n", number, Fn, Fx, adhesion, slip);
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
