/* The functions of the CONTACT program's C library, solved by contactd in process.
 *
 * A program that calls that library for basic contact ("module 3") or for a wheel on a rail ("module 1") can link this
 * one instead. docs/cntc.md lists the supported features and the signs of each function, and
 * docs/contact-conventions.md the meaning of each digit and number.
 *
 * Every argument is a pointer; functions return nothing. `ire` is the number of a result element, and `icp` that of a
 * contact problem in it, from 1 on. In functions that set values, and in cntc_calculate, -1 as `icp` means all contact
 * problems. Arrays and strings are passed with their length. A wheel on a rail is set and solved as a whole, with -1;
 * its patches are the contact problems 1, 2, ... of the solution, and body 1 is the rail. Arrays of elements have the
 * index iy*mx + ix: x is fastest. Flag 1933 selects the units:
 *
 *     1934   mm, mm/s, N, N/mm^2     forces and tractions on body 1, the upper one (default)
 *     1935   m, m/s, N, N/m^2        on body 2
 *     1936   m, m/s, N, N/m^2        on body 1
 *
 * Angles are in rad. Creepages, shifts and forces as inputs, and displacements, are those of body 1. Creepages, shifts
 * and slip as results are those of the body of the units, relative to the other one.
 *
 * Unsupported or invalid inputs are refused: with a sentence on standard error, the first time, and in
 * contactd_cntc_last_error(). cntc_calculate returns the code of a refusal until the input is corrected. Missing
 * numbers are NaN. No null pointer, number, handle or order of calls terminates the program. Functions may be called
 * from any thread; result elements are independent.
 *
 * Every name also exists with an appended underscore, for Fortran compilers.
 */
#ifndef CONTACTD_CNTC_H
#define CONTACTD_CNTC_H

#ifdef __cplusplus
extern "C" {
#endif

/* --- functions only in contactd ------------------------------------------------------------------------------- */

/* Returns the error message of this thread's last call of a function below, or "". It is valid until the next call.
 * `*code`, unless `code` is null, is the code of the error: 0, or one of those of cntc_calculate. A warning begins with
 * "Warning:" and has code 0. */
const char* contactd_cntc_last_error(int* code);

/* --- start and end -------------------------------------------------------------------------------------------- */

/* Returns the version of the interface in `*ifcver`, and 0 or an error in `*ierror`. No file is written, so folders and
 * the name of the experiment are ignored. Arguments from the fourth on are not read, so shorter lists work, too. */
void cntc_initializefirst(int* ifcver, int* ierror, int* ioutput, const char* wrkdir, const char* outdir,
                          const char* expnam, int* len_wrkdir, int* len_outdir, int* len_expnam);
void cntc_initializefirst_new(int* ifcver, int* ierror, int* ioutput, const char* wrkdir, const char* outdir,
                              const char* expnam, int* len_wrkdir, int* len_outdir, int* len_expnam);
/* `*imodul` is 3 for basic contact, or 1 (also 11) for a wheel on a rail. A result element that is not initialized
 * becomes basic contact when a value of it is first set. */
void cntc_initialize(int* ire, int* imodul, int* ifcver, int* ierror, const char* outdir, int* len_outdir);
/* Removes a result element, or all of them. */
void cntc_finalize(int* ire);
void cntc_finalizelast(void);
/* No effect: no file is opened. */
void cntc_setfileunits(int* nunits, int* iunits);
/* Returns 1: each solve runs in the calling thread. */
void cntc_getmaxnumthreads(int* mxthrd);

/* --- flags: pairs of code and value --------------------------------------------------------------------------- */

void cntc_setglobalflags(int* lenflg, int* params, int* values);
void cntc_setflags(int* ire, int* icp, int* lenflg, int* params, int* values);
void cntc_getflags(int* ire, int* icp, int* lenflg, int* params, int* values);
void cntc_setmetadata(int* ire, int* icp, int* lenmta, int* params, double* values);
void cntc_setsolverflags(int* ire, int* icp, int* gdigit, int* nints, int* iparam, int* nreals, double* rparam);

/* Sets the inputs from an input file: one case for each contact problem of the result element, or one case of a wheel
 * on a rail. Cases are those with the number of the element, or those of a file without numbers. `itype` has no effect.
 * `*ierror` is 0, or the code of a refusal; a refused case changes nothing. */
void cntc_readinpfile(int* ire, int* itype, const char* name, int* len_name, int* ierror);

/* --- bodies and friction -------------------------------------------------------------------------------------- */

/* Sets the materials; rparam begins with [nu1, nu2, G1, G2] for imeth 0 to 5, which set flag 1979.
 * 0: elastic bodies;
 * 1: viscoelastic bodies in steady rolling, [.., fg1, fg2, tc1, tc2]: delayed over instantaneous compliances, and
 *    retardation times (s);
 * 3: FASTSIM, 5: FaStrip, [.., k0, alpha, beta]: reduction of the slope, 1, 1, 0 for none;
 * 4: a layer between the bodies, [.., gg3, laythk, tau_c0, k_tau].
 * 10: no damping, 11: unchanged damping, 12: [cdampn, cdampt, dfnmax, dftmax], of which the first two must be 0. */
void cntc_setmaterialparameters(int* ire, int* icp, int* imeth, int* nparam, double* rparam);
/* Sets the friction. imeth 0: [fstat, fkin], which must be equal; 2, 3 and 4: [fkin, f1, s1, f2, s2, memdst, mem_s0];
 * 5: Polach's [fstat, A, B]; 6: [fref, tref, dfheat, dtheat, memdst, mem_s0]. For a wheel on a rail, imeth plus 10:
 * [number, and for each the rail's angle and these values]; imeth plus 20: positions along the track instead. */
void cntc_setfrictionmethod(int* ire, int* icp, int* imeth, int* nparam, double* params);
/* Returns [velocity, chi, dq, centre of spin along x and y, tau_c0] for itask 1, the material for 2, the friction for
 * 3. */
void cntc_getparameters(int* ire, int* icp, int* itask, int* lenarr, double* values);

/* --- potential contact area and undeformed distance ----------------------------------------------------------- */

/* For a wheel on a rail, 0: [dx, ds, -]; -1: [dx, ds, a_sep, d_sep, d_comb, d_turn], where d_turn is optional. */
void cntc_setpotcontact(int* ire, int* icp, int* ipotcn, int* nparam, double* rparam);
void cntc_sethertzcontact(int* ire, int* icp, int* ipotcn, int* nparam, double* rparam);
void cntc_setundeformeddistc(int* ire, int* icp, int* ibase, int* nparam, double* prmudf);
void cntc_gethertzcontact(int* ire, int* icp, int* lenarr, double* values);
void cntc_getpotcontact(int* ire, int* icp, int* lenarr, double* values);
void cntc_getnumelements(int* ire, int* icp, int* mx, int* my);
void cntc_getgriddiscretization(int* ire, int* icp, double* dx, double* dy);

/* --- load and motion ------------------------------------------------------------------------------------------ */

void cntc_setpenetration(int* ire, int* icp, double* pen);
void cntc_setnormalforce(int* ire, int* icp, double* fn);
void cntc_settimestep(int* ire, int* icp, double* dt);
void cntc_setreferencevelocity(int* ire, int* icp, double* veloc);
/* For a wheel on a rail, dq is relative to dx, and chi has no effect. */
void cntc_setrollingstepsize(int* ire, int* icp, double* chi, double* dq);
void cntc_setcreepages(int* ire, int* icp, double* vx, double* vy, double* phi);
/* Forces over fstat fn. For a wheel on a rail, fx is the longitudinal force on the rail (N) along the wheelset's axes.
 */
void cntc_settangentialforces(int* ire, int* icp, double* fx, double* fy);
void cntc_setextrarigidslip(int* ire, int* icp, int* lenarr, double* wx, double* wy);
void cntc_getpenetration(int* ire, int* icp, double* pen);
void cntc_getcreepages(int* ire, int* icp, double* vx, double* vy, double* phi);
void cntc_getreferencevelocity(int* ire, int* icp, double* veloc);

/* --- the solution --------------------------------------------------------------------------------------------- */

/* Solves. `*ierror` is 0, the number of elements in contact at the border of the potential contact area, or negative:
 * -27, -28  the normal or the tangential solver did not converge; -29: it stopped above the tolerance, and the best
 *           solution can be read;
 * -25       wheel and rail do not touch; -26: no height or pitch rate produces the force;
 * -31       there is no such result element or contact problem;
 * -32       a profile is invalid;
 * -33, -34  friction, or elements and steps, are invalid;
 * -39       another input is invalid or missing;
 * -99       other errors. */
void cntc_calculate(int* ire, int* icp, int* ierror);
/* The same for a wheel on a rail, and for basic contact. */
void cntc_calculate1(int* ire, int* ierror);
void cntc_calculate3(int* ire, int* icp, int* ierror);
void cntc_getcontactforces(int* ire, int* icp, double* fn, double* fx, double* fy, double* mz);
void cntc_getcontactpatchareas(int* ire, int* icp, double* contact, double* adhesion, double* slip);
void cntc_getmaximumpressure(int* ire, int* icp, double* pnmax);
void cntc_getmaximumtraction(int* ire, int* icp, double* ptmax);
void cntc_getelementdivision(int* ire, int* icp, int* lenarr, int* division);
void cntc_gettractions(int* ire, int* icp, int* lenarr, double* pn, double* px, double* py);
void cntc_getmicroslip(int* ire, int* icp, int* lenarr, double* sx, double* sy);
void cntc_getdisplacements(int* ire, int* icp, int* lenarr, double* un, double* ux, double* uy);
void cntc_getfielddata(int* ire, int* icp, int* ifld, int* lenarr, double* values);
/* values[out + lenout * in]; out: fn, fx and fy over fstat fn, mz; in: pen, vx, vy, phi. In all units, they are the
 * derivatives of the forces on body 1 with respect to the motion as set. */
void cntc_getsensitivities(int* ire, int* icp, int* lenout, int* lenin, double* values);
void cntc_getcalculationtime(int* ire, int* icp, double* cpu, double* wall);
void cntc_resetcalculationtime(int* ire, int* icp);

/* --- stresses below the surface: z > 0 inside body 1, z < 0 inside body 2 ------------------------------------- */

void subs_addblock(int* ire, int* icp, int* iblk, int* isubs, int* nx, int* ny, int* nz, double* x, double* y,
                   double* z);
void subs_calculate(int* ire, int* icp, int* ierror);
void subs_getblocksize(int* ire, int* icp, int* iblk, int* nx, int* ny, int* nz);
/* values[point + lenarr * column], with the columns in icol. */
void subs_getresults(int* ire, int* icp, int* iblk, int* lenarr, int* ncol, int* icol, double* values);

/* --- a wheel on a rail ---------------------------------------------------------------------------------------- */

/* Sets a profile. iparam: [0 rail or 1 wheel, -, 1 mirrors y, 1 mirrors z, -, smoothing 0 to 2]; rparam: [unit in mm,
 * smoothing, -, -, kink angle, rest next to kinks, width of kinks]. Both may end earlier. Without a type, the extension
 * of the name determines it. Values are y and z alternately. */
void cntc_setprofileinputfname(int* ire, const char* name, int* len_name, int* nints, int* iparam, int* nreals,
                               double* rparam);
void cntc_setprofileinputvalues(int* ire, int* npoint, double* values, int* nints, int* iparam, int* nreals,
                                double* rparam);
/* ztrack 1: [gaught, -, gaugwd, cant, nomrad, curv], or with gaught <= 0 [gaught, raily0, railz0, cant, nomrad, curv];
 * 2: [dyrail, dzrail, drollr, vyrail, vzrail, vrollr]; 3: both; 32, 33: [kyrail, fyrail, kzrail, fzrail]; 0: none. */
void cntc_settrackdimensions(int* ire, int* ztrack, int* nparam, double* rparam);
/* [fbdist, fbpos, nomrad] */
void cntc_setwheelsetdimensions(int* ire, int* ewheel, int* nparam, double* rparam);
/* [s, y, z, roll, yaw, pitch] */
void cntc_setwheelsetposition(int* ire, int* ewheel, int* nparam, double* rparam);
/* [vs, or for a roller its pitch rate, vy, vz, vroll, vyaw, vpitch] */
void cntc_setwheelsetvelocity(int* ire, int* ewheel, int* nparam, double* rparam);
/* [dx, dy, dz, droll, dyaw, dpitch, vx, vy, vz, vroll, vyaw, vpitch] of the wheel */
void cntc_setwheelsetflexibility(int* ire, int* ewheel, int* nparam, double* rparam);
/* Also sets N. */
void cntc_setverticalforce(int* ire, double* fz);
void cntc_getnumcontactpatches(int* ire, int* npatch);
/* Returns up to 38 numbers, limited by lenarr; docs/cntc.md lists them. */
void cntc_getcontactlocation(int* ire, int* icp, int* lenarr, double* values);
/* Returns force and moment in the axes of track, wheelset, rail and wheel; icp = -1: of all patches. */
void cntc_getglobalforces(int* ire, int* icp, int* lenarr, double* values);
void cntc_getwheelsetposition(int* ire, int* lenarr, double* values);
void cntc_getwheelsetvelocity(int* ire, int* lenarr, double* values);
/* Returns for itask -1: whether there is one; 0: number of points; 1: y, then z; 2: the same in the track; 3: gauge; 4:
 * lengths; 5: inclinations. iparam: [0 rail or 1 wheel, sampling], rparam: [step]. */
void cntc_getprofilevalues(int* ire, int* itask, int* nints, int* iparam, int* lenarr, double* values);
void cntc_getprofilevalues_new(int* ire, int* itask, int* nints, int* iparam, int* nreals, double* rparam, int* lenarr,
                               double* values);

/* --- heat --------------------------------------------------------------------------------------------------- */

/* imeth 3: [bulk temperature, heat capacity, conductivity, density] of body 1 and of body 2, and the share of a layer's
 * plastic work that becomes heat, which is 1 if it is missing; 1 keeps them, 0 is none. */
void cntc_settemperaturedata(int* ire, int* icp, int* imeth, int* nparam, double* rparam);
/* The largest temperatures of the surfaces of both bodies; 0 without heat. */
void cntc_getmaximumtemperature(int* ire, int* icp, double* t1max, double* t2max);

#ifdef __cplusplus
}
#endif

#endif
