/*
 * contactd: elastic contact from C and from languages that can call C. docs/c.md has examples and all rules.
 *
 *     contactd_connection *connection;
 *     contactd_contact *contact;
 *     contactd_open("ipc:///run/contactd.sock", &connection);
 *     contactd_new(connection, &contact);
 *     contactd_set(contact, "grid.nx", 25); ...
 *     contactd_start(contact);
 *     while (...) {
 *         contactd_set(contact, "Fn", 50e3);
 *         contactd_step(contact);
 *         contactd_get_array(contact, "forces", forces, 4);
 *     }
 *     contactd_free(contact);
 *     contactd_close(connection);
 *
 * Every function returns a code unless its comment says otherwise: CONTACTD_OK (0) on success. contactd_last_error
 * returns the message of a failure. No pointer may be NULL unless the comment of the function allows it. Only one
 * thread at a time may use a contact or a wheel; any number of threads may use a connection.
 *
 * Use any consistent units for contacts; the comments assume N and mm. Wheels require mm, N and rad. docs/contact.md
 * defines the signs. Arrays over the grid have nx*ny values, x running fastest: element (ix, iy) is at iy*nx + ix.
 */
#ifndef CONTACTD_H
#define CONTACTD_H

#include <stdint.h>

#define CONTACTD_VERSION_MAJOR 0
#define CONTACTD_VERSION_MINOR 1
#define CONTACTD_VERSION_PATCH 0

#if defined(__GNUC__) && !defined(_WIN32)
#define CONTACTD_API __attribute__((visibility("default")))
#else
#define CONTACTD_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* --- codes: those of the daemon's answers (docs/protocol.md) ------------------------------------------------- */
enum {
    CONTACTD_OK = 0,
    CONTACTD_CANCELLED = 1, /* by contactd_cancel or job.cancel */
    CONTACTD_UNKNOWN = 2,
    CONTACTD_INVALID_ARGUMENT = 3,  /* contactd_last_field names it; also invalid handles */
    CONTACTD_DEADLINE_EXCEEDED = 4, /* timeout */
    CONTACTD_NOT_FOUND = 5,         /* unknown session or state, or no such result */
    CONTACTD_ALREADY_EXISTS = 6,
    CONTACTD_PERMISSION_DENIED = 7,
    CONTACTD_RESOURCE_EXHAUSTED = 8,  /* out of memory, or a limit of the daemon */
    CONTACTD_FAILED_PRECONDITION = 9, /* wrong order, or used by another thread (CONCURRENT_USE) */
    CONTACTD_ABORTED = 10,            /* step not converged; the contact is unchanged */
    CONTACTD_OUT_OF_RANGE = 11,
    CONTACTD_UNIMPLEMENTED = 12, /* not supported by this library */
    CONTACTD_INTERNAL = 13,
    CONTACTD_UNAVAILABLE = 14, /* no daemon at this address */
    CONTACTD_DATA_LOSS = 15,
    CONTACTD_UNAUTHENTICATED = 16
};

/* --- enumerators --------------------------------------------------------------------------------------------- */
enum { CONTACTD_EXTERIOR = 0, CONTACTD_ADHESION = 1, CONTACTD_SLIP = 2, CONTACTD_FLOW = 3 }; /* state of an element */
enum { CONTACTD_LOG_DEBUG = 0, CONTACTD_LOG_INFO = 1, CONTACTD_LOG_WARNING = 2, CONTACTD_LOG_ERROR = 3 };

typedef struct contactd_connection contactd_connection; /* a daemon, or this process */
typedef struct contactd_contact contactd_contact;       /* one contact, step by step */
typedef struct contactd_wheel contactd_wheel;           /* one wheel on its rail */
/* Called from the thread that made the reported call. The callback must return; `text` is valid until then. */
typedef void (*contactd_log)(void* user, int32_t level, const char* text);

/* --- the library --------------------------------------------------------------------------------------------- */
CONTACTD_API const char* contactd_version(void);           /* "0.1.0" */
CONTACTD_API int32_t contactd_version_number(void);        /* 10000 major + 100 minor + patch */
CONTACTD_API int32_t contactd_has_local(void);             /* 1 if contactd_open accepts "local", else 0 */
CONTACTD_API const char* contactd_code_name(int32_t code); /* "INVALID_ARGUMENT"; "UNKNOWN" if invalid */

/* These describe the last failed call with this connection, contact or wheel: in this thread or, if none failed here,
 * in any thread. With NULL or an invalid handle they describe the last failure in this thread. A text is valid until
 * this thread calls the same function again. Without a failure they return "" and CONTACTD_OK. */
CONTACTD_API int32_t contactd_last_code(const void* handle);
CONTACTD_API const char* contactd_last_error(const void* handle);  /* one or more sentences */
CONTACTD_API const char* contactd_last_field(const void* handle);  /* path such as "gap.paraboloid.Rx", or "" */
CONTACTD_API const char* contactd_last_reason(const void* handle); /* "FIELD_INVALID", for programs, or "" */

/* --- fields by their paths ----------------------------------------------------------------------------------- */
/* Paths name fields as on the wire: "grid.dx" or "friction.rolling.xi" for inputs of a contact,
 * "setup.track.springs.z" or "state.position.yaw" for inputs of a wheel, "forces.Fn" or
 * "patches[0].place.creepages.xi" for results. docs/protocol.md lists all with units, bounds and defaults;
 * contactd/paths.h has them as constants. `handle` is a contact or a wheel. A value out of bounds is refused at once
 * with CONTACTD_INVALID_ARGUMENT; the message names the path, the value and the bounds. For an unknown path it lists
 * the valid names. A path is parsed once per handle, so you may use it in a loop.
 *
 * Sets a number, a flag (0 or 1) or an integer. This creates an optional field, or the next entry of a list. */
CONTACTD_API int32_t contactd_set(void* handle, const char* path, double value);
/* Sets a field to one of its keywords, such as "model" to "hertz". */
CONTACTD_API int32_t contactd_set_word(void* handle, const char* path, const char* keyword);
/* Sets all numbers of an object in the order of its fields, such as "state.velocity"; of a list, entry by entry; or of
 * an array over the grid, such as "gap.array" or "friction.mu". The list gets the length of the input. An entry of
 * "setup.friction.mu" is an angle and a coefficient, an entry of "setup.rail.points" is y and z. */
CONTACTD_API int32_t contactd_set_array(void* handle, const char* path, const double* values, int32_t count);
/* Removes an optional field or a list: without "friction" there is no friction, without "state.Fz" z is prescribed. */
CONTACTD_API int32_t contactd_clear(void* handle, const char* path);
/* Reads a number of the last solve or step, or the length of a list. Returns CONTACTD_NOT_FOUND if the solution does
 * not have it. */
CONTACTD_API int32_t contactd_get(void* handle, const char* path, double* value);
/* Copies a keyword or text into `text`, which has `length` bytes including the terminating zero. A longer one is
 * truncated. */
CONTACTD_API int32_t contactd_get_word(void* handle, const char* path, char* text, int32_t length);
/* Reads all numbers of an object or a list, in the order of contactd_set_array; or of an array over the grid that
 * contactd_want requested, such as "patches[0].solution.pressure". element_division contains CONTACTD_EXTERIOR,
 * _ADHESION, _SLIP and _FLOW. Without friction, slip is zero. `count` must equal that of contactd_length. */
CONTACTD_API int32_t contactd_get_array(void* handle, const char* path, double* values, int32_t count);
CONTACTD_API int32_t contactd_length(void* handle, const char* path, int32_t* count);
/* Requests an array over the grid in all later solves or steps (1), or omits it (0, the default): "pressure",
 * "traction_x", "traction_y", "slip_x", "slip_y", "element_division"; "displacement_x", "displacement_y" and
 * "displacement_z" if "displacements" is set; "flow_x", "flow_y" and "yield_stress" if a layer yields;
 * "friction_coefficient" if friction is velocity-weakening; "upper_temperature" and "lower_temperature" if
 * "temperature" is set. Wheels with the model full also have "gap", the undeformed distances. */
CONTACTD_API int32_t contactd_want(void* handle, const char* array, int32_t requested);

/* For loops in which a text costs too much: *id replaces the path of an input or a result for this handle, as long as
 * the handle is valid. */
CONTACTD_API int32_t contactd_path(void* handle, const char* path, int32_t* id);
CONTACTD_API int32_t contactd_set_at(void* handle, int32_t id, double value);
CONTACTD_API int32_t contactd_get_at(void* handle, int32_t id, double* value);

/* --- connections --------------------------------------------------------------------------------------------- */
/* Creates a connection without sending anything. `where` is the address of a daemon, "ipc:///path" or
 * "tcp://host:port", or "local" to solve in process (libcontactd-local only). On failure *connection is NULL. */
CONTACTD_API int32_t contactd_open(const char* where, contactd_connection** connection);
/* Closes the connection. Existing contacts stay valid; no new ones can be created. */
CONTACTD_API int32_t contactd_close(contactd_connection* connection);
/* Checks whether contacts can be solved now. */
CONTACTD_API int32_t contactd_ping(contactd_connection* connection);

/* The following settings apply to contacts created later. Timeouts are in seconds, > 0: for a call (default 60), for
 * contactd_start and wheels that may wait for finite elements (3600), and for a connection to a daemon (5). */
CONTACTD_API int32_t contactd_set_timeout(contactd_connection* connection, double seconds);
CONTACTD_API int32_t contactd_set_build_timeout(contactd_connection* connection, double seconds);
CONTACTD_API int32_t contactd_set_connect_timeout(contactd_connection* connection, double seconds);
/* Sets files of CURVE keys (docs/security.md): the daemon's public key, and your secret key. */
CONTACTD_API int32_t contactd_set_keys(contactd_connection* connection, const char* server_key, const char* own_key);
/* Sets the callback for log messages. With NULL there are none. Before the first call of this function, warnings in
 * answers are written to standard error, once per contact or wheel, and other messages are dropped. */
CONTACTD_API int32_t contactd_set_log(contactd_connection* connection, contactd_log log, void* user);

/* --- contacts ------------------------------------------------------------------------------------------------ */
/* The inputs are those of contact.solve (docs/contact.md), plus "lease_seconds" and "accept_unconverged" of a session.
 * The set-up is fixed by contactd_start: "grid", "bodies", "ics", "model", "columns", "settings", "previous". The load
 * can be set at any time and applies until it is set again: "gap", "approach" or "Fn" (the later one applies),
 * "friction", and "derivatives", which requests derivatives of steps.
 *
 * Without "grid.x0" or "grid.y0" the grid is centred along that axis. The lower body equals the upper one unless one
 * of its fields is set; "ics" applies to bodies without their own coefficients. Setting a field of a shape selects
 * that shape for the gap ("gap.semi_axes.a"), the section of a body ("ics.section.rail_60e1.support") or a part of its
 * outline ("parts[0].line.to"). Omit an infinite radius. The default coefficients are those of half-spaces in closed
 * form. By finite elements they have an accuracy of 1e-3; to set mesh and solver instead, clear "ics.accuracy". Bounds
 * of the numbers of bodies are checked in contactd_start.
 *
 * Without "friction.mu" there is no friction. The field that is set first determines the motion, a shift or rolling.
 * The other kind is refused until you clear "friction.rigid_shift" or "friction.rolling" by contactd_clear. With a
 * prescribed force, "friction.force.Fx" or "friction.rolling.force.Fx", the shift or creepage is an initial estimate.
 *
 * The results are those of session.step, with "step", the number of the last step, and "ics.upper.origin", the origin
 * of the coefficients. */
/* Creates a contact. On failure *contact is NULL. */
CONTACTD_API int32_t contactd_new(contactd_connection* connection, contactd_contact** contact);
/* Frees the contact. The handle is invalid after this call, whether or not it succeeds, unless another thread uses it
 * (CONCURRENT_USE). */
CONTACTD_API int32_t contactd_free(contactd_contact* contact);
/* Starts the contact with the current inputs, and waits for its coefficients. */
CONTACTD_API int32_t contactd_start(contactd_contact* contact);
/* Solves the next step, which starts from the end of the last one. A failed step leaves the contact unchanged. */
CONTACTD_API int32_t contactd_step(contactd_contact* contact);
/* Cancels the running call, which soon returns CONTACTD_CANCELLED; without a running call it has no effect. May be
 * called from any thread. */
CONTACTD_API int32_t contactd_cancel(contactd_contact* contact);
/* Sets the timeout of steps (s), which replaces that of the connection. */
CONTACTD_API int32_t contactd_set_step_timeout(contactd_contact* contact, double seconds);
/* Sets a table of coefficients of a body ("bodies.upper.ics", "bodies.lower.ics"), or of the pair ("ics").
 * values[3][3][ny][nx] (mm^3/N): displacement axis, load axis, offsets along y and x; count = 9*nx*ny. dx and dy are
 * the sizes of the elements of the table (mm). See docs/ic-tables.md. */
CONTACTD_API int32_t contactd_set_table(contactd_contact* contact, const char* path, int32_t nx, int32_t ny, double dx,
                                        double dy, const double* values, int32_t count);
/* Reads the frames of the columns of a body's section; `body` is "upper" or "lower". y[length] and z[length] are those
 * of their middles (mm), and angle[length] those of their outward normals from +z towards +y (rad). length = ny. This
 * function may be called before contactd_start. */
CONTACTD_API int32_t contactd_get_frames(contactd_contact* contact, const char* body, double* y, double* z,
                                         double* angle, int32_t length);
/* Sets the profile named by `path` from a file: Simpack (.prr, .prw), MiniProf (.ban, .whl), or two columns. The path
 * is "setup.rail" or "setup.rail_slices[0].profile" for a wheel, "ics.section.profile_section.profile" for a contact,
 * where the kind must be set first. The file is read in this call, by this process. "setup.rail.unit", ".mirror_y",
 * ".mirror_z" and ".smoothing_length" are then those of its points, and you may change them. With the path
 * "setup.rail.file" its text is stored and interpreted in the solve, according to "setup.rail.file.unit", ".mirror_y",
 * ".mirror_z", ".shift_y", ".shift_z" and ".smoothing_length"; a profile with ambiguous settings is refused. To use
 * content without a file, set "setup.rail.file.name" and "setup.rail.file.text". */
CONTACTD_API int32_t contactd_read_profile(void* handle, const char* path, const char* file);

/* --- steps of contacts and of wheels ------------------------------------------------------------------------- */
/* Solves the last step of contactd_step or contactd_wheel_solve again with the current inputs, from the state before
 * that step. An integrator can thus repeat a step until it accepts the result. */
CONTACTD_API int32_t contactd_step_again(void* handle);
/* Saves the state of a contact or a wheel with its results; before the first step it is the start. *state > 0
 * identifies it. States of a wheel are valid until its set-up changes. */
CONTACTD_API int32_t contactd_save(void* handle, int32_t* state);
CONTACTD_API int32_t contactd_restore(void* handle, int32_t state); /* any number of times */
CONTACTD_API int32_t contactd_forget(void* handle, int32_t state);

/* --- wheels on rails ----------------------------------------------------------------------------------------- */
/* Computes contact patches and forces from profiles and the position of a wheelset. docs/wheel-rail.md defines
 * coordinates and signs. Inputs and results are named by their paths:
 *
 *     contactd_wheel_new(connection, &wheel);
 *     contactd_set(wheel, "state.velocity.x", 20e3);
 *     contactd_set(wheel, "state.velocity.pitch", -20e3 / 460);
 *     contactd_set(wheel, "state.Fz", 80e3);
 *     while (...) {
 *         contactd_set(wheel, "state.position.y", y);
 *         contactd_wheel_solve(wheel);
 *         contactd_get_array(wheel, "forces.track", forces, 6);
 *     }
 *
 * A wheel needs no start. By default it is a right wheel, S1002 on 60E1 at 1/40, gauge 1435, of steel, with mu = 0.3
 * and elements of 0.2 mm. Every input can be set at any time and applies until it is set again. While its set-up is
 * unchanged, a wheel keeps its profiles and operators, with a daemon in its own session, and a solve starts from the
 * end of the previous one. With "state.motion" steady_rolling this start is an estimate: the answer is that of a new
 * wheel within the tolerances. contactd_step_again always starts from nothing, and its answers are the same to the
 * last bit, independent of earlier solves. Transient steps start from the tractions of the previous solve, also of a
 * steady one. Lengths are in mm, angles in rad, forces in N on the rail.
 *
 * Profiles are those of a right side, also for left wheels: y to the field side, z down. Setting a field of a shape
 * selects that shape: "setup.wheel.s1002" (1), "setup.rail.rail_60e1.inclination", "setup.rail.arc.radius", .slope and
 * .ends (from y to y), "setup.wheel.cone.slope" and .ends, or "setup.rail.points" with .smoothing_length, .unit,
 * .mirror_y and .mirror_z. Each slice has a profile: "setup.wheel_slices[0].angle",
 * "setup.wheel_slices[0].profile.points". Bodies are elastic or rigid: "setup.bodies.upper.G" and .nu, or .rigid (1),
 * for the rail; lower for the wheel. "setup.friction.mu" may be a single number. Bounds of the numbers of profiles and
 * bodies are checked in the solve. */
/* Creates a wheel. On failure *wheel is NULL. */
CONTACTD_API int32_t contactd_wheel_new(contactd_connection* connection, contactd_wheel** wheel);
/* Frees the wheel. The handle is invalid after this call unless another thread uses it (CONCURRENT_USE). */
CONTACTD_API int32_t contactd_wheel_free(contactd_wheel* wheel);
/* Solves the wheel. Without contact the call succeeds and there are no patches. It also succeeds if a solver missed
 * its tolerance; the result "converged" reports this. A failed solve leaves the wheel and its results unchanged. */
CONTACTD_API int32_t contactd_wheel_solve(contactd_wheel* wheel);
/* Solves the wheels of a vehicle, each like contactd_wheel_solve. `threads` is the number of threads in process,
 * including this one; 0 means the number of processors. A daemon receives one message, which its workers share.
 * Cancelling one wheel, or the shortest of the timeouts, ends it for all. Answers do not depend on the number of
 * threads or workers. A wheel that fails does not affect the others: the function returns the code of the first
 * failure, and each wheel stores its own. If a handle is invalid or repeated, no wheel is solved (INVALID_ARGUMENT).
 * Log callbacks run in this thread after all solves. */
CONTACTD_API int32_t contactd_wheel_solve_many(contactd_wheel* const* wheels, int32_t count, int32_t threads);
/* Solves both wheels of a wheelset that is free to roll. Computes the height and roll at which each wheel presses on
 * its rail with its "state.Fz". Position, velocity and pitch rate of a roller must be the same for both, except z and
 * roll, where the values of the right wheel are the start of the search. A longitudinal force and derivatives are not
 * supported. Each wheel receives its results, which have converged if both wheels and the search for the roll have. A
 * solve starts from the end of the last one of the right wheel with these set-ups, with a daemon at its height and
 * roll. This changes the answer within the tolerances. Timeout and failures are those of the right wheel; cancelling
 * either wheel cancels both. */
CONTACTD_API int32_t contactd_wheel_solve_wheelset(contactd_wheel* right, contactd_wheel* left);
/* Cancels the running solve, which soon returns CONTACTD_CANCELLED; without a running solve it has no effect. May be
 * called from any thread. */
CONTACTD_API int32_t contactd_wheel_cancel(contactd_wheel* wheel);
/* Sets the timeout of solves (s), which replaces that of the connection. */
CONTACTD_API int32_t contactd_wheel_set_timeout(contactd_wheel* wheel, double seconds);

#ifdef __cplusplus
}
#endif

#endif
