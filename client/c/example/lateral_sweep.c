/*
 * Moves a wheelset across the track in steps of a millimetre, and prints the forces on both rails and the positions of
 * their contacts.
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

static void set(contactd_wheel* wheel, const char* path, double value) {
    check(contactd_set(wheel, path, value), wheel);
}

static double get(contactd_wheel* wheel, const char* path) {
    double value;
    check(contactd_get(wheel, path, &value), wheel);
    return value;
}

static contactd_wheel* made_wheel(contactd_connection* connection, const char* side) {
    contactd_wheel* wheel;
    check(contactd_wheel_new(connection, &wheel), connection);
    check(contactd_set_word(wheel, "setup.side", side), wheel);
    set(wheel, "setup.dx", 0.5);
    set(wheel, "setup.dy", 0.5);
    set(wheel, "state.velocity.x", 20e3);
    set(wheel, "state.velocity.pitch", -20e3 / 460);
    set(wheel, "state.Fz", 80e3);
    return wheel;
}

static void show(contactd_wheel* wheel, const char* side, double y) {
    double forces[6], place[4];
    char path[80];
    int patch;
    set(wheel, "state.position.y", y);
    set(wheel, "state.position.yaw", 2.4e-3 * y);
    check(contactd_wheel_solve(wheel), wheel);
    check(contactd_get_array(wheel, "forces.track", forces, 6), wheel);
    printf("y %2.0f mm, %s: z %8.5f mm, Fx %11.4f N, Fy %11.4f N, Fz %11.4f N%s\n", y, side, get(wheel, "z"), forces[0],
           forces[1], forces[2], get(wheel, "converged") ? "" : " (not converged)");
    for (patch = 0; patch < get(wheel, "patches"); ++patch) {
        sprintf(path, "patches[%d].place.reference", patch); /* x, y, z and angle */
        check(contactd_get_array(wheel, path, place, 4), wheel);
        sprintf(path, "patches[%d].solution.pmax", patch);
        printf("    patch at y %9.4f mm, %7.4f rad, pmax %9.4f N/mm^2\n", place[1], place[3], get(wheel, path));
    }
}

int main(int argc, char** argv) {
    contactd_connection* connection;
    contactd_wheel *left, *right;
    int y;
    check(contactd_open(argc > 1 ? argv[1] : "tcp://127.0.0.1:5555", &connection), NULL);
    left = made_wheel(connection, "left");
    right = made_wheel(connection, "right");
    for (y = 0; y <= 6; ++y) {
        show(left, "left ", y);
        show(right, "right", y);
    }
    check(contactd_wheel_free(left), left);
    check(contactd_wheel_free(right), right);
    contactd_close(connection);
    return 0;
}
