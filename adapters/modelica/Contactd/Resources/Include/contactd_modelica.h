/* Implements the functions of the Modelica package Contactd: a wheel on its rail by contactd.h, with failures as
 * Modelica errors. Lengths are in m, angles in rad, forces in N and moments in N m, as in Modelica; contactd uses
 * mm. */
#ifndef CONTACTD_MODELICA_H
#define CONTACTD_MODELICA_H

#include <ModelicaUtilities.h>
#include <contactd.h>
#include <stdlib.h>

typedef struct {
    contactd_connection* connection;
    contactd_wheel* wheel;
    int solved;
} contactd_modelica_wheel;

static void contactd_modelica_check(int32_t code, const void* handle) {
    if (code != CONTACTD_OK) ModelicaFormatError("contactd: %s\n", contactd_last_error(handle));
}

/* endpoint: "local", or that of a daemon; side: "left", "right"; model: "full", "fastsim" and so on; element: m. The
 * function does not return after a failure, so nothing has to be freed. */
static void* contactd_modelica_open(const char* endpoint, const char* side, const char* model, double friction,
                                    double element) {
    contactd_modelica_wheel* of = (contactd_modelica_wheel*)calloc(1, sizeof *of);
    if (!of) ModelicaError("contactd: no memory for a wheel\n");
    contactd_modelica_check(contactd_open(endpoint, &of->connection), NULL);
    contactd_modelica_check(contactd_wheel_new(of->connection, &of->wheel), of->connection);
    contactd_modelica_check(contactd_set_word(of->wheel, "setup.side", side), of->wheel);
    contactd_modelica_check(contactd_set_word(of->wheel, "setup.model", model), of->wheel);
    contactd_modelica_check(contactd_set(of->wheel, "setup.friction.mu", friction), of->wheel);
    contactd_modelica_check(contactd_set(of->wheel, "setup.dx", 1e3 * element), of->wheel);
    contactd_modelica_check(contactd_set(of->wheel, "setup.dy", 1e3 * element), of->wheel);
    return of;
}

static void contactd_modelica_close(void* object) {
    contactd_modelica_wheel* of = (contactd_modelica_wheel*)object;
    if (!of) return;
    contactd_wheel_free(of->wheel);
    contactd_close(of->connection);
    free(of);
}

/* wrench[6]: forces and moments on the rail in the wheelset's axes, about its centre. Equal values have equal answers,
 * independent of earlier solves, as Modelica requires of a function. */
static void contactd_modelica_solve(void* object, double y, double yaw, double velocity, double y_rate, double yaw_rate,
                                    double pitch_rate, double load, double* wrench, int size) {
    contactd_modelica_wheel* of = (contactd_modelica_wheel*)object;
    contactd_wheel* wheel = of->wheel;
    if (size != 6) ModelicaError("contactd: a wrench has six numbers\n");
    contactd_modelica_check(contactd_set(wheel, "state.position.y", 1e3 * y), wheel);
    contactd_modelica_check(contactd_set(wheel, "state.position.yaw", yaw), wheel);
    contactd_modelica_check(contactd_set(wheel, "state.velocity.x", 1e3 * velocity), wheel);
    contactd_modelica_check(contactd_set(wheel, "state.velocity.y", 1e3 * y_rate), wheel);
    contactd_modelica_check(contactd_set(wheel, "state.velocity.yaw", yaw_rate), wheel);
    contactd_modelica_check(contactd_set(wheel, "state.velocity.pitch", pitch_rate), wheel);
    contactd_modelica_check(contactd_set(wheel, "state.Fz", load), wheel);
    contactd_modelica_check(of->solved ? contactd_step_again(wheel) : contactd_wheel_solve(wheel), wheel);
    if (!of->solved) {
        /* The first solve may start differently from later ones. */
        of->solved = 1;
        contactd_modelica_check(contactd_step_again(wheel), wheel);
    }
    contactd_modelica_check(contactd_get_array(wheel, "forces.wheelset", wrench, 6), wheel);
    for (int k = 3; k < 6; ++k) wrench[k] *= 1e-3;
}

static void* contactd_modelica_table_open(const char* path, double nu) {
    contactd_creep_table* table = NULL;
    contactd_modelica_check(contactd_creep_table_open(path, nu, &table), NULL);
    return table;
}

static void contactd_modelica_table_close(void* table) {
    if (table) contactd_creep_table_close((contactd_creep_table*)table);
}

/* forces[3]: on the upper body. Lengths are in m, G in N/m^2, the spin in 1/m, and the moment in N m. */
static void contactd_modelica_creep_forces(void* table, double a, double b, double G, double mu, double load, double xi,
                                           double eta, double phi, double* forces, int size) {
    const double creepages[3] = {xi, eta, 1e-3 * phi};
    if (size != 3) ModelicaError("contactd: creep forces are three numbers\n");
    contactd_modelica_check(contactd_creep_table_forces((contactd_creep_table*)table, 1e3 * a, 1e3 * b, 1e-6 * G, mu,
                                                        load, creepages, forces, NULL, NULL),
                            table);
    forces[2] *= 1e-3;
}

#endif
