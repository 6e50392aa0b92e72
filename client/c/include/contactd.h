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
 * Every function returns a code unless its comment states otherwise: CONTACTD_OK (0) on success. contactd_last_error
 * returns the message of a failure. Common errors of all functions are not repeated below:
 *
 * - CONTACTD_INVALID_ARGUMENT: a handle is invalid (reason NO_HANDLE), or a pointer is NULL. No pointer may be NULL
 *   unless the comment of the function allows it.
 * - CONTACTD_FAILED_PRECONDITION: another call uses the contact or the wheel (reason CONCURRENT_USE). Only one thread
 *   at a time may use them; any number of threads may use a connection.
 * - CONTACTD_RESOURCE_EXHAUSTED: out of memory, or a limit of the daemon.
 * - CONTACTD_INTERNAL: a defect of contactd.
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

/* --- handles and callbacks --------------------------------------------------------------------------------------- */
/* The compiler refuses a handle of the wrong kind. contactd_handle and contactd_any_handle accept several kinds, and
 * `void *`, which the call checks. In C, only GCC, Clang and compatible compilers refuse other pointers for these two;
 * C++ requires C++11. Define CONTACTD_UNTYPED_HANDLES before the header to declare both as `void *`, as a program that
 * takes the address of a function may require. The libraries are the same. */

typedef struct contactd_connection contactd_connection;   /* a daemon, or this process */
typedef struct contactd_contact contactd_contact;         /* one contact, step by step */
typedef struct contactd_wheel contactd_wheel;             /* one wheel on its rail */
typedef struct contactd_creep_table contactd_creep_table; /* creep forces from a file */

/* A pedantic compiler accepts the conversion to these unions only for functions of system headers. */
#if defined(__GNUC__) && !defined(__cplusplus) && !defined(CONTACTD_UNTYPED_HANDLES)
#define CONTACTD_HANDLE_UNIONS
#pragma GCC system_header
#endif

/* A contact or a wheel. */
#ifdef CONTACTD_HANDLE_UNIONS
typedef union {
    contactd_contact* contact;
    contactd_wheel* wheel;
} contactd_handle __attribute__((__transparent_union__));
#else
typedef void* contactd_handle;
#endif

/* A connection, a contact, a wheel or a table. */
#ifdef CONTACTD_HANDLE_UNIONS
typedef union {
    const contactd_connection* connection;
    const contactd_contact* contact;
    const contactd_wheel* wheel;
    const contactd_creep_table* table;
} contactd_any_handle __attribute__((__transparent_union__));
#else
typedef const void* contactd_any_handle;
#endif

/* Called from the thread that made the reported call. The callback must return; `text` is valid until then. */
typedef void (*contactd_log)(void* user, int32_t level, const char* text);

/* --- the library ------------------------------------------------------------------------------------------------- */
/**
 * @brief Returns the version of the library.
 * @return A text such as "0.1.0", valid as long as the library is loaded.
 */
CONTACTD_API const char* contactd_version(void);

/**
 * @brief Returns the version as a number.
 * @return 10000 major + 100 minor + patch.
 */
CONTACTD_API int32_t contactd_version_number(void);

/**
 * @brief Reports whether this library can solve in process.
 * @return 1 if contactd_open accepts "local", else 0.
 */
CONTACTD_API int32_t contactd_has_local(void);

/**
 * @brief Returns the name of a code.
 * @param code A code of this interface.
 * @return A text such as "INVALID_ARGUMENT"; "UNKNOWN" for an invalid code. It is valid as long as the library is
 *     loaded.
 */
CONTACTD_API const char* contactd_code_name(int32_t code);

/**
 * @brief Returns the code of the last failed call with a handle.
 *
 * The last failure is that in this thread or, if no call failed in this thread, in any thread. A successful call does
 * not change it.
 * @param handle A connection, a contact, a wheel or a table. With a table, the last failure in this thread; with NULL
 *     or an invalid handle, the last failure of any handle in this thread.
 * @return The code; CONTACTD_OK without a failure.
 */
CONTACTD_API int32_t contactd_last_code(contactd_any_handle handle);

/**
 * @brief Returns the message of the last failed call with a handle.
 * @param handle As for contactd_last_code.
 * @return One or more sentences; "" without a failure. Valid until this thread calls this function again.
 */
CONTACTD_API const char* contactd_last_error(contactd_any_handle handle);

/**
 * @brief Returns the field or argument named by the last failed call with a handle.
 * @param handle As for contactd_last_code.
 * @return A path such as "gap.paraboloid.Rx", or "". Valid until this thread calls this function again.
 */
CONTACTD_API const char* contactd_last_field(contactd_any_handle handle);

/**
 * @brief Returns the reason of the last failed call with a handle, as a keyword for programs.
 * @param handle As for contactd_last_code.
 * @return A keyword such as "FIELD_INVALID", or "". Valid until this thread calls this function again.
 */
CONTACTD_API const char* contactd_last_reason(contactd_any_handle handle);

/* --- fields by their paths --------------------------------------------------------------------------------------- */
/* Paths name fields as on the wire: "grid.dx" or "friction.rolling.xi" for inputs of a contact,
 * "setup.track.springs.z" or "state.position.yaw" for inputs of a wheel, "forces.Fn" or
 * "patches[0].place.creepages.xi" for results. docs/protocol.md lists all with units, bounds and defaults;
 * contactd/paths.h has them as constants. A path is parsed once per handle, so you may use it in a loop. */

/**
 * @brief Sets a number, a flag (0 or 1) or an integer.
 *
 * This creates an optional field, or the next entry of a list.
 * @param handle A contact or a wheel.
 * @param path Path of an input.
 * @param value The value, in the unit of the field.
 * @return CONTACTD_OK, one of the common errors, or one of these codes:
 * @retval CONTACTD_INVALID_ARGUMENT The path is unknown, the value is out of bounds, or the field belongs to the
 *     other kind of motion. The message names the path, the value and the bounds, or the valid names. The input keeps
 *     its value.
 * @retval CONTACTD_FAILED_PRECONDITION The contact was started, and the field is part of its set-up.
 */
CONTACTD_API int32_t contactd_set(contactd_handle handle, const char* path, double value);

/**
 * @brief Sets a field to one of its keywords, such as "model" to "hertz".
 * @param handle A contact or a wheel.
 * @param path Path of an input with keywords, or with a text.
 * @param keyword The keyword.
 * @return CONTACTD_OK, one of the common errors, or one of these codes:
 * @retval CONTACTD_INVALID_ARGUMENT The path or the keyword is invalid.
 * @retval CONTACTD_FAILED_PRECONDITION As for contactd_set.
 */
CONTACTD_API int32_t contactd_set_word(contactd_handle handle, const char* path, const char* keyword);

/**
 * @brief Sets all numbers of an object, of a list, or of an array over the grid.
 *
 * The numbers of an object, such as "state.velocity", are in the order of its fields; those of a list follow entry by
 * entry. The list gets the length of the input. An entry of "setup.friction.mu" is an angle and a coefficient, an
 * entry of "setup.rail.points" is y and z. Arrays over the grid are "gap.array" or "friction.mu".
 * @param handle A contact or a wheel.
 * @param path Path of an input.
 * @param values The numbers, in the units of the fields. They are copied.
 * @param count Number of values, at least 1.
 * @return CONTACTD_OK, one of the common errors, or one of these codes:
 * @retval CONTACTD_INVALID_ARGUMENT The path, a value or the count is invalid.
 * @retval CONTACTD_FAILED_PRECONDITION As for contactd_set.
 */
CONTACTD_API int32_t contactd_set_array(contactd_handle handle, const char* path, const double* values, int32_t count);

/**
 * @brief Removes an optional field or a list.
 *
 * Without "friction" there is no friction, without "state.Fz" z is prescribed.
 * @param handle A contact or a wheel.
 * @param path Path of an input.
 * @return CONTACTD_OK, one of the common errors, or one of these codes:
 * @retval CONTACTD_INVALID_ARGUMENT The path is unknown, or the field is required.
 * @retval CONTACTD_FAILED_PRECONDITION As for contactd_set.
 */
CONTACTD_API int32_t contactd_clear(contactd_handle handle, const char* path);

/**
 * @brief Reads a number of the last solve or step, or the length of a list.
 * @param handle A contact or a wheel.
 * @param path Path of a result.
 * @param[out] value The number, in the unit of the field.
 * @pre A step or solve has succeeded; "step" and "ics" of a contact are available after contactd_start.
 * @return CONTACTD_OK, one of the common errors, or one of these codes:
 * @retval CONTACTD_INVALID_ARGUMENT The path is unknown.
 * @retval CONTACTD_NOT_FOUND The solution does not have this result.
 * @retval CONTACTD_FAILED_PRECONDITION There are no results yet.
 */
CONTACTD_API int32_t contactd_get(contactd_handle handle, const char* path, double* value);

/**
 * @brief Copies a keyword or a text of the last solve or step.
 * @param handle A contact or a wheel.
 * @param path Path of a result.
 * @param[out] text The text. A longer one is truncated.
 * @param length Size of `text` in bytes, including the terminating zero, at least 1.
 * @pre As for contactd_get.
 * @return CONTACTD_OK, one of the common errors, or one of these codes:
 * @retval CONTACTD_INVALID_ARGUMENT The path or the length is invalid.
 * @retval CONTACTD_NOT_FOUND The solution does not have this result.
 * @retval CONTACTD_FAILED_PRECONDITION There are no results yet.
 */
CONTACTD_API int32_t contactd_get_word(contactd_handle handle, const char* path, char* text, int32_t length);

/**
 * @brief Reads all numbers of an object or a list, or of an array over the grid.
 *
 * Objects and lists have the order of contactd_set_array. Arrays over the grid are those that contactd_want
 * requested, such as "patches[0].solution.pressure". element_division contains CONTACTD_EXTERIOR, _ADHESION, _SLIP
 * and _FLOW. Without friction, slip is zero.
 * @param handle A contact or a wheel.
 * @param path Path of a result.
 * @param[out] values The numbers, in the units of the fields.
 * @param count Number of values; must equal that of contactd_length.
 * @pre As for contactd_get.
 * @return CONTACTD_OK, one of the common errors, or one of these codes:
 * @retval CONTACTD_INVALID_ARGUMENT The path is unknown, or the count differs. The message contains the right count.
 * @retval CONTACTD_NOT_FOUND The solution does not have this result.
 * @retval CONTACTD_FAILED_PRECONDITION There are no results yet, or the array was not requested.
 */
CONTACTD_API int32_t contactd_get_array(contactd_handle handle, const char* path, double* values, int32_t count);

/**
 * @brief Returns the number of values that contactd_get_array reads.
 * @param handle A contact or a wheel.
 * @param path Path of a result.
 * @param[out] count Number of values.
 * @pre As for contactd_get.
 * @return CONTACTD_OK, one of the common errors, or one of these codes:
 * @retval CONTACTD_INVALID_ARGUMENT The path is unknown.
 * @retval CONTACTD_NOT_FOUND The solution does not have this result.
 * @retval CONTACTD_FAILED_PRECONDITION There are no results yet, or the array was not requested.
 */
CONTACTD_API int32_t contactd_length(contactd_handle handle, const char* path, int32_t* count);

/**
 * @brief Requests or omits an array over the grid in all later solves or steps.
 *
 * The arrays are "pressure", "traction_x", "traction_y", "slip_x", "slip_y" and "element_division". With
 * "displacements" set, there are also "displacement_x", "displacement_y" and "displacement_z". A layer that yields
 * has "flow_x", "flow_y" and "yield_stress", velocity-weakening friction has "friction_coefficient". With
 * "temperature" set, there are "upper_temperature" and "lower_temperature". The model full has "pressure_by_approach"
 * (N/mm^3) with "derivatives" set, for wheels "state.derivatives". Wheels with the model full also have "gap", the
 * undeformed distances.
 * @param handle A contact or a wheel.
 * @param array Name of an array.
 * @param requested 1: return the array; 0, the default: omit it.
 * @return CONTACTD_OK, one of the common errors, or one of these codes:
 * @retval CONTACTD_INVALID_ARGUMENT The name or the flag is invalid. The message lists the names.
 */
CONTACTD_API int32_t contactd_want(contactd_handle handle, const char* array, int32_t requested);

/**
 * @brief Returns a number that replaces a path, for loops in which a text is too slow.
 * @param handle A contact or a wheel.
 * @param path Path of an input or a result.
 * @param[out] id The number, for this handle only. It is valid as long as the handle.
 * @return CONTACTD_OK, one of the common errors, or one of these codes:
 * @retval CONTACTD_INVALID_ARGUMENT The path is unknown.
 */
CONTACTD_API int32_t contactd_path(contactd_handle handle, const char* path, int32_t* id);

/**
 * @brief Sets a number like contactd_set.
 * @param handle The contact or wheel of the number.
 * @param id A number from contactd_path.
 * @param value The value, in the unit of the field.
 * @return CONTACTD_OK, one of the common errors, or one of these codes:
 * @retval CONTACTD_INVALID_ARGUMENT The number of the path is invalid; otherwise as for contactd_set.
 * @retval CONTACTD_FAILED_PRECONDITION As for contactd_set.
 */
CONTACTD_API int32_t contactd_set_at(contactd_handle handle, int32_t id, double value);

/**
 * @brief Reads a number like contactd_get.
 * @param handle The contact or wheel of the number.
 * @param id A number from contactd_path.
 * @param[out] value The number, in the unit of the field.
 * @pre As for contactd_get.
 * @return CONTACTD_OK, one of the common errors, or one of these codes:
 * @retval CONTACTD_INVALID_ARGUMENT The number of the path is invalid.
 * @retval CONTACTD_NOT_FOUND The solution does not have this result.
 * @retval CONTACTD_FAILED_PRECONDITION There are no results yet.
 */
CONTACTD_API int32_t contactd_get_at(contactd_handle handle, int32_t id, double* value);

/* --- connections ------------------------------------------------------------------------------------------------- */
/* Settings of a connection apply to contacts and wheels created later. */

/**
 * @brief Creates a connection without sending anything.
 * @param where Address of a daemon, "ipc:///path" or "tcp://host:port", or "local" to solve in process
 *     (libcontactd-local only).
 * @param[out] connection The connection; NULL on failure.
 * @return CONTACTD_OK, one of the common errors, or one of these codes:
 * @retval CONTACTD_INVALID_ARGUMENT The address is invalid.
 * @retval CONTACTD_UNIMPLEMENTED This library does not solve in process, or does not connect to daemons.
 */
CONTACTD_API int32_t contactd_open(const char* where, contactd_connection** connection);

/**
 * @brief Closes the connection.
 *
 * Existing contacts and wheels stay valid; no new ones can be created.
 * @param connection The connection, which is invalid after a successful call.
 * @return CONTACTD_OK, or one of the common errors.
 */
CONTACTD_API int32_t contactd_close(contactd_connection* connection);

/**
 * @brief Checks whether contacts can be solved now.
 * @param connection The connection.
 * @return CONTACTD_OK, one of the common errors, or one of these codes:
 * @retval CONTACTD_UNAVAILABLE No daemon listens at the address, or it is stopping.
 * @retval CONTACTD_DEADLINE_EXCEEDED The daemon does not answer within the timeout.
 */
CONTACTD_API int32_t contactd_ping(contactd_connection* connection);

/**
 * @brief Sets the timeout of calls. The default is 60 s.
 * @param connection The connection.
 * @param seconds The timeout (s), > 0 and at most 1e6.
 * @return CONTACTD_OK, one of the common errors, or one of these codes:
 * @retval CONTACTD_INVALID_ARGUMENT The time is out of bounds.
 */
CONTACTD_API int32_t contactd_set_timeout(contactd_connection* connection, double seconds);

/**
 * @brief Sets the timeout of contactd_start, and of wheels that may wait for finite elements. The default is 3600 s.
 * @param connection The connection.
 * @param seconds The timeout (s), > 0 and at most 1e6.
 * @return CONTACTD_OK, one of the common errors, or one of these codes:
 * @retval CONTACTD_INVALID_ARGUMENT The time is out of bounds.
 */
CONTACTD_API int32_t contactd_set_build_timeout(contactd_connection* connection, double seconds);

/**
 * @brief Sets the timeout of a connection to a daemon. The default is 5 s.
 * @param connection The connection.
 * @param seconds The timeout (s), > 0 and at most 1e6.
 * @return CONTACTD_OK, one of the common errors, or one of these codes:
 * @retval CONTACTD_INVALID_ARGUMENT The time is out of bounds.
 */
CONTACTD_API int32_t contactd_set_connect_timeout(contactd_connection* connection, double seconds);

/**
 * @brief Sets the files of CURVE keys (docs/security.md), which are read when a contact or a wheel connects.
 * @param connection The connection.
 * @param server_key File with the daemon's public key.
 * @param own_key File with your secret key.
 * @return CONTACTD_OK, or one of the common errors.
 */
CONTACTD_API int32_t contactd_set_keys(contactd_connection* connection, const char* server_key, const char* own_key);

/**
 * @brief Sets the callback for log messages.
 *
 * Before the first call of this function, warnings in answers are written to standard error, once per contact or
 * wheel, and other messages are dropped.
 * @param connection The connection.
 * @param log The callback; NULL disables messages.
 * @param user Passed to the callback; may be NULL.
 * @return CONTACTD_OK, or one of the common errors.
 */
CONTACTD_API int32_t contactd_set_log(contactd_connection* connection, contactd_log log, void* user);

/* --- contacts ---------------------------------------------------------------------------------------------------- */
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

/**
 * @brief Creates a contact.
 * @param connection The connection.
 * @param[out] contact The contact; NULL on failure.
 * @return CONTACTD_OK, or one of the common errors.
 */
CONTACTD_API int32_t contactd_new(contactd_connection* connection, contactd_contact** contact);

/**
 * @brief Frees the contact.
 * @param contact The contact. It is invalid after this call, whether or not the call succeeds, unless another thread
 *     uses it.
 * @return CONTACTD_OK, one of the common errors, or one of these codes:
 * @retval CONTACTD_FAILED_PRECONDITION Another thread uses the contact, which stays valid.
 * @retval CONTACTD_UNAVAILABLE The daemon did not answer. Its session ends with its lease.
 */
CONTACTD_API int32_t contactd_free(contactd_contact* contact);

/**
 * @brief Starts the contact with the current inputs, and waits for its coefficients.
 * @param contact The contact.
 * @return CONTACTD_OK, one of the common errors, or one of these codes:
 * @retval CONTACTD_INVALID_ARGUMENT An input is invalid or missing.
 * @retval CONTACTD_FAILED_PRECONDITION The contact was started before.
 * @retval CONTACTD_DEADLINE_EXCEEDED The coefficients are not available within the build timeout. A daemon continues
 *     the build, so you may call this function again.
 * @retval CONTACTD_CANCELLED contactd_cancel was called.
 * @retval CONTACTD_UNAVAILABLE No daemon listens at the address, or it is stopping.
 */
CONTACTD_API int32_t contactd_start(contactd_contact* contact);

/**
 * @brief Solves the next step, which starts from the end of the last one.
 *
 * A failed step leaves the contact unchanged.
 * @param contact The contact.
 * @pre contactd_start has succeeded; otherwise the call returns CONTACTD_FAILED_PRECONDITION.
 * @return CONTACTD_OK, one of the common errors, or one of these codes:
 * @retval CONTACTD_INVALID_ARGUMENT An input is invalid or missing.
 * @retval CONTACTD_ABORTED A solver missed its tolerance, and "accept_unconverged" is not set.
 * @retval CONTACTD_NOT_FOUND The daemon has ended the session, whose lease may have expired.
 * @retval CONTACTD_DEADLINE_EXCEEDED The timeout has passed.
 * @retval CONTACTD_CANCELLED contactd_cancel was called.
 * @retval CONTACTD_UNAVAILABLE No daemon listens at the address, or it is stopping.
 */
CONTACTD_API int32_t contactd_step(contactd_contact* contact);

/**
 * @brief Cancels the running call, which soon returns CONTACTD_CANCELLED.
 *
 * May be called from any thread. It has no effect without a running call.
 * @param contact The contact.
 * @return CONTACTD_OK, or one of the common errors.
 */
CONTACTD_API int32_t contactd_cancel(contactd_contact* contact);

/**
 * @brief Sets the timeout of steps, which replaces that of the connection.
 * @param contact The contact.
 * @param seconds The timeout (s), > 0 and at most 1e6.
 * @return CONTACTD_OK, one of the common errors, or one of these codes:
 * @retval CONTACTD_INVALID_ARGUMENT The time is out of bounds.
 */
CONTACTD_API int32_t contactd_set_step_timeout(contactd_contact* contact, double seconds);

/**
 * @brief Sets a table of coefficients of a body or of the pair (docs/ic-tables.md).
 * @param contact The contact.
 * @param path "bodies.upper.ics" or "bodies.lower.ics" for a body, "ics" for the pair.
 * @param nx Number of offsets along x, at least that of the grid's elements.
 * @param ny Number of offsets along y, at least that of the grid's elements.
 * @param dx Element size of the table along x (mm).
 * @param dy Element size of the table along y (mm).
 * @param values values[3][3][ny][nx] (mm^3/N): displacement axis, load axis, offsets along y and x. They are copied.
 * @param count Number of values, 9*nx*ny.
 * @return CONTACTD_OK, one of the common errors, or one of these codes:
 * @retval CONTACTD_INVALID_ARGUMENT The path, a size or the count is invalid.
 * @retval CONTACTD_FAILED_PRECONDITION The contact was started before.
 */
CONTACTD_API int32_t contactd_set_table(contactd_contact* contact, const char* path, int32_t nx, int32_t ny, double dx,
                                        double dy, const double* values, int32_t count);

/**
 * @brief Reads the frames of the columns of a body's section. May be called before contactd_start.
 * @param contact The contact.
 * @param body "upper" or "lower".
 * @param[out] y y[length] of the middles of the columns (mm).
 * @param[out] z z[length] of the middles of the columns (mm).
 * @param[out] angle angle[length] of their outward normals from +z towards +y (rad).
 * @param length Number of columns, equal to ny of the grid.
 * @pre The grid and the section of the body are set.
 * @return CONTACTD_OK, one of the common errors, or one of these codes:
 * @retval CONTACTD_INVALID_ARGUMENT An argument is invalid, the body has no section, or the section is invalid.
 */
CONTACTD_API int32_t contactd_get_frames(contactd_contact* contact, const char* body, double* y, double* z,
                                         double* angle, int32_t length);

/**
 * @brief Sets a profile from a file: Simpack (.prr, .prw), MiniProf (.ban, .whl), or two columns.
 *
 * The file is read in this call, by this process. "setup.rail.unit", ".mirror_y", ".mirror_z" and ".smoothing_length"
 * are then those of its points, and you may change them. With the path "setup.rail.file" its text is stored and
 * interpreted in the solve, according to "setup.rail.file.unit", ".mirror_y", ".mirror_z", ".shift_y", ".shift_z" and
 * ".smoothing_length"; a profile with ambiguous settings is refused. To use content without a file, set
 * "setup.rail.file.name" and "setup.rail.file.text".
 * @param handle A contact or a wheel.
 * @param path "setup.rail", "setup.wheel" or "setup.rail_slices[0].profile" for a wheel;
 *     "ics.section.profile_section.profile" for a contact.
 * @param file Name of the file.
 * @pre The kind of the profile of a contact is set.
 * @return CONTACTD_OK, one of the common errors, or one of these codes:
 * @retval CONTACTD_INVALID_ARGUMENT The path does not name a profile, or the file cannot be read or is not a profile.
 * @retval CONTACTD_FAILED_PRECONDITION The contact was started before.
 */
CONTACTD_API int32_t contactd_read_profile(contactd_handle handle, const char* path, const char* file);

/* --- steps of contacts and of wheels ----------------------------------------------------------------------------- */
/**
 * @brief Solves the last step of contactd_step or contactd_wheel_solve again with the current inputs.
 *
 * The step starts from the state before the last one. An integrator can thus repeat a step until it accepts the
 * result.
 * @param handle A contact or a wheel.
 * @return The codes of contactd_step or contactd_wheel_solve.
 */
CONTACTD_API int32_t contactd_step_again(contactd_handle handle);

/**
 * @brief Saves the state of a contact or a wheel with its results. Before the first step it is the start.
 *
 * States of a wheel are valid until its set-up changes.
 * @param handle A contact or a wheel.
 * @param[out] state Number of the state, > 0.
 * @pre The contact was started; otherwise the call returns CONTACTD_FAILED_PRECONDITION.
 * @return CONTACTD_OK, one of the common errors, or one of these codes:
 * @retval CONTACTD_NOT_FOUND The daemon has ended the session.
 * @retval CONTACTD_RESOURCE_EXHAUSTED The daemon's limit of saved states is reached.
 */
CONTACTD_API int32_t contactd_save(contactd_handle handle, int32_t* state);

/**
 * @brief Returns to a saved state, any number of times.
 * @param handle The contact or wheel of the state.
 * @param state A number from contactd_save.
 * @return CONTACTD_OK, one of the common errors, or one of these codes:
 * @retval CONTACTD_NOT_FOUND There is no such state, or the daemon has ended the session.
 */
CONTACTD_API int32_t contactd_restore(contactd_handle handle, int32_t state);

/**
 * @brief Frees a saved state.
 * @param handle The contact or wheel of the state.
 * @param state A number from contactd_save.
 * @return CONTACTD_OK, one of the common errors, or one of these codes:
 * @retval CONTACTD_NOT_FOUND There is no such state, or the daemon has ended the session.
 */
CONTACTD_API int32_t contactd_forget(contactd_handle handle, int32_t state);

/* --- wheels on rails --------------------------------------------------------------------------------------------- */
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
 * .ends (from y to y), "setup.wheel.cone.slope" and .ends, "setup.rail.standard.name" ("54E1") and .inclination, or
 * "setup.rail.points" with .smoothing_length, .unit, .mirror_y and .mirror_z. Each slice has a profile:
 * "setup.wheel_slices[0].angle", "setup.wheel_slices[0].profile.points". Bodies are elastic or rigid:
 * "setup.bodies.upper.G" and .nu, or .rigid (1), for the rail; lower for the wheel. "setup.friction.mu" may be a single
 * number. Bounds of the numbers of profiles and bodies are checked in the solve. */

/**
 * @brief Creates a wheel.
 * @param connection The connection.
 * @param[out] wheel The wheel; NULL on failure.
 * @return CONTACTD_OK, or one of the common errors.
 */
CONTACTD_API int32_t contactd_wheel_new(contactd_connection* connection, contactd_wheel** wheel);

/**
 * @brief Frees the wheel.
 * @param wheel The wheel. It is invalid after this call, unless another thread uses it.
 * @return CONTACTD_OK, one of the common errors, or one of these codes:
 * @retval CONTACTD_FAILED_PRECONDITION Another thread uses the wheel, which stays valid.
 */
CONTACTD_API int32_t contactd_wheel_free(contactd_wheel* wheel);

/**
 * @brief Solves the wheel.
 *
 * Without contact the call succeeds and there are no patches. It also succeeds if a solver missed its tolerance; the
 * result "converged" reports this. A failed solve leaves the wheel and its results unchanged.
 * @param wheel The wheel.
 * @return CONTACTD_OK, one of the common errors, or one of these codes:
 * @retval CONTACTD_INVALID_ARGUMENT An input is invalid or missing, or the set-up differs from that before a
 *     transient step.
 * @retval CONTACTD_DEADLINE_EXCEEDED The timeout has passed.
 * @retval CONTACTD_CANCELLED contactd_wheel_cancel was called.
 * @retval CONTACTD_UNAVAILABLE No daemon listens at the address, or it is stopping.
 */
CONTACTD_API int32_t contactd_wheel_solve(contactd_wheel* wheel);

/**
 * @brief Solves the wheels of a vehicle, each like contactd_wheel_solve.
 *
 * A daemon receives one message, which its workers share. Cancelling one wheel, or the shortest of the timeouts, ends
 * it for all. Answers do not depend on the number of threads or workers. A wheel that fails does not affect the
 * others, and each wheel stores its own failure. If a handle is invalid or repeated, no wheel is solved. Log
 * callbacks run in this thread after all solves.
 * @param wheels The wheels; may be NULL if `count` is 0.
 * @param count Number of wheels, at least 0.
 * @param threads Number of threads in process, including this one; 0: the number of processors.
 * @return CONTACTD_OK, or the code of the first failure: CONTACTD_INVALID_ARGUMENT for an invalid or repeated handle,
 *     or the codes of contactd_wheel_solve.
 */
CONTACTD_API int32_t contactd_wheel_solve_many(contactd_wheel* const* wheels, int32_t count, int32_t threads);

/**
 * @brief Solves both wheels of a wheelset with free roll.
 *
 * Computes the height and roll at which each wheel presses on its rail with its "state.Fz". Position, velocity and
 * pitch rate of a roller must be the same for both, except z and roll, where the values of the right wheel are the
 * start of the search. A longitudinal force and derivatives are not supported. Each wheel receives its results, which
 * have converged if both wheels and the search for the roll have. A solve starts from the end of the last one of the
 * right wheel with these set-ups, with a daemon at its height and roll. This changes the answer within the
 * tolerances. Timeout and failures are those of the right wheel; cancelling either wheel cancels both.
 * @param right The right wheel.
 * @param left The left wheel.
 * @return CONTACTD_OK, one of the common errors, or one of these codes:
 * @retval CONTACTD_INVALID_ARGUMENT An input is invalid or missing, or differs between the wheels where it must not.
 * @retval CONTACTD_DEADLINE_EXCEEDED The timeout has passed.
 * @retval CONTACTD_CANCELLED contactd_wheel_cancel was called.
 * @retval CONTACTD_UNAVAILABLE No daemon listens at the address, or it is stopping.
 */
CONTACTD_API int32_t contactd_wheel_solve_wheelset(contactd_wheel* right, contactd_wheel* left);

/**
 * @brief Cancels the running solve, which soon returns CONTACTD_CANCELLED.
 *
 * May be called from any thread. It has no effect without a running solve.
 * @param wheel The wheel.
 * @return CONTACTD_OK, or one of the common errors.
 */
CONTACTD_API int32_t contactd_wheel_cancel(contactd_wheel* wheel);

/**
 * @brief Sets the timeout of solves, which replaces that of the connection.
 * @param wheel The wheel.
 * @param seconds The timeout (s), > 0 and at most 1e6.
 * @return CONTACTD_OK, one of the common errors, or one of these codes:
 * @retval CONTACTD_INVALID_ARGUMENT The time is out of bounds.
 */
CONTACTD_API int32_t contactd_wheel_set_timeout(contactd_wheel* wheel, double seconds);

/* --- tables of creep forces -------------------------------------------------------------------------------------- */
/* Interpolates creep forces of the full theory of steady rolling over ellipses, in less than a microsecond, from a
 * file. A table covers quasi-identical elastic half-spaces, one coefficient of friction, and all creepages and spins.
 * Its file states its errors. No daemon is needed, but the library that solves in process, libcontactd-local.
 * Evaluation does not allocate memory and takes no lock, so any number of threads may use a table. */

/**
 * @brief Opens a table.
 *
 * The file is mapped into memory, and its digest is checked. It must not change while the table is open; to replace it,
 * rename another file over it.
 * @param path The file, in UTF-8.
 * @param nu Poisson's ratio of the combined material. A table of several ratios is interpolated to this one.
 * @param[out] table The table; NULL on failure.
 * @return CONTACTD_OK, one of the common errors, or one of these codes:
 * @retval CONTACTD_INVALID_ARGUMENT The table does not cover this Poisson's ratio.
 * @retval CONTACTD_NOT_FOUND The file cannot be read.
 * @retval CONTACTD_DATA_LOSS The file is damaged, or not a table.
 * @retval CONTACTD_FAILED_PRECONDITION A newer version of contactd wrote the file.
 * @retval CONTACTD_UNIMPLEMENTED This library cannot solve in process.
 */
CONTACTD_API int32_t contactd_creep_table_open(const char* path, double nu, contactd_creep_table** table);

/**
 * @brief Closes a table.
 * @param table The table, which no other thread may be using. It is invalid after this call.
 * @return CONTACTD_OK, or one of the common errors.
 */
CONTACTD_API int32_t contactd_creep_table_close(contactd_creep_table* table);

/**
 * @brief Returns the range and the description of a table.
 * @param table The table.
 * @param[out] nu Poisson's ratio.
 * @param[out] ratios Two numbers: the smallest and the largest a/b.
 * @param[out] text The description in the file, JSON: versions, recipe, seed, points, and the statement about errors;
 *     truncated to fit. May be NULL if `size` is 0.
 * @param size Bytes of `text`, with the terminating zero; at least 0.
 * @return CONTACTD_OK, one of the common errors, or one of these codes:
 * @retval CONTACTD_INVALID_ARGUMENT `size` is negative.
 */
CONTACTD_API int32_t contactd_creep_table_info(contactd_creep_table* table, double* nu, double* ratios, char* text,
                                               int32_t size);

/**
 * @brief Returns the forces on the upper body in steady rolling along +x, with the signs of contacts.
 * @param table The table.
 * @param a Semi-axis of the contact along x (mm).
 * @param b Semi-axis along y (mm).
 * @param G Shear modulus of the combined material (N/mm^2).
 * @param mu Coefficient of friction.
 * @param Fn Normal force (N).
 * @param creepages Three numbers: xi, eta, and the spin phi (1/mm).
 * @param[out] forces Three numbers: Fx, Fy (N), Mz (N mm).
 * @param[out] jacobian Nine numbers: derivatives of Fx by xi, eta, phi, then of Fy, then of Mz. May be NULL.
 * @param[out] bounds Two numbers: bounds of the errors of Fx and Fy (N) and of Mz (N mm), NaN if the file states none.
 *     May be NULL.
 * @return CONTACTD_OK, one of the common errors, or one of these codes:
 * @retval CONTACTD_INVALID_ARGUMENT A number of the contact is not positive, the table does not cover a/b, or a
 *     creepage is not finite.
 */
CONTACTD_API int32_t contactd_creep_table_forces(contactd_creep_table* table, double a, double b, double G, double mu,
                                                 double Fn, const double* creepages, double* forces, double* jacobian,
                                                 double* bounds);

/**
 * @brief Returns the forces of several contacts, each like contactd_creep_table_forces.
 *
 * The first invalid contact ends the call. The results of those before it are valid.
 * @param table The table.
 * @param count Number of contacts, at least 0. If it is 0, the other pointers may be NULL.
 * @param contacts For each contact a, b, G, mu and Fn.
 * @param creepages For each contact xi, eta and phi.
 * @param[out] forces For each contact Fx, Fy and Mz.
 * @param[out] jacobians For each contact nine derivatives. May be NULL.
 * @param[out] bounds For each contact two bounds. May be NULL.
 * @return CONTACTD_OK, one of the common errors, or one of these codes:
 * @retval CONTACTD_INVALID_ARGUMENT A number is invalid; contactd_last_field names its row: "contacts[3].Fn".
 */
CONTACTD_API int32_t contactd_creep_table_many(contactd_creep_table* table, int32_t count, const double* contacts,
                                               const double* creepages, double* forces, double* jacobians,
                                               double* bounds);

#ifdef __cplusplus
}
#endif

/* Overloads that refuse other pointers in C++. */
#if defined(__cplusplus) && (__cplusplus >= 201103L || defined(_MSC_VER)) && !defined(CONTACTD_UNTYPED_HANDLES)
extern "C++" {
template <class Other>
struct contactd_not_a_handle {
    typedef int32_t type;
};
template <class Other>
struct contactd_not_a_handle<const Other> : contactd_not_a_handle<Other> {};
template <>
struct contactd_not_a_handle<void> {};
template <>
struct contactd_not_a_handle<contactd_contact> {};
template <>
struct contactd_not_a_handle<contactd_wheel> {};
template <class Other>
struct contactd_not_any_handle : contactd_not_a_handle<Other> {};
template <>
struct contactd_not_any_handle<contactd_connection> {};
template <>
struct contactd_not_any_handle<const contactd_connection> {};
template <>
struct contactd_not_any_handle<contactd_creep_table> {};
template <>
struct contactd_not_any_handle<const contactd_creep_table> {};
#define CONTACTD_REFUSE(function, others)      \
    template <class Other, class... Arguments> \
    typename others<Other>::type function(Other*, Arguments...) = delete;
CONTACTD_REFUSE(contactd_last_code, contactd_not_any_handle)
CONTACTD_REFUSE(contactd_last_error, contactd_not_any_handle)
CONTACTD_REFUSE(contactd_last_field, contactd_not_any_handle)
CONTACTD_REFUSE(contactd_last_reason, contactd_not_any_handle)
CONTACTD_REFUSE(contactd_set, contactd_not_a_handle)
CONTACTD_REFUSE(contactd_set_word, contactd_not_a_handle)
CONTACTD_REFUSE(contactd_set_array, contactd_not_a_handle)
CONTACTD_REFUSE(contactd_clear, contactd_not_a_handle)
CONTACTD_REFUSE(contactd_get, contactd_not_a_handle)
CONTACTD_REFUSE(contactd_get_word, contactd_not_a_handle)
CONTACTD_REFUSE(contactd_get_array, contactd_not_a_handle)
CONTACTD_REFUSE(contactd_length, contactd_not_a_handle)
CONTACTD_REFUSE(contactd_want, contactd_not_a_handle)
CONTACTD_REFUSE(contactd_path, contactd_not_a_handle)
CONTACTD_REFUSE(contactd_set_at, contactd_not_a_handle)
CONTACTD_REFUSE(contactd_get_at, contactd_not_a_handle)
CONTACTD_REFUSE(contactd_read_profile, contactd_not_a_handle)
CONTACTD_REFUSE(contactd_step_again, contactd_not_a_handle)
CONTACTD_REFUSE(contactd_save, contactd_not_a_handle)
CONTACTD_REFUSE(contactd_restore, contactd_not_a_handle)
CONTACTD_REFUSE(contactd_forget, contactd_not_a_handle)
#undef CONTACTD_REFUSE
}
#endif

#endif
