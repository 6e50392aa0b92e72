/* The functions of contactd.h by name, for contactd_mex.c, whose helpers read the arguments. */

/* Calls the function `name` if that is the command, and ends. */
#define CALL(name, ...)                      \
    if (!strcmp(command, #name)) {           \
        check(contactd_##name(__VA_ARGS__)); \
        return 1;                            \
    }

/* All numbers of a result: a column or, where the call says rows and columns, so many of them. */
static mxArray* read_array(const char* path) {
    void* of = (void*)(uintptr_t)handle;
    const int is_shaped = given_count > 3;
    int32_t count = 0, rows, columns;
    mxArray* values;
    check(contactd_length(of, path, &count));
    rows = is_shaped ? whole(1) : count;
    columns = is_shaped ? whole(2) : 1;
    if (rows < 0 || columns < 0 || (int64_t)rows * columns != count)
        mexErrMsgIdAndTxt("contactd:arguments", "'%s' has %d numbers.", path, (int)count);
    values = mxCreateDoubleMatrix((mwSize)rows, (mwSize)columns, mxREAL);
    check(contactd_get_array(of, path, mxGetPr(values), count));
    return values;
}

/* Fields by their paths. */
static int call_of_field(const char* command, mxArray* plhs[]) {
    static const char* const commands[] = {"set", "set_word", "set_array", "clear",  "want",
                                           "get", "get_word", "get_array", "length", "path"};
    void* of = (void*)(uintptr_t)handle;
    char path[longest_text], text[longest_text];
    double value = 0;
    int32_t whole_number = 0;
    size_t i = 0;
    CALL(set_at, of, whole(0), number(1))
    if (!strcmp(command, "get_at")) {
        check(contactd_get_at(of, whole(0), &value));
        plhs[0] = mxCreateDoubleScalar(value);
        return 1;
    }
    while (i < sizeof commands / sizeof commands[0] && strcmp(command, commands[i])) ++i;
    if (i == sizeof commands / sizeof commands[0]) return 0;
    read_text(argument(0), 3, path);
    if (!strcmp(command, "set")) {
        check(contactd_set(of, path, number(1)));
    } else if (!strcmp(command, "set_word")) {
        read_text(argument(1), 4, text);
        check(contactd_set_word(of, path, text));
    } else if (!strcmp(command, "set_array")) {
        check(contactd_set_array(of, path, array(1), length(1, 1)));
    } else if (!strcmp(command, "clear")) {
        check(contactd_clear(of, path));
    } else if (!strcmp(command, "want")) {
        check(contactd_want(of, path, whole(1)));
    } else if (!strcmp(command, "get")) {
        check(contactd_get(of, path, &value));
        plhs[0] = mxCreateDoubleScalar(value);
    } else if (!strcmp(command, "get_word")) {
        check(contactd_get_word(of, path, text, longest_text));
        plhs[0] = mxCreateString(text);
    } else if (!strcmp(command, "get_array")) {
        plhs[0] = read_array(path);
    } else {
        check(!strcmp(command, "path") ? contactd_path(of, path, &whole_number)
                                       : contactd_length(of, path, &whole_number));
        plhs[0] = mxCreateDoubleScalar(whole_number);
    }
    return 1;
}

/* Wheels on rails. */
static int call_of_wheel(const char* command) {
    contactd_wheel* w = (contactd_wheel*)(uintptr_t)handle;
    char path[longest_text], file[longest_text];
    CALL(wheel_free, w)
    CALL(wheel_solve, w)
    CALL(wheel_solve_wheelset, w, (contactd_wheel*)(uintptr_t)handle_in(argument(0), 3))
    CALL(wheel_cancel, w)
    CALL(wheel_set_timeout, w, number(0))
    if (strcmp(command, "wheel_read_profile")) return 0;
    read_text(argument(0), 3, path);
    read_text(argument(1), 4, file);
    check(contactd_wheel_read_profile(w, path, file));
    return 1;
}

static int call_of_connection(const char* command, mxArray* plhs[]) {
    contactd_connection* c = (contactd_connection*)(uintptr_t)handle;
    contactd_contact* contact = NULL;
    contactd_wheel* wheel = NULL;
    char server_key[longest_text], own_key[longest_text];
    if (!strcmp(command, "new")) {
        check(contactd_new(c, &contact));
        plhs[0] = made_handle(contact);
        return 1;
    }
    if (!strcmp(command, "wheel_new")) {
        check(contactd_wheel_new(c, &wheel));
        plhs[0] = made_handle(wheel);
        return 1;
    }
    if (!strcmp(command, "set_keys")) {
        read_text(argument(0), 3, server_key);
        read_text(argument(1), 4, own_key);
        check(contactd_set_keys(c, server_key, own_key));
        return 1;
    }
    CALL(close, c)
    CALL(ping, c)
    CALL(set_timeout, c, number(0))
    CALL(set_build_timeout, c, number(0))
    CALL(set_connect_timeout, c, number(0))
    CALL(set_log, c, whole(0) ? print_line : NULL, NULL) /* 1: into the command window */
    return 0;
}

static int call_that_sets(const char* command) {
    contactd_contact* c = (contactd_contact*)(uintptr_t)handle;
    CALL(free, c)
    CALL(start, c)
    CALL(step, c)
    CALL(step_again, c)
    CALL(want_derivatives, c, whole(0))
    CALL(cancel, c)
    CALL(restore, c, whole(0))
    CALL(forget, c, whole(0))
    CALL(set_grid, c, whole(0), whole(1), number(2), number(3), number(4), number(5))
    CALL(set_grid_centred, c, whole(0), whole(1), number(2), number(3))
    CALL(set_material, c, whole(0), number(1), number(2))
    CALL(set_rigid, c, whole(0))
    CALL(set_half_space, c, whole(0), whole(1))
    CALL(set_fem, c, whole(0), whole(1), whole(2), number(3), number(4))
    CALL(set_table, c, whole(0), whole(1), whole(2), number(3), number(4), array(5), length(5, 5))
    CALL(set_line_contact, c, number(0))
    CALL(set_layers, c, whole(0), whole(1), array(2), array(3), array(4), length(2, 4), number(5), number(6))
    CALL(set_model, c, whole(0))
    CALL(set_tolerance, c, whole(0), number(1), whole(2))
    CALL(set_accept_unconverged, c, whole(0))
    CALL(set_previous, c, array(0), array(1), array(2), length(0, 2))
    CALL(set_lease, c, number(0))
    CALL(set_approach, c, number(0))
    CALL(set_Fn, c, number(0))
    CALL(set_paraboloid, c, number(0), number(1))
    CALL(set_semi_axes, c, number(0), number(1))
    CALL(set_gap, c, array(0), length(0, 0))
    CALL(set_mu, c, number(0))
    CALL(set_mu_array, c, array(0), length(0, 0))
    CALL(set_kinetic, c, whole(0), number(1), number(2))
    CALL(set_shift, c, number(0), number(1), number(2))
    CALL(set_duration, c, number(0))
    CALL(set_rolling, c, whole(0), number(1), number(2), number(3))
    CALL(set_direction, c, number(0), number(1))
    CALL(set_spin_offset, c, number(0))
    CALL(set_rolling_steps, c, whole(0))
    CALL(set_velocity, c, number(0))
    CALL(set_Fx, c, number(0))
    CALL(set_Fy, c, number(0))
    CALL(clear_forces, c)
    CALL(set_rigid_slip, c, array(0), array(1), length(0, 1))
    CALL(set_step_timeout, c, number(0))
    return 0;
}

/* Those of a function's results that were asked for. */
static void put(const double* results, int count, int nlhs, mxArray* plhs[]) {
    int k;
    for (k = 0; k < count && (k == 0 || k < nlhs); ++k) plhs[k] = mxCreateDoubleScalar(results[k]);
}

/* Functions that read doubles, or whole numbers. */
#define DOUBLES(name, count, ...)            \
    if (!strcmp(command, #name)) {           \
        check(contactd_##name(__VA_ARGS__)); \
        put(x, count, nlhs, plhs);           \
        return 1;                            \
    }
#define WHOLES(name, count, ...)                 \
    if (!strcmp(command, #name)) {               \
        check(contactd_##name(__VA_ARGS__));     \
        for (k = 0; k < count; ++k) x[k] = n[k]; \
        put(x, count, nlhs, plhs);               \
        return 1;                                \
    }
#define TEXT(name, ...)                      \
    if (!strcmp(command, #name)) {           \
        check(contactd_##name(__VA_ARGS__)); \
        plhs[0] = mxCreateString(text);      \
        return 1;                            \
    }

static int call_that_reads(const char* command, int nlhs, mxArray* plhs[]) {
    contactd_contact* c = (contactd_contact*)(uintptr_t)handle;
    double x[4];
    int32_t n[4];
    char text[longest_text];
    int k;
    WHOLES(save, 1, c, n)
    WHOLES(get_step, 1, c, n)
    WHOLES(get_converged, 1, c, n)
    WHOLES(get_warnings, 1, c, n)
    WHOLES(get_counts, 4, c, n, n + 1, n + 2, n + 3)
    DOUBLES(get_forces, 4, c, x, x + 1, x + 2, x + 3)
    DOUBLES(get_approach, 1, c, x)
    DOUBLES(get_pmax, 1, c, x)
    DOUBLES(get_derivative, 1, c, whole(0), whole(1), x)
    DOUBLES(get_areas, 3, c, x, x + 1, x + 2)
    DOUBLES(get_creepages, 3, c, x, x + 1, x + 2)
    DOUBLES(get_shift, 3, c, x, x + 1, x + 2)
    DOUBLES(get_frictional_work, 1, c, x)
    DOUBLES(get_frictional_power, 1, c, x)
    TEXT(get_warning, c, whole(0), text, longest_text)
    TEXT(get_origin, c, whole(0), text, longest_text)
    if (!strcmp(command, "get_evidence")) {
        check(contactd_get_evidence(c, whole(0), n, x + 1, n + 1));
        x[0] = n[0];
        x[2] = n[1];
        put(x, 3, nlhs, plhs);
        return 1;
    }
    if (!strcmp(command, "get_discretisation")) {
        check(contactd_get_discretisation(c, n, x + 1, x + 2, x + 3));
        x[0] = n[0];
        put(x, 4, nlhs, plhs);
        return 1;
    }
    return 0;
}
