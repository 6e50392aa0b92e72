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

/* Derivatives: of an answer, by an input. Along x and y stand xi and eta of rolling, or the shift; turn is phi, or the
 * rotation; load is the approach or Fn, whichever is prescribed. */
enum { CONTACTD_OF_FX = 0, CONTACTD_OF_FY = 1, CONTACTD_OF_MZ = 2, CONTACTD_OF_FN = 3, CONTACTD_OF_APPROACH = 4 };
enum { CONTACTD_BY_X = 0, CONTACTD_BY_Y = 1, CONTACTD_BY_TURN = 2, CONTACTD_BY_LOAD = 3, CONTACTD_BY_MU = 4 };

enum { CONTACTD_WHEEL = 0, CONTACTD_RAIL = 1 }; /* whose profile bounds a section */

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
 * Numbers, flags (0 or 1) and whole numbers; a field that may be left out is there from then on, and a list gets its
 * next entry where that is named. Inputs of a contact are those of contact.solve, as "grid.dx" or "bodies.upper.G". */
CONTACTD_API int32_t contactd_set(void* handle, const char* path, double value);
/* One of the keywords that the field has, such as "setup.model" "hertz". */
CONTACTD_API int32_t contactd_set_word(void* handle, const char* path, const char* word);
/* All numbers of an object in the order of its fields, as "state.velocity"; or of a list, entry by entry: as many as
 * there are, "setup.friction.mu" an angle and a coefficient each, "setup.rail.points" y and z. */
CONTACTD_API int32_t contactd_set_array(void* handle, const char* path, const double* values, int32_t count);
/* Leaves a field out again that may be: "setup.friction": without friction; "state.Fz": z is prescribed; a list. */
CONTACTD_API int32_t contactd_clear(void* handle, const char* path);
/* Reads the last solve or step; a list gives its length. CONTACTD_NOT_FOUND: the solution does not have it. */
CONTACTD_API int32_t contactd_get(void* handle, const char* path, double* value);
/* `text`, of `length` bytes with its end, into which what is longer is cut. */
CONTACTD_API int32_t contactd_get_word(void* handle, const char* path, char* text, int32_t length);
/* All numbers of an object or a list, as contactd_set_array; or of an array over the grid that contactd_want asked for,
 * as "patches[0].solution.pressure": element_division has CONTACTD_EXTERIOR, _ADHESION and _SLIP, slip is all zero
 * without friction. `count` must be that of contactd_length. */
CONTACTD_API int32_t contactd_get_array(void* handle, const char* path, double* values, int32_t count);
CONTACTD_API int32_t contactd_length(void* handle, const char* path, int32_t* count);
/* Whether solves or steps from now on bring along an array over the grid (1), or not (0, as at first): "pressure",
 * "traction_x", "traction_y", "slip_x", "slip_y", "element_division"; of wheels also "gap", the undeformed distances,
 * which the model full has. */
CONTACTD_API int32_t contactd_want(void* handle, const char* array, int32_t wanted);

/* For loops in which a text costs too much: *id stands for the path, with this handle and as long as it lives. */
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
 * "setup.rail.points" of a wheel: z of a profile is down. */
CONTACTD_API int32_t contactd_set_profile_points(contactd_contact* contact, int32_t body, int32_t kind, const double* y,
                                                 const double* z, int32_t count, double smoothing_length, double depth,
                                                 double from);
CONTACTD_API int32_t contactd_set_profile_file(contactd_contact* contact, int32_t body, int32_t kind, const char* path,
                                               double smoothing_length, double depth, double from);
/* An outline of one's own begins here, and is travelled with the body on its right; each part begins where the one
 * before ended, and the last one ends at the beginning. clamped: 1, nothing moves along it. radius > 0: convex, < 0:
 * hollow. Parts that are added behind contactd_add_hole are the hole's. */
CONTACTD_API int32_t contactd_set_outline(contactd_contact* contact, int32_t body, double y, double z);
CONTACTD_API int32_t contactd_add_line(contactd_contact* contact, int32_t body, double y, double z, int32_t clamped);
CONTACTD_API int32_t contactd_add_arc(contactd_contact* contact, int32_t body, double y, double z, double radius,
                                      int32_t clamped);
CONTACTD_API int32_t contactd_add_spline(contactd_contact* contact, int32_t body, const double* y, const double* z,
                                         int32_t count, int32_t clamped);
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
/* Where the coefficients came from, after contactd_start: "closed_form", "memory", "disk", "built" or "given";
 * CONTACTD_NOT_FOUND of rigid bodies and quick models. `body`: CONTACTD_UPPER, _LOWER, or _PAIR. */
CONTACTD_API int32_t contactd_get_origin(contactd_contact* contact, int32_t body, char* text, int32_t length);

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
 * wheel whose set-up stays keeps its profiles and operators, with a daemon in a session of its own; a solve carries
 * nothing else over to the next one. Lengths are in mm, angles in rad, forces in N on the rail.
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
/* Makes the profile that `path` names, as "setup.rail" or "setup.rail_slices[0].profile", that of a file: Simpack
 * (.prr, .prw), MiniProf (.ban, .whl), or two columns. It is read now, and here. */
CONTACTD_API int32_t contactd_wheel_read_profile(contactd_wheel* wheel, const char* path, const char* file);
/* No contact is an answer: no patches. So is what has not converged: the result "converged". A solve that fails leaves
 * the results of the one before. */
CONTACTD_API int32_t contactd_wheel_solve(contactd_wheel* wheel);
/* Both wheels of a wheelset that is free to roll, at the height and the roll at which each presses on its rail by its
 * "state.Fz". Position, velocity and pitch rate of a roller are the same for both, but z and roll, where the right
 * wheel's tell where to start; no longitudinal force and no derivatives. Each wheel then has its results, which
 * converged when both wheels and the search for the roll did. The timeout and the failures are those of the right
 * wheel; either is cancelled for both. */
CONTACTD_API int32_t contactd_wheel_solve_wheelset(contactd_wheel* right, contactd_wheel* left);
/* From any thread: the solve that runs ends with CONTACTD_CANCELLED soon. Does nothing when none runs. */
CONTACTD_API int32_t contactd_wheel_cancel(contactd_wheel* wheel);
/* Of a solve, instead of the connection's (s). */
CONTACTD_API int32_t contactd_wheel_set_timeout(contactd_wheel* wheel, double seconds);

#ifdef __cplusplus
}
#endif

#endif
