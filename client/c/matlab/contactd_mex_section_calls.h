/* Cross-sections and curved columns, for contactd_mex.c; behind contactd_mex_calls.h, whose CALL they are. */

/* The frames of ny columns: y, z and the angle, ny x 1 each. */
static void read_frames(contactd_contact* c, int32_t body, int32_t ny, int nlhs, mxArray* plhs[]) {
    const int32_t count = ny > 0 ? ny : 0;
    mxArray* values[3];
    int k;
    for (k = 0; k < 3; ++k) values[k] = mxCreateDoubleMatrix((mwSize)count, 1, mxREAL);
    check(contactd_get_frames(c, body, mxGetPr(values[0]), mxGetPr(values[1]), mxGetPr(values[2]), count));
    for (k = 0; k < 3 && (k == 0 || k < nlhs); ++k) plhs[k] = values[k];
}

static int call_of_section(const char* command, int nlhs, mxArray* plhs[]) {
    contactd_contact* c = (contactd_contact*)(uintptr_t)handle;
    char path[longest_text];
    CALL(set_section, c, whole(0), whole(1), array(2), length(2, 2))
    CALL(set_profile_points, c, whole(0), whole(1), array(2), array(3), length(2, 3), number(4), number(5), number(6))
    CALL(set_outline, c, whole(0), number(1), number(2))
    CALL(add_line, c, whole(0), number(1), number(2), whole(3))
    CALL(add_arc, c, whole(0), number(1), number(2), number(3), whole(4))
    CALL(add_spline, c, whole(0), array(1), array(2), length(1, 2), whole(3))
    CALL(add_hole, c, whole(0), number(1), number(2))
    CALL(set_first_column, c, whole(0), whole(1), whole(2), number(3))
    CALL(set_section_place, c, whole(0), number(1), number(2))
    CALL(set_section_accuracy, c, whole(0), number(1))
    CALL(set_columns, c, array(0), array(1), array(2), length(0, 2), number(3), number(4), number(5))
    if (!strcmp(command, "set_profile_file")) {
        read_text(argument(2), 5, path);
        check(contactd_set_profile_file(c, whole(0), whole(1), path, number(3), number(4), number(5)));
        return 1;
    }
    if (!strcmp(command, "get_frames")) {
        read_frames(c, whole(0), whole(1), nlhs, plhs);
        return 1;
    }
    if (!strcmp(command, "get_resultant")) {
        plhs[0] = mxCreateDoubleMatrix(6, 1, mxREAL);
        check(contactd_get_resultant(c, mxGetPr(plhs[0])));
        return 1;
    }
    return 0;
}
