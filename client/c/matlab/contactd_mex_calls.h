/* Calls the functions of contactd.h by their names, with the helpers of contactd_mex.c. */

enum { most_wheels = 256 };

/* If the command is `name`, calls the function and returns 1. */
#define CALL(name, ...)                      \
    if (!strcmp(command, #name)) {           \
        check(contactd_##name(__VA_ARGS__)); \
        return 1;                            \
    }

/* Returns all numbers of a result, as a column unless the call states the numbers of rows and columns. */
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

/* Sets and reads fields by their paths. */
static int call_of_field(const char* command, mxArray* plhs[]) {
    static const char* const commands[] = {"set",      "set_word",  "set_array", "clear", "want",        "get",
                                           "get_word", "get_array", "length",    "path",  "read_profile"};
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
        check(contactd_set_array(of, path, array(1), length(1)));
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
    } else if (!strcmp(command, "read_profile")) {
        read_text(argument(1), 4, text);
        check(contactd_read_profile(of, path, text));
    } else if (!strcmp(command, "get_array")) {
        plhs[0] = read_array(path);
    } else {
        check(!strcmp(command, "path") ? contactd_path(of, path, &whole_number)
                                       : contactd_length(of, path, &whole_number));
        plhs[0] = mxCreateDoubleScalar(whole_number);
    }
    return 1;
}

/* Repeats steps, and saves and restores states, of contacts and wheels. */
static int call_of_steps(const char* command, mxArray* plhs[]) {
    void* of = (void*)(uintptr_t)handle;
    int32_t state = 0;
    CALL(step_again, of)
    CALL(restore, of, whole(0))
    CALL(forget, of, whole(0))
    if (!strcmp(command, "save")) {
        check(contactd_save(of, &state));
        plhs[0] = mxCreateDoubleScalar(state);
        return 1;
    }
    return 0;
}

/* Solves the wheels of a vehicle: that of the handle and those in an array. */
static int32_t solve_many(int32_t threads) {
    contactd_wheel* wheels[most_wheels];
    const mxArray* others = argument(0);
    const size_t count = mxGetNumberOfElements(others);
    size_t i;
    int32_t code;
    if (!mxIsUint64(others) || count >= most_wheels)
        mexErrMsgIdAndTxt("contactd:arguments", "Argument 3 must be an array of up to %d handles of other wheels.",
                          most_wheels - 1);
    wheels[0] = (contactd_wheel*)(uintptr_t)handle;
    for (i = 0; i < count; ++i) wheels[i + 1] = (contactd_wheel*)(uintptr_t)((const uint64_t*)mxGetData(others))[i];
    code = contactd_wheel_solve_many(wheels, (int32_t)count + 1, threads);
    for (i = 0; i <= count && contactd_last_code(wheels[i]) != code;) ++i;
    if (i <= count) handle = (uint64_t)(uintptr_t)wheels[i]; /* its failure is reported */
    return code;
}

/* Wheels on rails. */
static int call_of_wheel(const char* command) {
    contactd_wheel* w = (contactd_wheel*)(uintptr_t)handle;
    if (!strcmp(command, "wheel_solve_many")) {
        check(solve_many(whole(1)));
        return 1;
    }
    CALL(wheel_free, w)
    CALL(wheel_solve, w)
    CALL(wheel_solve_wheelset, w, (contactd_wheel*)(uintptr_t)handle_in(argument(0), 3))
    CALL(wheel_cancel, w)
    CALL(wheel_set_timeout, w, number(0))
    return 0;
}

/* Forces of one contact or, as columns, of several: 3 x n, derivatives of force i by creepage j at (i, j, n), and
 * bounds. */
static void read_creep_forces(contactd_creep_table* t, int is_many, int nlhs, mxArray* plhs[]) {
    const int creepages = is_many ? 1 : 5;
    const int32_t count = is_many ? length(0) / 5 : 1;
    const mwSize shape[3] = {3, 3, (mwSize)count};
    mxArray* values[3];
    double *jacobian, swapped;
    int32_t n;
    int i, j;
    if ((is_many && length(0) != 5 * count) || length(creepages) != 3 * count)
        mexErrMsgIdAndTxt("contactd:arguments", "Each contact has 5 numbers and 3 creepages, in one column.");
    values[0] = mxCreateDoubleMatrix(3, (mwSize)count, mxREAL);
    values[1] = mxCreateNumericArray(3, shape, mxDOUBLE_CLASS, mxREAL);
    values[2] = mxCreateDoubleMatrix(2, (mwSize)count, mxREAL);
    jacobian = mxGetPr(values[1]);
    check(is_many ? contactd_creep_table_many(t, count, array(0), array(1), mxGetPr(values[0]), jacobian,
                                              mxGetPr(values[2]))
                  : contactd_creep_table_forces(t, number(0), number(1), number(2), number(3), number(4), array(5),
                                                mxGetPr(values[0]), jacobian, mxGetPr(values[2])));
    for (n = 0; n < count; ++n, jacobian += 9)
        for (i = 0; i < 3; ++i)
            for (j = 0; j < i; ++j) {
                swapped = jacobian[3 * i + j];
                jacobian[3 * i + j] = jacobian[3 * j + i];
                jacobian[3 * j + i] = swapped;
            }
    for (i = 0; i < 3 && (i == 0 || i < nlhs); ++i) plhs[i] = values[i];
}

static int call_of_table(const char* command, int nlhs, mxArray* plhs[]) {
    contactd_creep_table* t = (contactd_creep_table*)(uintptr_t)handle;
    double nu = 0, ratios[2] = {0, 0};
    char text[longest_text];
    CALL(creep_table_close, t)
    if (!strcmp(command, "creep_table_info")) { /* nu, the ends of a/b, and the description */
        check(contactd_creep_table_info(t, &nu, ratios, text, longest_text));
        plhs[0] = mxCreateDoubleScalar(nu);
        if (nlhs > 1) {
            plhs[1] = mxCreateDoubleMatrix(2, 1, mxREAL);
            memcpy(mxGetPr(plhs[1]), ratios, sizeof ratios);
        }
        if (nlhs > 2) plhs[2] = mxCreateString(text);
        return 1;
    }
    if (strcmp(command, "creep_table_forces") && strcmp(command, "creep_table_many")) return 0;
    read_creep_forces(t, !strcmp(command, "creep_table_many"), nlhs, plhs);
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
    CALL(set_log, c, whole(0) ? print_line : NULL, NULL) /* 1: print in the command window */
    return 0;
}

/* Returns y, z and the angle of the frames of ny columns, ny x 1 each. */
static void read_frames(contactd_contact* c, const char* body, int32_t ny, int nlhs, mxArray* plhs[]) {
    const int32_t count = ny > 0 ? ny : 0;
    mxArray* values[3];
    int k;
    for (k = 0; k < 3; ++k) values[k] = mxCreateDoubleMatrix((mwSize)count, 1, mxREAL);
    check(contactd_get_frames(c, body, mxGetPr(values[0]), mxGetPr(values[1]), mxGetPr(values[2]), count));
    for (k = 0; k < 3 && (k == 0 || k < nlhs); ++k) plhs[k] = values[k];
}

static int call_of_contact(const char* command, int nlhs, mxArray* plhs[]) {
    contactd_contact* c = (contactd_contact*)(uintptr_t)handle;
    char text[longest_text];
    CALL(free, c)
    CALL(start, c)
    CALL(step, c)
    CALL(cancel, c)
    CALL(set_step_timeout, c, number(0))
    if (!strcmp(command, "set_table")) {
        read_text(argument(0), 3, text);
        check(contactd_set_table(c, text, whole(1), whole(2), number(3), number(4), array(5), length(5)));
        return 1;
    }
    if (!strcmp(command, "get_frames")) {
        read_text(argument(0), 3, text);
        read_frames(c, text, whole(1), nlhs, plhs);
        return 1;
    }
    return 0;
}
