/*
 * A wheelset on its way across the track: forces on both rails and the place of their contacts, millimetre by
 * millimetre.
 *
 *     contactd-c-sweep ENDPOINT             a daemon, for example ipc:///run/contactd.sock
 *     contactd-c-local-sweep local          in process
 *
 *       left wheel            right wheel       S1002 on 60E1 at 1/40, gauge 1435 mm, 80 kN a wheel, mu = 0.3,
 *      |______|               |______|          20 m/s, yaw 2.4 mrad/mm, no roll; elements of 0.5 mm
 *   \_/               +--> y          \_/
 *      =====          v z            =====
 */
#include <contactd.h>
#include <stdio.h>
#include <stdlib.h>

static void check(int32_t code, const void* handle) {
    if (code == CONTACTD_OK) return;
    fprintf(stderr, "%s: %s\n", contactd_code_name(code), contactd_last_error(handle));
    exit(1);
}

static contactd_wheel* made_wheel(contactd_connection* connection, int32_t side) {
    contactd_wheel* wheel;
    check(contactd_wheel_new(connection, &wheel), connection);
    check(contactd_wheel_set_side(wheel, side), wheel);
    check(contactd_wheel_set_elements(wheel, 0.5, 0.5, 0), wheel);
    check(contactd_wheel_set_velocity(wheel, 20e3, 0, 0, 0, 0, -20e3 / 460), wheel);
    check(contactd_wheel_set_Fz(wheel, 80e3), wheel);
    return wheel;
}

static void show(contactd_wheel* wheel, const char* side, double y) {
    double forces[6], z, pitch, at_x, at_y, at_z, angle, approach, pmax;
    int32_t patches, patch, converged;
    check(contactd_wheel_set_position(wheel, y, 0, 0, 2.4e-3 * y), wheel);
    check(contactd_wheel_solve(wheel), wheel);
    check(contactd_wheel_get_motion(wheel, &z, &pitch), wheel);
    check(contactd_wheel_get_forces(wheel, CONTACTD_IN_TRACK, forces), wheel);
    check(contactd_wheel_get_converged(wheel, &converged), wheel);
    check(contactd_wheel_get_patches(wheel, &patches), wheel);
    printf("y %2.0f mm, %s: z %8.5f mm, Fx %11.4f N, Fy %11.4f N, Fz %11.4f N%s\n", y, side, z, forces[0], forces[1],
           forces[2], converged ? "" : " (not converged)");
    for (patch = 0; patch < patches; ++patch) {
        check(contactd_wheel_get_place(wheel, patch, &at_x, &at_y, &at_z, &angle), wheel);
        check(contactd_wheel_get_pressure(wheel, patch, &approach, &pmax), wheel);
        printf("    patch at y %9.4f mm, %7.4f rad, pmax %9.4f N/mm^2\n", at_y, angle, pmax);
    }
}

int main(int argc, char** argv) {
    contactd_connection* connection;
    contactd_wheel *left, *right;
    int y;
    check(contactd_open(argc > 1 ? argv[1] : "tcp://127.0.0.1:5555", &connection), NULL);
    left = made_wheel(connection, CONTACTD_LEFT);
    right = made_wheel(connection, CONTACTD_RIGHT);
    for (y = 0; y <= 6; ++y) {
        show(left, "left ", y);
        show(right, "right", y);
    }
    check(contactd_wheel_free(left), left);
    check(contactd_wheel_free(right), right);
    contactd_close(connection);
    return 0;
}
