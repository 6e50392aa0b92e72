/* Simulates the model Examples.Wheelset of the Modelica package with its external functions, in steps of 0.25 ms that
 * update velocities first. Prints y (m) at every 400th step, and the wrench of the right wheel at the start. With the
 * file of a creep-force table as the second argument, it prints forces of the table instead. */
#include <contactd_modelica.h>
#include <stdarg.h>
#include <stdio.h>

void ModelicaError(const char* text) {
    fputs(text, stdout);
    exit(3);
}
void ModelicaFormatError(const char* format, ...) {
    va_list arguments;
    va_start(arguments, format);
    vprintf(format, arguments);
    va_end(arguments);
    exit(3);
}

static int creep_forces(const char* path) {
    void* table = contactd_modelica_table_open(path, 0.28);
    double forces[3];
    contactd_modelica_creep_forces(table, 6e-3, 5e-3, 82e9, 0.3, 80e3, 1e-3, 2e-3, 0.3, forces, 3);
    printf("%.17g %.17g %.17g\n", forces[0], forces[1], forces[2]);
    contactd_modelica_table_close(table);
    return 0;
}

int main(int count, char** arguments) {
    if (count > 2) return creep_forces(arguments[2]);
    const char* model = count > 1 ? arguments[1] : "fastsim";
    void* left = contactd_modelica_open("local", "left", model, 0.3, 1e-3);
    void* right = contactd_modelica_open("local", "right", model, 0.3, 1e-3);
    double y = 3e-3, yaw = 0, y_rate = 0, yaw_rate = 0, on_left[6], on_right[6];
    for (int k = 0; k <= 2000; ++k) {
        contactd_modelica_solve(left, y, yaw, 10, y_rate, yaw_rate, -10 / 0.46, 50e3, on_left, 6);
        contactd_modelica_solve(right, y, yaw, 10, y_rate, yaw_rate, -10 / 0.46, 50e3, on_right, 6);
        if (k == 0) printf("%.17g %.17g %.17g\n", on_right[1], on_right[2], on_right[5]);
        if (k % 400 == 0) printf("%.17g\n", y);
        y_rate += 2.5e-4 * -(on_left[1] + on_right[1]) / 1000;
        yaw_rate += 2.5e-4 * -(on_left[5] + on_right[5]) / 600;
        y += 2.5e-4 * y_rate;
        yaw += 2.5e-4 * yaw_rate;
    }
    contactd_modelica_close(left);
    contactd_modelica_close(right);
    return 0;
}
