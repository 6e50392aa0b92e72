/*
 * contactd: elastic contact from C, and from all that can call C. docs/c.md has examples and the rules in full.
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
 * Every function answers a code, 0 when it did what it is for; contactd_last_error has the sentence. No pointer may be
 * NULL unless it says so. A contact or a wheel is used by one thread at a time, a connection by any number.
 *
 * Units are the caller's, consistently; N and mm stand for them here. Signs: docs/contact.md. Arrays over the grid have
 * nx*ny values, x running fastest: element (ix, iy) is at iy*nx + ix.
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
    CONTACTD_CANCELLED = 1, /* contactd_cancel, or the daemon's job was cancelled */
    CONTACTD_UNKNOWN = 2,
    CONTACTD_INVALID_ARGUMENT = 3,  /* contactd_last_field says which; also a handle that is none */
    CONTACTD_DEADLINE_EXCEEDED = 4, /* the timeout */
    CONTACTD_NOT_FOUND = 5,         /* no such session any more, no such state, nothing of that to read */
    CONTACTD_ALREADY_EXISTS = 6,
    CONTACTD_PERMISSION_DENIED = 7,
    CONTACTD_RESOURCE_EXHAUSTED = 8,  /* memory, or a limit of the daemon */
    CONTACTD_FAILED_PRECONDITION = 9, /* not now: wrong order, or used by another thread (CONCURRENT_USE) */
    CONTACTD_ABORTED = 10,            /* the step did not converge, and the contact stays where it was */
    CONTACTD_OUT_OF_RANGE = 11,
    CONTACTD_UNIMPLEMENTED = 12, /* not in this library */
    CONTACTD_INTERNAL = 13,
    CONTACTD_UNAVAILABLE = 14, /* nobody listens there */
    CONTACTD_DATA_LOSS = 15,
    CONTACTD_UNAUTHENTICATED = 16
};

/* --- enumerators --------------------------------------------------------------------------------------------- */
enum { CONTACTD_EXTERIOR = 0, CONTACTD_ADHESION = 1, CONTACTD_SLIP = 2, CONTACTD_FLOW = 3 }; /* state of an element */
enum { CONTACTD_LOG_DEBUG = 0, CONTACTD_LOG_INFO = 1, CONTACTD_LOG_WARNING = 2, CONTACTD_LOG_ERROR = 3 };

typedef struct contactd_connection contactd_connection; /* where contacts are solved */
typedef struct contactd_contact contactd_contact;       /* one contact, step by step */
typedef struct contactd_wheel contactd_wheel;           /* one wheel on its rail */
/* Called in the thread of the call that it tells of, which it must let return; `text` holds until then. */
typedef void (*contactd_log)(void* user, int32_t level, const char* text);

/* --- the library --------------------------------------------------------------------------------------------- */
CONTACTD_API const char* contactd_version(void);           /* "0.1.0" */
CONTACTD_API int32_t contactd_version_number(void);        /* 10000 major + 100 minor + patch */
CONTACTD_API int32_t contactd_has_local(void);             /* 1 when contactd_open takes "local", else 0 */
CONTACTD_API const char* contactd_code_name(int32_t code); /* "INVALID_ARGUMENT"; "UNKNOWN" where there is none */

/* The last call with this connection, contact or wheel that failed: in this thread or, when none did, in any. With
 * NULL, or a handle that is none, the last one in this thread. Texts hold until the same function is called again in
 * this thread; "" and CONTACTD_OK where nothing failed. */
CONTACTD_API int32_t contactd_last_code(const void* handle);
CONTACTD_API const char* contactd_last_error(const void* handle);  /* a sentence, or more */
CONTACTD_API const char* contactd_last_field(const void* handle);  /* "gap.paraboloid.Rx", as on the wire, or "" */
CONTACTD_API const char* contactd_last_reason(const void* handle); /* "FIELD_INVALID", for programs, or "" */

/* --- fields by their paths ----------------------------------------------------------------------------------- */
/* A field is named as on the wire (docs/protocol.md has all, with units, bounds and defaults; contactd/paths.h has them
 * as constants): inputs of a contact as "grid.dx" or "friction.rolling.xi", of a wheel as "setup.track.springs.z" or
 * "state.position.yaw", results as "forces.Fn" or "patches[0].place.creepages.xi". `handle` is a contact or a wheel.
 * What is out of its bounds is refused at once, by path, value, and what would be right; a path that does not exist
 * with the names that do. A path is read once for each handle, so that it may be used in a loop.
 *
 * Numbers, flags (0 or 1) and whole numbers; a field that may be left out is there from then on, and a list gets its
 * next entry where that is named. */
CONTACTD_API int32_t contactd_set(void* handle, const char* path, double value);
/* One of the keywords that the field has, such as "model" "hertz". */
CONTACTD_API int32_t contactd_set_word(void* handle, const char* path, const char* keyword);
/* All numbers of an object in the order of its fields, as "state.velocity"; of a list, entry by entry: as many as there
 * are, "setup.friction.mu" an angle and a coefficient each, "setup.rail.points" y and z; or of an array over the grid,
 * as "gap.array" or "friction.mu". */
CONTACTD_API int32_t contactd_set_array(void* handle, const char* path, const double* values, int32_t count);
/* Leaves a field out again that may be: "friction": without friction; "state.Fz": z is prescribed; a list. */
CONTACTD_API int32_t contactd_clear(void* handle, const char* path);
/* Reads the last solve or step; a list gives its length. CONTACTD_NOT_FOUND: the solution does not have it. */
CONTACTD_API int32_t contactd_get(void* handle, const char* path, double* value);
/* `text`, of `length` bytes with its end, into which what is longer is cut. */
CONTACTD_API int32_t contactd_get_word(void* handle, const char* path, char* text, int32_t length);
/* All numbers of an object or a list, as contactd_set_array; or of an array over the grid that contactd_want asked for,
 * as "patches[0].solution.pressure": element_division has CONTACTD_EXTERIOR, _ADHESION, _SLIP and _FLOW, slip is all
 * zero without friction. `count` must be that of contactd_length. */
CONTACTD_API int32_t contactd_get_array(void* handle, const char* path, double* values, int32_t count);
CONTACTD_API int32_t contactd_length(void* handle, const char* path, int32_t* count);
/* Whether solves or steps from now on bring along an array over the grid (1), or not (0, as at first): "pressure",
 * "traction_x", "traction_y", "slip_x", "slip_y", "element_division"; "displacement_x", "displacement_y" and
 * "displacement_z" where "displacements" is set; "flow_x", "flow_y" and "yield_stress" where a layer yields,
 * "friction_coefficient" where it falls; "upper_temperature" and "lower_temperature" where "temperature" is set; of
 * wheels also "gap", the undeformed distances, which the model full has. */
CONTACTD_API int32_t contactd_want(void* handle, const char* array, int32_t requested);

/* For loops in which a text costs too much: *id stands for the path of an input, of a result, or of both, with this
 * handle and as long as it lives. */
CONTACTD_API int32_t contactd_path(void* handle, const char* path, int32_t* id);
CONTACTD_API int32_t contactd_set_at(void* handle, int32_t id, double value);
CONTACTD_API int32_t contactd_get_at(void* handle, int32_t id, double* value);

/* --- connections --------------------------------------------------------------------------------------------- */
/* `where`: a daemon, "ipc:///path" or "tcp://host:port", or "local", in process (libcontactd-local only). Nothing is
 * sent yet. Sets *connection to NULL when it fails. */
CONTACTD_API int32_t contactd_open(const char* where, contactd_connection** connection);
/* Its contacts stay; none can be made any more. */
CONTACTD_API int32_t contactd_close(contactd_connection* connection);
/* Whether contacts can be solved there now. */
CONTACTD_API int32_t contactd_ping(contactd_connection* connection);

/* What follows holds for contacts made later. Seconds, > 0: of a call (60), of contactd_start and wheels where they may
 * wait for finite elements (3600), for somebody to listen (5). */
CONTACTD_API int32_t contactd_set_timeout(contactd_connection* connection, double seconds);
CONTACTD_API int32_t contactd_set_build_timeout(contactd_connection* connection, double seconds);
CONTACTD_API int32_t contactd_set_connect_timeout(contactd_connection* connection, double seconds);
/* Files of CURVE keys (docs/security.md): the daemon's public one, and one's own secret one. */
CONTACTD_API int32_t contactd_set_keys(contactd_connection* connection, const char* server_key, const char* own_key);
/* `log` may be NULL: nothing is told. While it was not called, what answers warn of goes to standard error, each
 * sentence once for each contact or wheel, and nothing else is told. */
CONTACTD_API int32_t contactd_set_log(contactd_connection* connection, contactd_log log, void* user);

/* --- contacts ------------------------------------------------------------------------------------------------ */
/* Inputs are those of contact.solve (docs/contact.md), and "lease_seconds" and "accept_unconverged" of a session. What
 * describes the set-up stays from contactd_start on: "grid", "bodies", "ics", "model", "columns", "settings",
 * "previous". The load can be set at any time and holds until it is set anew: "gap", "approach" or "Fn" (the later one
 * counts), "friction", and "derivatives", whether steps have those.
 *
 * A grid is centred along an axis whose "grid.x0" or "grid.y0" is left out. The lower body is as the upper one unless a
 * field of it is set; "ics" is that of bodies without their own. Naming a field of a shape makes the gap
 * ("gap.semi_axes.a"), the section of a body ("ics.section.rail_60e1.support") or a part of its outline
 * ("parts[0].line.to") one of that; a radius that is infinite is left out. Coefficients are those of half-spaces in
 * closed form; by finite elements they have an accuracy of 1e-3, and "ics.accuracy" is cleared where mesh and solver
 * are set instead. Numbers of bodies have no bounds before contactd_start.
 *
 * Without "friction.mu" there is no friction. The motion is a shift or rolling, whichever is named first: the other
 * kind is refused until contactd_clear of "friction.rigid_shift" or "friction.rolling". Where "friction.force.Fx" or
 * "friction.rolling.force.Fx" prescribes a force, the shift or the creepage is an estimate of what is found.
 *
 * Results are those of session.step, with "step", the number of the last one, and "ics.upper.origin", where the
 * coefficients came from. */
/* Sets *contact to NULL when it fails. */
CONTACTD_API int32_t contactd_new(contactd_connection* connection, contactd_contact** contact);
/* Ends it. The handle is none afterwards whatever the answer, unless another thread uses it (CONCURRENT_USE). */
CONTACTD_API int32_t contactd_free(contactd_contact* contact);
/* Opens it with all that was set; waits for its coefficients. */
CONTACTD_API int32_t contactd_start(contactd_contact* contact);
/* Solves the next step, which starts where the last one ended. One that fails leaves the contact as it was. */
CONTACTD_API int32_t contactd_step(contactd_contact* contact);
/* From any thread: the call that runs ends with CONTACTD_CANCELLED soon. Does nothing when none runs. */
CONTACTD_API int32_t contactd_cancel(contactd_contact* contact);
/* Replaces the connection's timeout for steps (s). */
CONTACTD_API int32_t contactd_set_step_timeout(contactd_contact* contact, double seconds);
/* Coefficients that are given: of a body ("bodies.upper.ics", "bodies.lower.ics"), or of the pair ("ics").
 * values[3][3][ny][nx]: displacement axis, load axis, offsets along y and x; mm^3/N; count = 9*nx*ny. dx, dy: the size
 * of the elements that they are for (mm). docs/ic-tables.md. */
CONTACTD_API int32_t contactd_set_table(contactd_contact* contact, const char* path, int32_t nx, int32_t ny, double dx,
                                        double dy, const double* values, int32_t count);
/* Frames of the columns of a body's section, "upper" or "lower", also before contactd_start: y[length] and z[length] of
 * their middles (mm), angle[length] of their outward normals from +z towards +y (rad), length = ny. */
CONTACTD_API int32_t contactd_get_frames(contactd_contact* contact, const char* body, double* y, double* z,
                                         double* angle, int32_t length);
/* Makes the profile that `path` names that of a file: Simpack (.prr, .prw), MiniProf (.ban, .whl), or two columns. Of a
 * wheel "setup.rail" or "setup.rail_slices[0].profile", of a contact "ics.section.profile_section.profile", whose kind
 * is set before. It is read now, and here: "setup.rail.unit", ".mirror_y", ".mirror_z" and ".smoothing_length" are then
 * those of its points, and may be set otherwise. With the path "setup.rail.file" its text is taken as it is, and read
 * when it is solved, as "setup.rail.file.unit", ".mirror_y", ".mirror_z", ".shift_y", ".shift_z" and
 * ".smoothing_length" say; what neither file nor points say is refused. Whoever has the content, and no file, sets
 * "setup.rail.file.name" and "setup.rail.file.text". */
CONTACTD_API int32_t contactd_read_profile(void* handle, const char* path, const char* file);

/* --- steps of contacts and of wheels ------------------------------------------------------------------------- */
/* Solves the step that contactd_step or contactd_wheel_solve asked for last anew, with what is set now: it is taken
 * back first where it was solved. So an integrator tries a step until it is content. */
CONTACTD_API int32_t contactd_step_again(void* handle);
/* Where a contact or a wheel is, its results with it; *state is the name of it, > 0. Before the first step it is the
 * start. States of a wheel last as long as its set-up stays. */
CONTACTD_API int32_t contactd_save(void* handle, int32_t* state);
CONTACTD_API int32_t contactd_restore(void* handle, int32_t state); /* as often as wanted */
CONTACTD_API int32_t contactd_forget(void* handle, int32_t state);

/* --- wheels on rails ----------------------------------------------------------------------------------------- */
/* From profiles and the position of a wheelset to patches and forces (docs/wheel-rail.md has coordinates and signs).
 * All that is set and read is named by its path:
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
 * There is nothing to start: a wheel that was made is a right one, S1002 on 60E1 at 1/40, gauge 1435, of steel, with
 * mu = 0.3 and elements of 0.2 mm, and all of it can be set at any time. What is set holds until it is set anew. A
 * wheel whose set-up stays keeps its profiles and operators, with a daemon in a session of its own, and a solve starts
 * where the one before ended. Of "state.motion" steady_rolling that is an estimate: the answer is that of a fresh wheel
 * within the tolerances; contactd_step_again in its place always starts anew, and has the same answers to the last bit
 * whatever was solved before. Transient steps go on from the tractions of the solve before, also a steady one. Lengths
 * are in mm, angles in rad, forces in N on the rail.
 *
 * Profiles are those of a right side, of left wheels, too: y to the field side, z down. Naming a field of a shape makes
 * the profile one: "setup.wheel.s1002" (1), "setup.rail.rail_60e1.inclination", "setup.rail.arc.radius", .slope and
 * .ends (from y to y), "setup.wheel.cone.slope" and .ends, "setup.rail.points" and beside them .smoothing_length,
 * .unit, .mirror_y and .mirror_z. Slices have one each: "setup.wheel_slices[0].angle",
 * "setup.wheel_slices[0].profile.points". Bodies are elastic or rigid: "setup.bodies.upper.G" and .nu, or .rigid (1),
 * of the rail; lower of the wheel. One number is enough for "setup.friction.mu". Numbers of profiles and bodies have no
 * bounds before the wheel is solved. */
/* Sets *wheel to NULL when it fails. */
CONTACTD_API int32_t contactd_wheel_new(contactd_connection* connection, contactd_wheel** wheel);
/* The handle is none afterwards, unless another thread uses it (CONCURRENT_USE). */
CONTACTD_API int32_t contactd_wheel_free(contactd_wheel* wheel);
/* No contact is an answer: no patches. So is what has not converged: the result "converged". A solve that fails leaves
 * the wheel as it was, with the results of the one before. */
CONTACTD_API int32_t contactd_wheel_solve(contactd_wheel* wheel);
/* The wheels of a vehicle, each of which is solved as contactd_wheel_solve does. In process on so many threads: this
 * one and others, which end with the call; 0 stands for as many as there are processors. A daemon gets one message,
 * which its workers share; it ends for all when one is cancelled, and at the shortest of their timeouts. Answers depend
 * on none of that. A wheel that fails does not keep the others from being solved: the code is that of the first one,
 * and each wheel has its own failure. Nothing is solved where one is none or stands twice (INVALID_ARGUMENT). Logs are
 * called from this thread, when all have been solved. */
CONTACTD_API int32_t contactd_wheel_solve_many(contactd_wheel* const* wheels, int32_t count, int32_t threads);
/* Both wheels of a wheelset that is free to roll, at the height and the roll at which each presses on its rail by its
 * "state.Fz". Position, velocity and pitch rate of a roller are the same for both, but z and roll, where the right
 * wheel's tell where to start; no longitudinal force and no derivatives. Each wheel then has its results, which
 * converged when both wheels and the search for the roll did. A solve starts where the last one of the right wheel with
 * these set-ups ended, with a daemon at its height and roll, which changes the answer within the tolerances. The
 * timeout and the failures are those of the right wheel; either is cancelled for both. */
CONTACTD_API int32_t contactd_wheel_solve_wheelset(contactd_wheel* right, contactd_wheel* left);
/* From any thread: the solve that runs ends with CONTACTD_CANCELLED soon. Does nothing when none runs. */
CONTACTD_API int32_t contactd_wheel_cancel(contactd_wheel* wheel);
/* Replaces the connection's timeout for solves (s). */
CONTACTD_API int32_t contactd_wheel_set_timeout(contactd_wheel* wheel, double seconds);

#ifdef __cplusplus
}
#endif

#endif
