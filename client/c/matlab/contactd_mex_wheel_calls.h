/* The functions of contactd.h for wheels on rails by name, for contactd_mex.c, behind contactd_mex_calls.h. */

/* Forces and moments, 6 x 1. */
#define FORCES(name, ...)                             \
    if (!strcmp(command, #name)) {                    \
        plhs[0] = mxCreateDoubleMatrix(6, 1, mxREAL); \
        x = mxGetPr(plhs[0]);                         \
        check(contactd_##name(__VA_ARGS__));          \
        return 1;                                     \
    }

static int call_that_sets_wheel(const char* command) {
    contactd_wheel* w = (contactd_wheel*)(uintptr_t)handle;
    char path[longest_text];
    CALL(wheel_free, w)
    CALL(wheel_solve, w)
    CALL(wheel_solve_wheelset, w, (contactd_wheel*)(uintptr_t)handle_in(argument(0), 3))
    CALL(wheel_cancel, w)
    CALL(wheel_set_timeout, w, number(0))
    CALL(wheel_set_side, w, whole(0))
    CALL(wheel_set_s1002, w)
    CALL(wheel_set_rail_60e1, w, number(0))
    CALL(wheel_set_arc, w, whole(0), number(1), number(2), number(3), number(4))
    CALL(wheel_set_cone, w, whole(0), number(1), number(2), number(3))
    CALL(wheel_set_points, w, whole(0), array(1), array(2), length(1, 2), number(3))
    CALL(wheel_add_slice, w, number(0))
    CALL(wheel_clear_slices, w)
    CALL(wheel_add_wheel_slice, w, number(0))
    CALL(wheel_clear_wheel_slices, w)
    CALL(wheel_set_track, w, number(0), number(1), number(2))
    CALL(wheel_set_rail_origin, w, number(0), number(1))
    CALL(wheel_set_roller, w, number(0))
    CALL(wheel_set_springs, w, number(0), number(1))
    CALL(wheel_set_wheelset, w, number(0), number(1), number(2))
    CALL(wheel_set_material, w, whole(0), number(1), number(2))
    CALL(wheel_set_rigid, w, whole(0))
    CALL(wheel_set_model, w, whole(0))
    CALL(wheel_set_mu, w, number(0))
    CALL(wheel_set_mu_by_angle, w, array(0), array(1), length(0, 1), whole(2))
    CALL(wheel_set_kinetic, w, whole(0), number(1), number(2))
    CALL(wheel_set_frictionless, w)
    CALL(wheel_set_elements, w, number(0), number(1), number(2))
    CALL(wheel_set_patch_rules, w, number(0), number(1), number(2), number(3), number(4))
    CALL(wheel_set_bilinear, w, whole(0))
    CALL(wheel_set_slip_of_surfaces, w, whole(0))
    CALL(wheel_set_mesh_search, w, whole(0))
    CALL(wheel_set_conformal, w, whole(0))
    CALL(wheel_set_tolerance, w, whole(0), number(1), whole(2))
    CALL(wheel_set_position, w, number(0), number(1), number(2), number(3))
    CALL(wheel_set_x, w, number(0))
    CALL(wheel_set_pitch_angle, w, number(0))
    CALL(wheel_set_velocity, w, number(0), number(1), number(2), number(3), number(4), number(5))
    CALL(wheel_set_deviation, w, number(0), number(1), number(2))
    CALL(wheel_set_deviation_rate, w, number(0), number(1), number(2))
    CALL(wheel_set_rail_forces, w, number(0), number(1))
    CALL(wheel_set_roller_pitch, w, number(0))
    CALL(wheel_set_Fz, w, number(0))
    CALL(wheel_set_Fx, w, number(0))
    CALL(wheel_clear_forces, w)
    CALL(wheel_want, w, whole(0), whole(1))
    CALL(wheel_want_derivatives, w, whole(0))
    if (!strcmp(command, "wheel_set_file")) {
        read_text(argument(1), 4, path);
        check(contactd_wheel_set_file(w, whole(0), path, number(2)));
        return 1;
    }
    return 0;
}

/* nx x ny values of an array, or of the division, of a patch. */
static mxArray* read_patch_array(contactd_wheel* w, int32_t patch, int32_t which) {
    double dx, dy, x0, y0;
    int32_t nx, ny;
    mwSize size[2];
    mxArray* values;
    check(contactd_wheel_get_grid(w, patch, &nx, &ny, &dx, &dy, &x0, &y0));
    size[0] = (mwSize)nx;
    size[1] = (mwSize)ny;
    if (which == CONTACTD_DIVISION) {
        values = mxCreateNumericArray(2, size, mxINT32_CLASS, mxREAL);
        check(contactd_wheel_get_division(w, patch, (int32_t*)mxGetData(values), nx * ny));
    } else {
        values = mxCreateNumericArray(2, size, mxDOUBLE_CLASS, mxREAL);
        check(contactd_wheel_get_array(w, patch, which, mxGetPr(values), nx * ny));
    }
    return values;
}

/* ny x 3: y, z and inclination of the rows of a curved contact. */
static mxArray* read_rows(contactd_wheel* w, int32_t patch) {
    double dx, dy, x0, y0, *y;
    int32_t nx, ny;
    mxArray* values;
    check(contactd_wheel_get_grid(w, patch, &nx, &ny, &dx, &dy, &x0, &y0));
    values = mxCreateDoubleMatrix((mwSize)ny, 3, mxREAL);
    y = mxGetPr(values);
    check(contactd_wheel_get_rows(w, patch, y, y + ny, y + 2 * ny, ny));
    return values;
}

static int call_that_reads_wheel(const char* command, int nlhs, mxArray* plhs[]) {
    contactd_wheel* w = (contactd_wheel*)(uintptr_t)handle;
    double numbers[6], *x = numbers;
    int32_t n[4];
    char text[longest_text];
    int k;
    DOUBLES(wheel_get_motion, 2, w, x, x + 1)
    DOUBLES(wheel_get_roll, 1, w, x)
    DOUBLES(wheel_get_rail_shift, 2, w, x, x + 1)
    DOUBLES(wheel_get_clearance, 1, w, x)
    FORCES(wheel_get_forces, w, whole(0), x)
    FORCES(wheel_get_derivative, w, whole(0), x)
    WHOLES(wheel_get_converged, 1, w, n)
    WHOLES(wheel_get_warnings, 1, w, n)
    WHOLES(wheel_get_patches, 1, w, n)
    DOUBLES(wheel_get_place, 4, w, whole(0), x, x + 1, x + 2, x + 3)
    DOUBLES(wheel_get_creepages, 4, w, whole(0), x, x + 1, x + 2, x + 3)
    DOUBLES(wheel_get_radii, 4, w, whole(0), x, x + 1, x + 2, x + 3)
    DOUBLES(wheel_get_contact_forces, 4, w, whole(0), x, x + 1, x + 2, x + 3)
    FORCES(wheel_get_patch_forces, w, whole(0), whole(1), x)
    DOUBLES(wheel_get_pressure, 2, w, whole(0), x, x + 1)
    DOUBLES(wheel_get_areas, 3, w, whole(0), x, x + 1, x + 2)
    DOUBLES(wheel_get_frictional_power, 1, w, whole(0), x)
    WHOLES(wheel_get_counts, 4, w, whole(0), n, n + 1, n + 2, n + 3)
    TEXT(wheel_get_warning, w, whole(0), text, longest_text)
    if (!strcmp(command, "wheel_get_evidence")) {
        check(contactd_wheel_get_evidence(w, whole(0), n, x + 1, n + 1));
        x[0] = n[0];
        x[2] = n[1];
        put(x, 3, nlhs, plhs);
        return 1;
    }
    if (!strcmp(command, "wheel_get_grid")) {
        check(contactd_wheel_get_grid(w, whole(0), n, n + 1, x + 2, x + 3, x + 4, x + 5));
        x[0] = n[0];
        x[1] = n[1];
        put(x, 6, nlhs, plhs);
        return 1;
    }
    if (!strcmp(command, "wheel_get_rows")) {
        plhs[0] = read_rows(w, whole(0));
        return 1;
    }
    if (!strcmp(command, "wheel_get_array")) {
        plhs[0] = read_patch_array(w, whole(0), whole(1));
        return 1;
    }
    return 0;
}
