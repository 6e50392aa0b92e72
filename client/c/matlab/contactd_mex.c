/*
 * contactd in MATLAB and Octave: the functions of contactd.h, by their names without contactd_.
 *
 *     connection = contactd('open', 'ipc:///run/contactd.sock');
 *     contact = contactd('new', connection);
 *     contactd('set', contact, 'bodies.upper.G', 200);
 *     contactd('set_word', contact, 'model', 'hertz');
 *     contactd('step', contact);
 *     Fn = contactd('get', contact, 'forces.Fn');
 *     p = contactd('get_array', contact, 'pressure', 25, 25);
 *
 * Arguments are those of the header. Outputs are returned; an array is a column unless the call states its numbers of
 * rows and columns, such as nx and ny. A code other than 0 raises an error such as 'contactd:INVALID_ARGUMENT' with the
 * library's message.
 *
 *     mex contactd_mex.c -output contactd -lcontactd          (MATLAB)
 *     mkoctfile --mex contactd_mex.c -o contactd -lcontactd   (Octave)
 */
#include <contactd.h>
#include <mex.h>
#include <string.h>

enum { longest_text = 4096 };

/* The arguments of the running call. MATLAB calls MEX files from one thread only. */
static const mxArray** given;
static int given_count;
static uint64_t handle;

static void check(int32_t code) {
    char id[64] = "contactd:";
    if (code == CONTACTD_OK) return;
    strncat(id, contactd_code_name(code), sizeof id - sizeof "contactd:");
    mexErrMsgIdAndTxt(id, "%s", contactd_last_error((const void*)(uintptr_t)handle));
}

/* Returns argument k after the handle, counted from 0. */
static const mxArray* argument(int k) {
    if (k + 2 >= given_count) mexErrMsgIdAndTxt("contactd:arguments", "Argument %d is missing.", k + 3);
    return given[k + 2];
}

static double number(int k) {
    const mxArray* value = argument(k);
    if (!(mxIsNumeric(value) || mxIsLogical(value)) || mxGetNumberOfElements(value) != 1)
        mexErrMsgIdAndTxt("contactd:arguments", "Argument %d must be a number.", k + 3);
    return mxGetScalar(value);
}

static void read_text(const mxArray* value, int place, char text[longest_text]) {
    if (!mxIsChar(value) || mxGetString(value, text, longest_text))
        mexErrMsgIdAndTxt("contactd:arguments", "Argument %d must be a string.", place);
}

static int32_t whole(int k) {
    const double real = number(k);
    if (!(real >= -2147483648.0 && real <= 2147483647.0) || real != (int32_t)real)
        mexErrMsgIdAndTxt("contactd:arguments", "Argument %d must be a whole number.", k + 3);
    return (int32_t)real;
}

static const double* array(int k) {
    const mxArray* value = argument(k);
    if (!mxIsDouble(value) || mxIsComplex(value))
        mexErrMsgIdAndTxt("contactd:arguments", "Argument %d must be an array of doubles.", k + 3);
    return mxGetPr(value);
}

static int32_t length(int k) {
    const size_t count = mxGetNumberOfElements(argument(k));
    if (count > 2147483647u) mexErrMsgIdAndTxt("contactd:arguments", "Argument %d is too long.", k + 3);
    return (int32_t)count;
}

static uint64_t handle_in(const mxArray* value, int place) {
    if (!mxIsUint64(value) || mxGetNumberOfElements(value) != 1)
        mexErrMsgIdAndTxt("contactd:arguments", "Argument %d must be a handle that 'open' or 'new' returned.", place);
    return *(const uint64_t*)mxGetData(value);
}

static mxArray* made_handle(const void* made) {
    mxArray* value = mxCreateNumericMatrix(1, 1, mxUINT64_CLASS, mxREAL);
    *(uint64_t*)mxGetData(value) = (uint64_t)(uintptr_t)made;
    return value;
}

static void print_line(void* user, int32_t level, const char* text) {
    static const char* const names[] = {"debug", "info", "warning", "error"};
    (void)user;
    mexPrintf("contactd: %s: %s\n", names[level & 3], text);
}

#include "contactd_mex_calls.h"

void mexFunction(int nlhs, mxArray* plhs[], int nrhs, const mxArray* prhs[]) {
    char command[longest_text], where[longest_text];
    contactd_connection* connection = NULL;
    contactd_creep_table* table = NULL;
    /* The library must stay loaded, because its threads may still run. */
    if (!mexIsLocked()) mexLock();
    if (nrhs < 1)
        mexErrMsgIdAndTxt("contactd:arguments",
                          "The first argument must be the name of a function, as in contactd('step', contact).");
    read_text(prhs[0], 1, command);
    handle = 0;
    given = prhs;
    given_count = nrhs;
    if (!strcmp(command, "version")) {
        plhs[0] = mxCreateString(contactd_version());
        return;
    }
    if (nrhs < 2) mexErrMsgIdAndTxt("contactd:arguments", "Argument 2 is missing.");
    if (!strcmp(command, "open")) {
        read_text(prhs[1], 2, where);
        check(contactd_open(where, &connection));
        plhs[0] = made_handle(connection);
        return;
    }
    if (!strcmp(command, "creep_table_open")) {
        read_text(prhs[1], 2, where);
        check(contactd_creep_table_open(where, number(0), &table));
        plhs[0] = made_handle(table);
        return;
    }
    handle = handle_in(prhs[1], 2);
    if (!call_of_field(command, plhs) && !call_of_connection(command, plhs) && !call_of_steps(command, plhs) &&
        !call_of_contact(command, nlhs, plhs) && !call_of_wheel(command) && !call_of_table(command, nlhs, plhs))
        mexErrMsgIdAndTxt("contactd:arguments", "There is no function '%s'.", command);
}
