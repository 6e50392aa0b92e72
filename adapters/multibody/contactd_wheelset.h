/* Computes the contact of both wheels of a wheelset, for multibody programs that provide its position, rotation and
 * velocities and need its force and moment. The adapters of Project Chrono and MBDyn share this header. It is C99 and
 * C++.
 *
 * All vectors are in the axes of the track: x forwards, y to the right, z down. The origin is at the wheelset's centre
 * when its tape circles stand on the plane of the rail tops, in the middle of the track. Units are m, rad, s, N, N m.
 * The wheelset's own y axis is its axle, to the right. The motion prescribes the heights, so no height is searched for;
 * a wheel above its rail has no force. */
#ifndef CONTACTD_WHEELSET_H
#define CONTACTD_WHEELSET_H

#include <contactd.h>
#include <math.h>
#include <string.h>

typedef struct {
    contactd_connection* connection;
    contactd_wheel* wheels[2]; /* left, right */
} contactd_wheelset;

/* Frees all objects that contactd_wheelset_open created, even if it failed. */
static inline void contactd_wheelset_close(contactd_wheelset* of) {
    for (int k = 0; k < 2; ++k)
        if (of->wheels[k]) contactd_wheel_free(of->wheels[k]);
    if (of->connection) contactd_close(of->connection);
    memset(of, 0, sizeof *of);
}

/* `where`: "local", or a daemon; `model`: "full", "fastsim" and so on; `element` in m. The profiles are S1002 on 60E1
 * at 1/40, the material is steel. Set other fields at of->wheels by their paths. Returns a code of contactd.h, with the
 * message in contactd_last_error(NULL). */
static inline int32_t contactd_wheelset_open(contactd_wheelset* of, const char* where, const char* model,
                                             double friction, double element) {
    static const char* const sides[] = {"left", "right"};
    memset(of, 0, sizeof *of);
    int32_t code = contactd_open(where, &of->connection);
    for (int k = 0; k < 2 && code == CONTACTD_OK; ++k) {
        code = contactd_wheel_new(of->connection, &of->wheels[k]);
        contactd_wheel* wheel = of->wheels[k];
        if (code == CONTACTD_OK) code = contactd_set_word(wheel, "setup.side", sides[k]);
        if (code == CONTACTD_OK) code = contactd_set_word(wheel, "setup.model", model);
        if (code == CONTACTD_OK) code = contactd_set(wheel, "setup.friction.mu", friction);
        if (code == CONTACTD_OK) code = contactd_set(wheel, "setup.dx", 1e3 * element);
        if (code == CONTACTD_OK) code = contactd_set(wheel, "setup.dy", 1e3 * element);
    }
    if (code != CONTACTD_OK) contactd_wheelset_close(of);
    return code;
}

/* rotation[3][3], by rows: columns are the wheelset's axes, however far it has rotated about its axle. omega: angular
 * velocity. Then force on the wheelset, and moment about its centre. Returns a code of contactd.h. */
static inline int32_t contactd_wheelset_solve(contactd_wheelset* of, const double place[3], const double rotation[9],
                                              const double velocity[3], const double omega[3], double force[3],
                                              double moment[3]) {
    /* The axle R e_y depends on yaw and roll, but not on the pitch: R = R_z(yaw) R_x(roll) R_y(pitch). */
    const double axle[3] = {rotation[1], rotation[4], rotation[7]};
    const double yaw = atan2(-axle[0], axle[1]), roll = atan2(axle[2], hypot(axle[0], axle[1]));
    const double c = cos(yaw), s = sin(yaw), cr = cos(roll), sr = sin(roll);
    const double axes[3][3] = {{c, -s * cr, s * sr}, {s, c * cr, -c * sr}, {0, sr, cr}};
    double rates[3];
    for (int k = 0; k < 3; ++k) rates[k] = axes[0][k] * omega[0] + axes[1][k] * omega[1] + axes[2][k] * omega[2];

    const double position[] = {1e3 * place[0], 1e3 * place[1], 1e3 * place[2], roll, yaw};
    const double motion[] = {1e3 * velocity[0], 1e3 * velocity[1], 1e3 * velocity[2], rates[0], rates[2], rates[1]};
    static const char* const places[] = {"state.position.x", "state.position.y", "state.position.z",
                                         "state.position.roll", "state.position.yaw"};
    static const char* const speeds[] = {"state.velocity.x",    "state.velocity.y",   "state.velocity.z",
                                         "state.velocity.roll", "state.velocity.yaw", "state.velocity.pitch"};
    for (int w = 0; w < 2; ++w) {
        for (int k = 0; k < 5; ++k) {
            const int32_t code = contactd_set(of->wheels[w], places[k], position[k]);
            if (code != CONTACTD_OK) return code;
        }
        for (int k = 0; k < 6; ++k) {
            const int32_t code = contactd_set(of->wheels[w], speeds[k], motion[k]);
            if (code != CONTACTD_OK) return code;
        }
    }
    int32_t code = contactd_wheel_solve_many(of->wheels, 2, 1);
    if (code != CONTACTD_OK) return code;

    double about[3] = {0, 0, 0};
    force[0] = force[1] = force[2] = 0;
    for (int w = 0; w < 2; ++w) {
        double track[6], own[6]; /* on the rail */
        code = contactd_get_array(of->wheels[w], "forces.track", track, 6);
        if (code == CONTACTD_OK) code = contactd_get_array(of->wheels[w], "forces.wheelset", own, 6);
        if (code != CONTACTD_OK) return code;
        for (int k = 0; k < 3; ++k) {
            force[k] -= track[k];
            about[k] -= 1e-3 * own[3 + k];
        }
    }
    for (int k = 0; k < 3; ++k) moment[k] = axes[k][0] * about[0] + axes[k][1] * about[1] + axes[k][2] * about[2];
    return CONTACTD_OK;
}

#endif
