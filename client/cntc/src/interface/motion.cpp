// Sets the load and the motion of the bodies.
#include <cmath>

#include "interface/entry.hpp"

using namespace contactd;
using namespace contactd::cntc;

namespace {

/// Replaces the motion by that computed for prescribed forces, unless it was set again.
void take_found(const ProblemCase& problem, GivenMotion& motion) {
    if (!problem.current || !problem.solved->solution.motion || problem.settings.digits.force == 0) return;
    const Motion& found = *problem.solved->solution.motion;
    if (const auto* rolling = std::get_if<Rolling>(&found)) {
        if (rolling->force.Fx) motion.vx = rolling->xi - rolling->phi * problem.settings.spin_y;
        if (rolling->force.Fy) motion.vy = rolling->eta + rolling->phi * problem.settings.spin_x;
        return;
    }
    const auto& shift = std::get<Shift>(found);
    const double mm = problem.settings.units.length;
    if (shift.force.Fx) motion.vx = (shift.rigid_shift.x - shift.rotation * problem.settings.spin_y) / mm;
    if (shift.force.Fy) motion.vy = (shift.rigid_shift.y + shift.rotation * problem.settings.spin_x) / mm;
}

/// Converts the motion to the current units.
GivenMotion in_units(GivenMotion motion, double length, bool rolls) {
    const double change = motion.length / length;
    if (rolls)
        motion.phi /= change;
    else {
        motion.vx *= change;
        motion.vy *= change;
    }
    motion.length = length;
    return motion;
}

}  // namespace

extern "C" void cntc_setpenetration(int* ire, int* icp, double* pen) {
    set_basic("cntc_setpenetration", ire, icp, "load", [&](Settings& settings) {
        settings.pen = number(pen, "pen") * settings.units.length;
        settings.digits.normal = 0;
    });
}
CONTACTD_FORTRAN_NAME(cntc_setpenetration)

extern "C" void cntc_setnormalforce(int* ire, int* icp, double* fn) {
    set_basic("cntc_setnormalforce", ire, icp, "load", [&](Settings& settings) {
        const double force = number(fn, "fn");
        if (force < 0) throw Refused(error_code::input, "fn is negative; it must be at least 0.");
        settings.fn = force;
        settings.digits.normal = 1;
    });
}
CONTACTD_FORTRAN_NAME(cntc_setnormalforce)

extern "C" void cntc_settimestep(int* ire, int* icp, double* dt) {
    set("cntc_settimestep", ire, icp, "time step",
        [&](Settings& settings) { settings.time_step = positive(number(dt, "dt"), "dt"); });
}
CONTACTD_FORTRAN_NAME(cntc_settimestep)

extern "C" void cntc_setreferencevelocity(int* ire, int* icp, double* veloc) {
    set_basic("cntc_setreferencevelocity", ire, icp, "velocity", [&](Settings& settings) {
        settings.velocity = positive(std::abs(number(veloc, "veloc")), "veloc") * settings.units.length;
    });
}
CONTACTD_FORTRAN_NAME(cntc_setreferencevelocity)

extern "C" void cntc_setrollingstepsize(int* ire, int* icp, double* chi, double* dq) {
    // On rails the direction follows from the motion, and the step is counted in elements.
    if (of_rail(ire))
        return set_rail("cntc_setrollingstepsize", ire, "rolling step",
                        [&](RailSettings& rail, const Units&) { rail.dq = positive(number(dq, "dq"), "dq"); });
    set("cntc_setrollingstepsize", ire, icp, "rolling step", [&](Settings& settings) {
        const double angle = number(chi, "chi"), step = positive(number(dq, "dq"), "dq") * settings.units.length;
        settings.chi = angle;
        settings.dq = step;
    });
}
CONTACTD_FORTRAN_NAME(cntc_setrollingstepsize)

extern "C" void cntc_setcreepages(int* ire, int* icp, double* vx, double* vy, double* phi) {
    set_basic("cntc_setcreepages", ire, icp, "creepages", [&](Settings& settings) {
        settings.motion = GivenMotion{number(vx, "vx"), number(vy, "vy"), number(phi, "phi"), settings.units.length};
    });
}
CONTACTD_FORTRAN_NAME(cntc_setcreepages)

extern "C" void cntc_settangentialforces(int* ire, int* icp, double* fx, double* fy) {
    // On rails the longitudinal force is absolute: the force on the rail along the wheelset's axes.
    if (of_rail(ire))
        return set_rail("cntc_settangentialforces", ire, "longitudinal force",
                        [&](RailSettings& rail, const Units&) { rail.Fx = number(fx, "fx"); });
    set("cntc_settangentialforces", ire, icp, "tangential forces",
        [&](Settings& settings) { settings.force = RelativeForce{number(fx, "fx"), number(fy, "fy")}; });
}
CONTACTD_FORTRAN_NAME(cntc_settangentialforces)

extern "C" void cntc_setextrarigidslip(int* ire, int* icp, int* lenarr, double* wx, double* wy) {
    set_basic("cntc_setextrarigidslip", ire, icp, "rigid slip", [&](Settings& settings) {
        auto x = numbers(wx, lenarr, 1, "wx"), y = numbers(wy, lenarr, 1, "wy");
        settings.extra_slip = GivenSlip{std::move(x), std::move(y), settings.units.length};
        settings.digits.extra_slip = 9;
    });
}
CONTACTD_FORTRAN_NAME(cntc_setextrarigidslip)

extern "C" void cntc_getpenetration(int* ire, int* icp, double* pen) {
    clear(pen);
    get("cntc_getpenetration", ire, icp, [&](const ProblemCase& problem) {
        require(pen, "pen");
        const Settings& settings = problem.settings;
        const bool given = settings.digits.normal == 0 && settings.pen;
        const double found = given ? *settings.pen : solution_of(problem).solution.approach;
        *pen = found / settings.units.length;
    });
}
CONTACTD_FORTRAN_NAME(cntc_getpenetration)

extern "C" void cntc_getcreepages(int* ire, int* icp, double* vx, double* vy, double* phi) {
    for (double* out : {vx, vy, phi}) clear(out);
    get("cntc_getcreepages", ire, icp, [&](const ProblemCase& problem) {
        for (const double* out : {vx, vy, phi}) require(out, "a creepage");
        const Settings& settings = problem.settings;
        const bool rolls = settings.digits.tangential != 1;
        GivenMotion motion = in_units(settings.motion.value_or(GivenMotion{}), settings.units.length, rolls);
        take_found(problem, motion);
        *vx = settings.units.body * motion.vx;
        *vy = settings.units.body * motion.vy;
        *phi = settings.units.body * motion.phi;
    });
}
CONTACTD_FORTRAN_NAME(cntc_getcreepages)

extern "C" void cntc_getreferencevelocity(int* ire, int* icp, double* veloc) {
    clear(veloc);
    get("cntc_getreferencevelocity", ire, icp, [&](const ProblemCase& problem) {
        require(veloc, "veloc");
        *veloc = problem.settings.velocity.value_or(usual_velocity) / problem.settings.units.length;
    });
}
CONTACTD_FORTRAN_NAME(cntc_getreferencevelocity)
