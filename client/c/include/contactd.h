/*
 * contactd: elastic contact from C, and from all that can call C. docs/c.md has examples and the rules in full.
 *
 *     contactd_connection *connection;
 *     contactd_contact *contact;
 *     contactd_open("ipc:///run/contactd.sock", &connection);
 *     contactd_new(connection, &contact);
 *     ... contactd_set_grid_centred(contact, 25, 25, 0.6, 0.6); ...
 *     contactd_start(contact);
 *     while (...) {
 *         contactd_set_Fn(contact, 50e3);
 *         contactd_step(contact);
 *         contactd_get_forces(contact, &Fn, &Fx, &Fy, &Mz);
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

#if defined(__GNUC__)
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

/* --- words --------------------------------------------------------------------------------------------------- */
enum { CONTACTD_UPPER = 0, CONTACTD_LOWER = 1, CONTACTD_BOTH = 2, CONTACTD_PAIR = 3 };
enum { CONTACTD_FULL = 0, CONTACTD_HERTZ = 1, CONTACTD_FASTSIM = 2 };
enum { CONTACTD_CONSTANT = 0, CONTACTD_BILINEAR = 1 }; /* load_shape of coefficients */
enum { CONTACTD_HALF_SPACE = 0, CONTACTD_BLOCK = 1 };  /* shape of a body by finite elements */
enum { CONTACTD_CUT = 0, CONTACTD_FOOT = 1 };          /* what holds a rail */
/* Ready-made cross-sections. */
enum {
    CONTACTD_RAIL_60E1 = 1,
    CONTACTD_RIM_S1002 = 2,
    CONTACTD_EDGE_BLOCK = 3,
    CONTACTD_GROOVE = 4,
    CONTACTD_ROUND_END = 5,
    CONTACTD_DISC = 6,
    CONTACTD_PLATE_HOLE = 7,
    CONTACTD_SLAB = 8
};
enum { CONTACTD_STEADY = 0, CONTACTD_TRANSIENT = 1 };   /* kind of rolling */
enum { CONTACTD_LINEAR = 0, CONTACTD_EXPONENTIAL = 1 }; /* law of kinetic friction */
enum { CONTACTD_NORMAL = 0, CONTACTD_TANGENTIAL = 1, CONTACTD_OUTER = 2, CONTACTD_FORCE = 3 }; /* solvers */
enum { CONTACTD_EXTERIOR = 0, CONTACTD_ADHESION = 1, CONTACTD_SLIP = 2 };                      /* of an element */
/* Arrays. */
enum {
    CONTACTD_DIVISION = 0, /* into words of an element */
    CONTACTD_PRESSURE = 1,
    CONTACTD_TRACTION_X = 2,
    CONTACTD_TRACTION_Y = 3,
    CONTACTD_SLIP_X = 4,
    CONTACTD_SLIP_Y = 5
};

/* Derivatives: of an answer, by an input. Along x and y stand xi and eta of rolling, or the shift; turn is phi, or the
 * rotation; load is the approach or Fn, whichever is prescribed. */
enum { CONTACTD_OF_FX = 0, CONTACTD_OF_FY = 1, CONTACTD_OF_MZ = 2, CONTACTD_OF_FN = 3, CONTACTD_OF_APPROACH = 4 };
enum { CONTACTD_BY_X = 0, CONTACTD_BY_Y = 1, CONTACTD_BY_TURN = 2, CONTACTD_BY_LOAD = 3, CONTACTD_BY_MU = 4 };

/* Wheels on rails: sides in the direction of travel, bodies, coordinates of forces, a solver more, an array more. */
enum { CONTACTD_LEFT = 0, CONTACTD_RIGHT = 1 };
enum { CONTACTD_WHEEL = 0, CONTACTD_RAIL = 1 };
enum { CONTACTD_IN_TRACK = 0, CONTACTD_IN_RAIL = 1, CONTACTD_IN_WHEELSET = 2 };
/* The searches for a pitch rate, for the roll of a wheelset, and for where a rail on springs is. */
enum { CONTACTD_PITCH = 4, CONTACTD_ROLL = 5, CONTACTD_RAIL_SHIFT = 6 };
enum { CONTACTD_GAP = 6 }; /* undeformed distances */
/* Inputs of their derivatives: parts of the position, and of the velocity. */
enum {
    CONTACTD_BY_POSITION_Y = 0,
    CONTACTD_BY_POSITION_Z = 1,
    CONTACTD_BY_POSITION_ROLL = 2,
    CONTACTD_BY_POSITION_YAW = 3,
    CONTACTD_BY_VELOCITY_X = 4,
    CONTACTD_BY_VELOCITY_Y = 5,
    CONTACTD_BY_VELOCITY_Z = 6,
    CONTACTD_BY_VELOCITY_ROLL = 7,
    CONTACTD_BY_VELOCITY_YAW = 8,
    CONTACTD_BY_VELOCITY_PITCH = 9
};

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
/* A field is named as on the wire (docs/protocol.md has all, with units, bounds and defaults): inputs of a wheel as
 * "setup.track.springs.z" or "state.position.yaw", results of a contact or a wheel as "forces.Fn" or
 * "patches[0].place.creepages.xi". `handle` is a contact or a wheel. What is out of its bounds is refused at once, by
 * path, value, and what would be right; a path that does not exist with the names that do. A path is read once for each
 * handle, so that it may be used in a loop.
 *
 * Numbers, flags (0 or 1) and whole numbers; a field that may be left out is there from then on. Inputs of contacts
 * have functions of their own (CONTACTD_UNIMPLEMENTED). */
CONTACTD_API int32_t contactd_set(void* handle, const char* path, double value);
/* One of the words that the field has, such as "setup.model" "hertz". */
CONTACTD_API int32_t contactd_set_word(void* handle, const char* path, const char* word);
/* Leaves a field out again that may be: "setup.friction": without friction; "state.Fz": z is prescribed. */
CONTACTD_API int32_t contactd_clear(void* handle, const char* path);
/* Reads the last solve or step; a list gives its length. CONTACTD_NOT_FOUND: the solution does not have it. */
CONTACTD_API int32_t contactd_get(void* handle, const char* path, double* value);
/* `text`, of `length` bytes with its end. */
CONTACTD_API int32_t contactd_get_word(void* handle, const char* path, char* text, int32_t length);

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
/* Sets *contact to NULL when it fails. */
CONTACTD_API int32_t contactd_new(contactd_connection* connection, contactd_contact** contact);
/* Ends it. The handle is none afterwards whatever the answer, unless another thread uses it (CONCURRENT_USE). */
CONTACTD_API int32_t contactd_free(contactd_contact* contact);
/* Opens it with all that was set; waits for its coefficients. */
CONTACTD_API int32_t contactd_start(contactd_contact* contact);
/* Solves the next step, which starts where the last one ended. One that fails leaves the contact as it was. */
CONTACTD_API int32_t contactd_step(contactd_contact* contact);
/* Solves the step that contactd_step asked for last anew, with what is set now: it is taken back first where it was
 * solved. So an integrator tries a step until it is content. */
CONTACTD_API int32_t contactd_step_again(contactd_contact* contact);
/* From any thread: the call that runs ends with CONTACTD_CANCELLED soon. Does nothing when none runs. */
CONTACTD_API int32_t contactd_cancel(contactd_contact* contact);
/* Where the contact is, its results with it; *state is the name of it, > 0. */
CONTACTD_API int32_t contactd_save(contactd_contact* contact, int32_t* state);
CONTACTD_API int32_t contactd_restore(contactd_contact* contact, int32_t state); /* as often as wanted */
CONTACTD_API int32_t contactd_forget(contactd_contact* contact, int32_t state);

/* --- the set-up, before contactd_start ----------------------------------------------------------------------- */
/* Elements, their size, and the corner of element (0, 0) (mm); centred: the middle is the origin. */
CONTACTD_API int32_t contactd_set_grid(contactd_contact* contact, int32_t nx, int32_t ny, double dx, double dy,
                                       double x0, double y0);
CONTACTD_API int32_t contactd_set_grid_centred(contactd_contact* contact, int32_t nx, int32_t ny, double dx, double dy);
/* `body`: CONTACTD_UPPER, _LOWER or _BOTH. G (N/mm^2) and Poisson's ratio. */
CONTACTD_API int32_t contactd_set_material(contactd_contact* contact, int32_t body, double G, double nu);
CONTACTD_API int32_t contactd_set_rigid(contactd_contact* contact, int32_t body);
/* Influence coefficients in closed form (with CONTACTD_CONSTANT the default), by finite elements, or given. */
CONTACTD_API int32_t contactd_set_half_space(contactd_contact* contact, int32_t body, int32_t load_shape);
/* A half-space or a block [-L,L]^2 x [-L,0] clamped on all faces but its top. `accuracy`: the largest relative error,
 * 1e-4 to 0.1. L_over_h: L over the size of an element, of a block only; 0: 640. */
CONTACTD_API int32_t contactd_set_fem(contactd_contact* contact, int32_t body, int32_t shape, int32_t load_shape,
                                      double accuracy, double L_over_h);
/* Of a body, or with CONTACTD_PAIR of both. values[3][3][ny][nx]: displacement axis, load axis, offsets along y and x;
 * mm^3/N; count = 9*nx*ny. dx, dy: the size of the elements that they are for (mm). docs/ic-tables.md. */
CONTACTD_API int32_t contactd_set_table(contactd_contact* contact, int32_t body, int32_t nx, int32_t ny, double dx,
                                        double dy, const double* values, int32_t count);
/* Of half-spaces on a grid with ny = 1: plane strain, displacements vanish at `datum` (mm). Of models full and hertz.
 */
CONTACTD_API int32_t contactd_set_line_contact(contactd_contact* contact, double datum);
/* Layers bonded to each other, from the surface down: thickness[count] (mm), G[count] (N/mm^2), nu[count], on a
 * half-space of base_G and base_nu; base_G = 0: on a rigid base. They are the body's material, too. docs/layers.md. */
CONTACTD_API int32_t contactd_set_layers(contactd_contact* contact, int32_t body, int32_t load_shape,
                                         const double* thickness, const double* G, const double* nu, int32_t count,
                                         double base_G, double base_nu);
/* Bodies that are uniform along x, by their cross-section (docs/sections.md): rows of the grid are columns of its
 * surface, dy wide along the outline. y to the right, z up. Their coefficients are by finite elements, of an accuracy
 * of 1e-3 until another one is said; their material stays. Ready-made ones, numbers[count] in this order (mm):
 *     CONTACTD_RAIL_60E1   inclination (a slope), CONTACTD_CUT or _FOOT, from
 *     CONTACTD_RIM_S1002   thickness, from
 *     CONTACTD_EDGE_BLOCK  width, height, edge_distance
 *     CONTACTD_GROOVE      radius, depth, width, height
 *     CONTACTD_ROUND_END   radius, length
 *     CONTACTD_DISC        radius, core
 *     CONTACTD_PLATE_HOLE  radius, plate_radius
 *     CONTACTD_SLAB        thickness, width */
CONTACTD_API int32_t contactd_set_section(contactd_contact* contact, int32_t body, int32_t shape, const double* numbers,
                                          int32_t count);
/* What lies below the profile of a CONTACTD_RAIL, or above that of a CONTACTD_WHEEL, to a level cut at `depth` from its
 * origin; the first column begins at `from`, along the outline from y = 0. Points and files as of
 * contactd_wheel_set_points, _file: z of a profile is down. */
CONTACTD_API int32_t contactd_set_profile_points(contactd_contact* contact, int32_t body, int32_t kind, const double* y,
                                                 const double* z, int32_t count, double smoothing_length, double depth,
                                                 double from);
CONTACTD_API int32_t contactd_set_profile_file(contactd_contact* contact, int32_t body, int32_t kind, const char* path,
                                               double smoothing_length, double depth, double from);
/* An outline of one's own begins here, and is travelled with the body on its right; each part begins where the one
 * before ended, and the last one ends at the beginning. held: 1, nothing moves along it. radius > 0: convex, < 0:
 * hollow. Parts that are added behind contactd_add_hole are the hole's. */
CONTACTD_API int32_t contactd_set_outline(contactd_contact* contact, int32_t body, double y, double z);
CONTACTD_API int32_t contactd_add_line(contactd_contact* contact, int32_t body, double y, double z, int32_t held);
CONTACTD_API int32_t contactd_add_arc(contactd_contact* contact, int32_t body, double y, double z, double radius,
                                      int32_t held);
CONTACTD_API int32_t contactd_add_spline(contactd_contact* contact, int32_t body, const double* y, const double* z,
                                         int32_t count, int32_t held);
CONTACTD_API int32_t contactd_add_hole(contactd_contact* contact, int32_t body, double y, double z);
/* Where the columns begin: `from` along the curve from the beginning of its part `part`, both from 0. carrier 0 is the
 * outside, i the hole i. */
CONTACTD_API int32_t contactd_set_first_column(contactd_contact* contact, int32_t body, int32_t carrier, int32_t part,
                                               double from);
/* Of a section that was said: all its lengths times `size`, turned about the origin (rad); and the largest error, 1e-4
 * to 0.1, or 0: without finite elements, by half-spaces that turn from column to column. */
CONTACTD_API int32_t contactd_set_section_place(contactd_contact* contact, int32_t body, double size, double turn);
CONTACTD_API int32_t contactd_set_section_accuracy(contactd_contact* contact, int32_t body, double accuracy);
/* Contact on curved columns, those of the lower body: y[count] and z[count] of their middles (mm), angle[count] of
 * their outward normals from +z towards +y (rad), count = ny; the direction that the upper body comes from, as an
 * angle; the point that spin, shifts and moments are about. */
CONTACTD_API int32_t contactd_set_columns(contactd_contact* contact, const double* y, const double* z,
                                          const double* angle, int32_t count, double direction, double origin_y,
                                          double origin_z);
/* Where the columns of a body's section lie, also before contactd_start: length = ny. `body`: CONTACTD_UPPER, _LOWER.
 */
CONTACTD_API int32_t contactd_get_frames(contactd_contact* contact, int32_t body, double* y, double* z, double* angle,
                                         int32_t length);
CONTACTD_API int32_t contactd_set_model(contactd_contact* contact, int32_t model);
/* `solver`: CONTACTD_NORMAL, _TANGENTIAL or _OUTER. */
CONTACTD_API int32_t contactd_set_tolerance(contactd_contact* contact, int32_t solver, double tolerance,
                                            int32_t max_iterations);
/* 1: a step that missed a tolerance counts, and says so; 0, as at first: it fails with CONTACTD_ABORTED. */
CONTACTD_API int32_t contactd_set_accept_unconverged(contactd_contact* contact, int32_t accept);
/* Tractions (N/mm^2) that the first step starts from. */
CONTACTD_API int32_t contactd_set_previous(contactd_contact* contact, const double* pressure, const double* traction_x,
                                           const double* traction_y, int32_t count);
/* A daemon ends contacts that were not used for so long (s). */
CONTACTD_API int32_t contactd_set_lease(contactd_contact* contact, double seconds);

/* --- the load: holds until it is set anew; before and after contactd_start ----------------------------------- */
/* Either of the two: the later one counts (mm, N). */
CONTACTD_API int32_t contactd_set_approach(contactd_contact* contact, double approach);
CONTACTD_API int32_t contactd_set_Fn(contactd_contact* contact, double Fn);
/* The gap without the approach: h = x^2/(2 Rx) + y^2/(2 Ry), where a radius may be infinite; by the semi-axes of its
 * Hertzian contact under the load; or an array (mm). */
CONTACTD_API int32_t contactd_set_paraboloid(contactd_contact* contact, double Rx, double Ry);
CONTACTD_API int32_t contactd_set_semi_axes(contactd_contact* contact, double a, double b);
CONTACTD_API int32_t contactd_set_gap(contactd_contact* contact, const double* gap, int32_t count);
/* Friction: one (static) coefficient, or one of each element. None is set: no friction. */
CONTACTD_API int32_t contactd_set_mu(contactd_contact* contact, double mu);
CONTACTD_API int32_t contactd_set_mu_array(contactd_contact* contact, const double* mu, int32_t count);
/* Friction falls to mu with the slip velocity, whose scale is slip_velocity (mm/s). */
CONTACTD_API int32_t contactd_set_kinetic(contactd_contact* contact, int32_t law, double mu, double slip_velocity);
/* A shift over the step (mm, rad), and its duration (s), which only kinetic friction feels; 1 at first. */
CONTACTD_API int32_t contactd_set_shift(contactd_contact* contact, double x, double y, double rotation);
CONTACTD_API int32_t contactd_set_duration(contactd_contact* contact, double duration);
/* Rolling with creepages xi, eta and spin phi (rad/mm). Along chi (rad), by dq a step (mm; 0: an element); with the
 * spin taken spin_offset steps ahead (0 to 1); `steps` of transient rolling in one call; velocity (mm/s). */
CONTACTD_API int32_t contactd_set_rolling(contactd_contact* contact, int32_t kind, double xi, double eta, double phi);
CONTACTD_API int32_t contactd_set_direction(contactd_contact* contact, double chi, double dq);
CONTACTD_API int32_t contactd_set_spin_offset(contactd_contact* contact, double spin_offset);
CONTACTD_API int32_t contactd_set_rolling_steps(contactd_contact* contact, int32_t steps);
CONTACTD_API int32_t contactd_set_velocity(contactd_contact* contact, double velocity);
/* Forces on the upper body prescribed (N): shift or creepage that way are found, what was set is the estimate. */
CONTACTD_API int32_t contactd_set_Fx(contactd_contact* contact, double Fx);
CONTACTD_API int32_t contactd_set_Fy(contactd_contact* contact, double Fy);
CONTACTD_API int32_t contactd_clear_forces(contactd_contact* contact); /* neither Fx nor Fy */
/* Of each element, beside that of the motion: (mm), of rolling over the distance rolled. */
CONTACTD_API int32_t contactd_set_rigid_slip(contactd_contact* contact, const double* x, const double* y,
                                             int32_t count);
/* Whether steps bring this array along (1) or not (0, as at first). */
CONTACTD_API int32_t contactd_want(contactd_contact* contact, int32_t array, int32_t wanted);
/* Whether steps have derivatives (1) or not (0, as at first). */
CONTACTD_API int32_t contactd_want_derivatives(contactd_contact* contact, int32_t wanted);
/* Of a step, instead of the connection's. */
CONTACTD_API int32_t contactd_set_step_timeout(contactd_contact* contact, double seconds);

/* --- results of the last step -------------------------------------------------------------------------------- */
CONTACTD_API int32_t contactd_get_step(contactd_contact* contact, int32_t* step); /* its number, 0 before the first */
CONTACTD_API int32_t contactd_get_forces(contactd_contact* contact, double* Fn, double* Fx, double* Fy, double* Mz);
/* On curved columns forces[6]: Fx, Fy, Fz (N), Mx, My, Mz (N mm) of all tractions, in the axes of the section, about
 * the origin of the columns; CONTACTD_NOT_FOUND in a plane. */
CONTACTD_API int32_t contactd_get_resultant(contactd_contact* contact, double* forces);
CONTACTD_API int32_t contactd_get_approach(contactd_contact* contact, double* approach);
CONTACTD_API int32_t contactd_get_pmax(contactd_contact* contact, double* pmax);
CONTACTD_API int32_t contactd_get_areas(contactd_contact* contact, double* in_contact, double* adhesion, double* slip);
CONTACTD_API int32_t contactd_get_counts(contactd_contact* contact, int32_t* in_contact, int32_t* adhesion,
                                         int32_t* slip, int32_t* border);
/* As set, or found under forces; CONTACTD_NOT_FOUND when the bodies moved otherwise, or there was no friction. */
CONTACTD_API int32_t contactd_get_creepages(contactd_contact* contact, double* xi, double* eta, double* phi);
CONTACTD_API int32_t contactd_get_shift(contactd_contact* contact, double* x, double* y, double* rotation);
/* Dissipated by a shift (N mm), by rolling (N mm/s); CONTACTD_NOT_FOUND as above. */
CONTACTD_API int32_t contactd_get_frictional_work(contactd_contact* contact, double* work);
CONTACTD_API int32_t contactd_get_frictional_power(contactd_contact* contact, double* power);
/* Whether all solvers reached their tolerance, and how one of them ended: CONTACTD_NOT_FOUND when it did not run. */
CONTACTD_API int32_t contactd_get_converged(contactd_contact* contact, int32_t* converged);
CONTACTD_API int32_t contactd_get_evidence(contactd_contact* contact, int32_t solver, int32_t* iterations,
                                           double* residual, int32_t* converged);
/* One derivative: CONTACTD_OF_..., CONTACTD_BY_... The elements' states and what the step started from are held
 * (docs/contact.md). CONTACTD_NOT_FOUND where there is none: not wanted, no friction, no contact, not converged. */
CONTACTD_API int32_t contactd_get_derivative(contactd_contact* contact, int32_t of, int32_t by, double* value);
/* What the elements cost in accuracy (docs/contact.md); rolling_error is 0 where nothing rolled. CONTACTD_NOT_FOUND of
 * the quick models and without contact. */
CONTACTD_API int32_t contactd_get_discretisation(contactd_contact* contact, int32_t* elements_across,
                                                 double* force_error, double* pmax_error, double* rolling_error);
/* Sentences that a user of the results should know: how many, and one (from 0) into text[length], cut to fit. */
CONTACTD_API int32_t contactd_get_warnings(contactd_contact* contact, int32_t* count);
CONTACTD_API int32_t contactd_get_warning(contactd_contact* contact, int32_t index, char* text, int32_t length);
/* Arrays that were wanted: length = nx*ny. Slip is all zero without friction. */
CONTACTD_API int32_t contactd_get_array(contactd_contact* contact, int32_t array, double* values, int32_t length);
CONTACTD_API int32_t contactd_get_division(contactd_contact* contact, int32_t* division, int32_t length);
/* Where the coefficients came from, after contactd_start: "closed_form", "memory", "disk", "built" or "given";
 * CONTACTD_NOT_FOUND of rigid bodies and quick models. `body`: CONTACTD_UPPER, _LOWER, or _PAIR. */
CONTACTD_API int32_t contactd_get_origin(contactd_contact* contact, int32_t body, char* text, int32_t length);

/* --- wheels on rails ----------------------------------------------------------------------------------------- */
/* From profiles and the position of a wheelset to patches and forces (docs/wheel-rail.md has coordinates and signs):
 *
 *     contactd_wheel_new(connection, &wheel);
 *     contactd_wheel_set_velocity(wheel, 20e3, 0, 0, 0, 0, -20e3 / 460);
 *     contactd_wheel_set_Fz(wheel, 80e3);
 *     while (...) {
 *         contactd_wheel_set_position(wheel, y, 0, roll, yaw);
 *         contactd_wheel_solve(wheel);
 *         contactd_wheel_get_forces(wheel, CONTACTD_IN_TRACK, forces);
 *     }
 *
 * There is nothing to start: a wheel that was made is a right one, S1002 on 60E1 at 1/40, gauge 1435, of steel, with
 * mu = 0.3 and elements of 0.2 mm, and all of it can be set at any time. What is set holds until it is set anew. A
 * wheel whose set-up stays keeps its profiles and operators, with a daemon in a session of its own; a solve carries
 * nothing else over to the next one. Lengths are in mm, angles in rad, forces in N on the rail. */
/* Sets *wheel to NULL when it fails. */
CONTACTD_API int32_t contactd_wheel_new(contactd_connection* connection, contactd_wheel** wheel);
/* The handle is none afterwards, unless another thread uses it (CONCURRENT_USE). */
CONTACTD_API int32_t contactd_wheel_free(contactd_wheel* wheel);
/* No contact is an answer: no patches. So is what has not converged: contactd_wheel_get_converged. A solve that fails
 * leaves the results of the one before. */
CONTACTD_API int32_t contactd_wheel_solve(contactd_wheel* wheel);
/* Both wheels of a wheelset that is free to roll, at the height and the roll at which each presses on its rail as its
 * contactd_wheel_set_Fz says. Position, velocity and pitch rate of a roller are said of both alike, but z and roll,
 * where the right wheel's tell where to start; no longitudinal force and no derivatives. Each wheel then has its
 * results, which converged when both wheels and the search for the roll did. The timeout and the failures are those of
 * the right wheel; either is cancelled for both. */
CONTACTD_API int32_t contactd_wheel_solve_wheelset(contactd_wheel* right, contactd_wheel* left);
/* From any thread: the solve that runs ends with CONTACTD_CANCELLED soon. Does nothing when none runs. */
CONTACTD_API int32_t contactd_wheel_cancel(contactd_wheel* wheel);
/* Of a solve, instead of the connection's (s). */
CONTACTD_API int32_t contactd_wheel_set_timeout(contactd_wheel* wheel, double seconds);

/* The set-up. Profiles are those of a right side, of left wheels, too: y to the field side, z down. `body`:
 * CONTACTD_WHEEL or CONTACTD_RAIL. */
CONTACTD_API int32_t contactd_wheel_set_side(contactd_wheel* wheel, int32_t side);
CONTACTD_API int32_t contactd_wheel_set_s1002(contactd_wheel* wheel);
CONTACTD_API int32_t contactd_wheel_set_rail_60e1(contactd_wheel* wheel, double inclination); /* a slope: 1/40 */
/* An arc through the origin, with the slope dz/dy there; radius > 0 falls off to both sides. From y to y. */
CONTACTD_API int32_t contactd_wheel_set_arc(contactd_wheel* wheel, int32_t body, double radius, double slope,
                                            double from, double to);
CONTACTD_API int32_t contactd_wheel_set_cone(contactd_wheel* wheel, int32_t body, double slope, double from, double to);
/* Points in the order of the curve: y[count], z[count]. smoothing_length: wavelength of which half the amplitude is
 * smoothed away; 0: none. docs/profiles.md says what is made of them. */
CONTACTD_API int32_t contactd_wheel_set_points(contactd_wheel* wheel, int32_t body, const double* y, const double* z,
                                               int32_t count, double smoothing_length);
/* Of a file: Simpack (.prr, .prw), MiniProf (.ban, .whl), or two columns. It is read now, and here. */
CONTACTD_API int32_t contactd_wheel_set_file(contactd_wheel* wheel, int32_t body, const char* path,
                                             double smoothing_length);
/* The rail varies along the track: what its profile is set to now, it has at x. By ascending x, two or more. */
CONTACTD_API int32_t contactd_wheel_add_slice(contactd_wheel* wheel, double x);
CONTACTD_API int32_t contactd_wheel_clear_slices(contactd_wheel* wheel);
/* The wheel is not round: what its profile is set to now, it has at this angle about the axle, from z to x. By
 * ascending angles within a turn, two or more; after the last one the first one comes again.
 * contactd_wheel_set_pitch_angle says how far the wheel has turned. */
CONTACTD_API int32_t contactd_wheel_add_wheel_slice(contactd_wheel* wheel, double angle);
CONTACTD_API int32_t contactd_wheel_clear_wheel_slices(contactd_wheel* wheel); /* of the wheel only */
/* Where the rails lie: by their gauge, measured gauge_height below their tops, and the cant of the profiles; or where
 * the profile's origin is, from the centre of the track to the field side. What is said last holds; roller and springs
 * stay. */
CONTACTD_API int32_t contactd_wheel_set_track(contactd_wheel* wheel, double gauge, double gauge_height, double cant);
CONTACTD_API int32_t contactd_wheel_set_rail_origin(contactd_wheel* wheel, double y, double z);
/* A roller in place of the rail; 0: a rail. */
CONTACTD_API int32_t contactd_wheel_set_roller(contactd_wheel* wheel, double radius);
/* Springs hold a rail without mass against the ground (N/mm); 0, as at first: it is rigid in this direction. */
CONTACTD_API int32_t contactd_wheel_set_springs(contactd_wheel* wheel, double y, double z);
/* Between the backs of the flanges; y of a flange's back in its profile; radius of the wheel where its profile has
 * z = 0. */
CONTACTD_API int32_t contactd_wheel_set_wheelset(contactd_wheel* wheel, double flange_back_distance,
                                                 double flange_back_position, double nominal_radius);
CONTACTD_API int32_t contactd_wheel_set_material(contactd_wheel* wheel, int32_t body, double G, double nu);
CONTACTD_API int32_t contactd_wheel_set_rigid(contactd_wheel* wheel, int32_t body);
CONTACTD_API int32_t contactd_wheel_set_model(contactd_wheel* wheel, int32_t model);
/* Friction: one coefficient; or some by the angle of the rail's surface, angle[count] ascending, mu[count], straight
 * lines between; along_profile: 1, row by row; 0: one for each patch. Or none. */
CONTACTD_API int32_t contactd_wheel_set_mu(contactd_wheel* wheel, double mu);
CONTACTD_API int32_t contactd_wheel_set_mu_by_angle(contactd_wheel* wheel, const double* angle, const double* mu,
                                                    int32_t count, int32_t along_profile);
CONTACTD_API int32_t contactd_wheel_set_kinetic(contactd_wheel* wheel, int32_t law, double mu, double slip_velocity);
CONTACTD_API int32_t contactd_wheel_set_frictionless(contactd_wheel* wheel);
/* Size of the elements along and across the track, and step of rolling (0: dx). */
CONTACTD_API int32_t contactd_wheel_set_elements(contactd_wheel* wheel, double dx, double dy, double dq);
/* What becomes of regions of overlap that lie close to each other; at first pi/2, 8, 4, 12, 0.3. */
CONTACTD_API int32_t contactd_wheel_set_patch_rules(contactd_wheel* wheel, double angle_separate,
                                                    double distance_separate, double distance_combine,
                                                    double distance_turn, double locus_step);
/* 1: the wheel is evaluated between the corners of a mesh; 0, as at first: exactly. */
CONTACTD_API int32_t contactd_wheel_set_bilinear(contactd_wheel* wheel, int32_t bilinear);
/* 1: elements slip by the motion of both surfaces there, for conformal contact; 0: by creepages, as in a plane. */
CONTACTD_API int32_t contactd_wheel_set_slip_of_surfaces(contactd_wheel* wheel, int32_t of_surfaces);
/* 1: regions of overlap are found on a mesh seen from above, for rails that curve along the track, too; 0: by a locus.
 */
CONTACTD_API int32_t contactd_wheel_set_mesh_search(contactd_wheel* wheel, int32_t mesh);
/* 0, as at first: contacts lie in planes. Otherwise they are curved across the track, half-way between wheel and rail,
 * with the coefficients of half-spaces that lie flat (1) or turn from row to row (2), or of both cross-sections by
 * finite elements (3); 4: as 2 where a plane would be left by more than 0.24 rad, else as 0. */
CONTACTD_API int32_t contactd_wheel_set_conformal(contactd_wheel* wheel, int32_t conformal);
/* `solver`: CONTACTD_NORMAL, _TANGENTIAL, _OUTER, or _FORCE, the search for z. */
CONTACTD_API int32_t contactd_wheel_set_tolerance(contactd_wheel* wheel, int32_t solver, double tolerance,
                                                  int32_t max_iterations);

/* The state; each function leaves alone what the others say. Of the wheelset's centre, from where it stands in the
 * middle with its tape circles on the plane of the track; roll turns y to z, yaw x to y. */
CONTACTD_API int32_t contactd_wheel_set_position(contactd_wheel* wheel, double y, double z, double roll, double yaw);
CONTACTD_API int32_t contactd_wheel_set_x(contactd_wheel* wheel, double x); /* along the track, where the rail varies */
/* How far the wheelset has turned about its axle, where a wheel is not round: with the slice of angle -pitch below. Not
 * how fast: that is of contactd_wheel_set_velocity. */
CONTACTD_API int32_t contactd_wheel_set_pitch_angle(contactd_wheel* wheel, double pitch);
/* Of the centre (mm/s) and about its own axes (rad/s): rolling forwards has a pitch rate near -x/nominal_radius. */
CONTACTD_API int32_t contactd_wheel_set_velocity(contactd_wheel* wheel, double x, double y, double z, double roll,
                                                 double yaw, double pitch);
/* Of the rail from where it should lie, in track coordinates; and how fast that changes. */
CONTACTD_API int32_t contactd_wheel_set_deviation(contactd_wheel* wheel, double y, double z, double roll);
CONTACTD_API int32_t contactd_wheel_set_deviation_rate(contactd_wheel* wheel, double y, double z, double roll);
/* What acts on a rail on springs beside wheel and springs, in track coordinates; 0 where it is rigid. */
CONTACTD_API int32_t contactd_wheel_set_rail_forces(contactd_wheel* wheel, double Fy, double Fz);
CONTACTD_API int32_t contactd_wheel_set_roller_pitch(contactd_wheel* wheel, double pitch); /* of a roller (rad/s) */
/* Forces prescribed: the vertical one on the rail, which z is found for, and the longitudinal one, which the pitch rate
 * is found for. */
CONTACTD_API int32_t contactd_wheel_set_Fz(contactd_wheel* wheel, double Fz);
CONTACTD_API int32_t contactd_wheel_set_Fx(contactd_wheel* wheel, double Fx);
/* z and pitch rate are prescribed; what acts on the rail beside stays. */
CONTACTD_API int32_t contactd_wheel_clear_forces(contactd_wheel* wheel);
/* Whether patches bring this array along, CONTACTD_GAP, too (1), or not (0, as at first). */
CONTACTD_API int32_t contactd_wheel_want(contactd_wheel* wheel, int32_t array, int32_t wanted);
CONTACTD_API int32_t contactd_wheel_want_derivatives(contactd_wheel* wheel, int32_t wanted);

/* Results of the last solve. Height and pitch rate of the wheelset, as prescribed or found. */
CONTACTD_API int32_t contactd_wheel_get_motion(contactd_wheel* wheel, double* z, double* pitch);
CONTACTD_API int32_t contactd_wheel_get_roll(contactd_wheel* wheel, double* roll); /* the same of the roll */
/* By how much a rail on springs has given way, beside its deviation, in track coordinates; CONTACTD_NOT_FOUND: it has
 * no springs. */
CONTACTD_API int32_t contactd_wheel_get_rail_shift(contactd_wheel* wheel, double* y, double* z);
/* Least vertical distance of wheel and rail, < 0 where they overlap; CONTACTD_NOT_FOUND where they are not above each
 * other. */
CONTACTD_API int32_t contactd_wheel_get_clearance(contactd_wheel* wheel, double* clearance);
/* forces[6]: Fx, Fy, Fz (N) and Mx, My, Mz (N mm), about the origin of the coordinates, CONTACTD_IN_TRACK, _IN_RAIL or
 * _IN_WHEELSET. */
CONTACTD_API int32_t contactd_wheel_get_forces(contactd_wheel* wheel, int32_t coordinates, double* forces);
/* forces[6] in track coordinates, by CONTACTD_BY_POSITION_... or _VELOCITY_...; CONTACTD_NOT_FOUND where there are
 * none: not wanted, no contact, not converged. */
CONTACTD_API int32_t contactd_wheel_get_derivative(contactd_wheel* wheel, int32_t by, double* forces);
CONTACTD_API int32_t contactd_wheel_get_converged(contactd_wheel* wheel, int32_t* converged);
/* Of a search, CONTACTD_FORCE, _PITCH, _ROLL or _RAIL_SHIFT: solves, what was left (of a roll mm between the heights of
 * the wheels), whether that is enough; CONTACTD_NOT_FOUND: it did not run. */
CONTACTD_API int32_t contactd_wheel_get_evidence(contactd_wheel* wheel, int32_t solver, int32_t* iterations,
                                                 double* residual, int32_t* converged);
CONTACTD_API int32_t contactd_wheel_get_warnings(contactd_wheel* wheel, int32_t* count);
CONTACTD_API int32_t contactd_wheel_get_warning(contactd_wheel* wheel, int32_t index, char* text, int32_t length);
/* Patches, from the right to the left; `patch` counts from 0. */
CONTACTD_API int32_t contactd_wheel_get_patches(contactd_wheel* wheel, int32_t* count);
/* The origin of its contact coordinates, on the rail in track coordinates, and the angle of its plane. */
CONTACTD_API int32_t contactd_wheel_get_place(contactd_wheel* wheel, int32_t patch, double* x, double* y, double* z,
                                              double* angle);
/* Elements, their size, and the corner of element (0, 0), in contact coordinates. */
CONTACTD_API int32_t contactd_wheel_get_grid(contactd_wheel* wheel, int32_t patch, int32_t* nx, int32_t* ny, double* dx,
                                             double* dy, double* x0, double* y0);
/* The rows of a curved contact, length = ny: their middles in track coordinates, and their inclinations;
 * CONTACTD_NOT_FOUND of one that lies in a plane. */
CONTACTD_API int32_t contactd_wheel_get_rows(contactd_wheel* wheel, int32_t patch, double* y, double* z, double* angle,
                                             int32_t length);
CONTACTD_API int32_t contactd_wheel_get_creepages(contactd_wheel* wheel, int32_t patch, double* xi, double* eta,
                                                  double* phi, double* velocity);
/* Of curvature, > 0 where convex, infinite where straight. */
CONTACTD_API int32_t contactd_wheel_get_radii(contactd_wheel* wheel, int32_t patch, double* wheel_along,
                                              double* wheel_across, double* rail_along, double* rail_across);
/* In contact coordinates: normal, longitudinal and lateral force, and moment about the normal. */
CONTACTD_API int32_t contactd_wheel_get_contact_forces(contactd_wheel* wheel, int32_t patch, double* Fn, double* Fx,
                                                       double* Fs, double* Mn);
/* forces[6] as contactd_wheel_get_forces. */
CONTACTD_API int32_t contactd_wheel_get_patch_forces(contactd_wheel* wheel, int32_t patch, int32_t coordinates,
                                                     double* forces);
CONTACTD_API int32_t contactd_wheel_get_pressure(contactd_wheel* wheel, int32_t patch, double* approach, double* pmax);
CONTACTD_API int32_t contactd_wheel_get_areas(contactd_wheel* wheel, int32_t patch, double* in_contact,
                                              double* adhesion, double* slip);
/* Dissipated by rolling (N mm/s); CONTACTD_NOT_FOUND without friction. */
CONTACTD_API int32_t contactd_wheel_get_frictional_power(contactd_wheel* wheel, int32_t patch, double* power);
CONTACTD_API int32_t contactd_wheel_get_counts(contactd_wheel* wheel, int32_t patch, int32_t* in_contact,
                                               int32_t* adhesion, int32_t* slip, int32_t* border);
/* Arrays that were wanted: length = nx*ny of the patch. Slip is all zero without friction, and CONTACTD_GAP is of model
 * full only. */
CONTACTD_API int32_t contactd_wheel_get_array(contactd_wheel* wheel, int32_t patch, int32_t array, double* values,
                                              int32_t length);
CONTACTD_API int32_t contactd_wheel_get_division(contactd_wheel* wheel, int32_t patch, int32_t* division,
                                                 int32_t length);

#ifdef __cplusplus
}
#endif

#endif
