// contactd.h: the results of the last solve of a wheel on its rail.
#include <algorithm>
#include <array>

#include "edge.hpp"

using namespace contactd::c;
using contactd::SolverEvidence;
using contactd::WheelRailForces;
using contactd::WheelRailSolution;
using contactd::Wrench;

namespace {

template <class Body>
std::int32_t read(contactd_wheel* wheel, const Body& body) {
    return with(wheel, [&](Wheel& asked) { body(asked.solution()); });
}

void put(const Wrench& wrench, double* forces) {
    const std::array all{wrench.Fx, wrench.Fy, wrench.Fz, wrench.Mx, wrench.My, wrench.Mz};
    std::ranges::copy(all, given(forces, "forces"));
}

const Wrench& wrench_of(const WheelRailForces& forces, std::int32_t coordinates) {
    const std::array<const Wrench*, 3> all{&forces.track, &forces.rail, &forces.wheelset};
    return *all[static_cast<std::size_t>(word(coordinates, CONTACTD_IN_WHEELSET, "coordinates"))];
}

const Wrench& wrench_of(const contactd::WheelRailDerivatives& derivatives, std::int32_t by) {
    const auto& [position, velocity] = derivatives;
    const std::array<const Wrench*, 10> all{&position.y, &position.z, &position.roll, &position.yaw, &velocity.x,
                                            &velocity.y, &velocity.z, &velocity.roll, &velocity.yaw, &velocity.pitch};
    return *all[static_cast<std::size_t>(by)];
}

}  // namespace

std::int32_t contactd_wheel_get_motion(contactd_wheel* wheel, double* z, double* pitch) {
    return read(wheel, [&](const WheelRailSolution& solution) {
        given(z, "z"), given(pitch, "pitch");
        *z = solution.z;
        *pitch = solution.pitch;
    });
}

std::int32_t contactd_wheel_get_clearance(contactd_wheel* wheel, double* clearance) {
    return read(wheel, [&](const WheelRailSolution& solution) {
        given(clearance, "clearance");
        if (!solution.clearance) throw nothing_of("clearance: no part of the wheel is above the rail");
        *clearance = *solution.clearance;
    });
}

std::int32_t contactd_wheel_get_forces(contactd_wheel* wheel, std::int32_t coordinates, double* forces) {
    return read(wheel,
                [&](const WheelRailSolution& solution) { put(wrench_of(solution.forces, coordinates), forces); });
}

std::int32_t contactd_wheel_get_derivative(contactd_wheel* wheel, std::int32_t by, double* forces) {
    return read(wheel, [&](const WheelRailSolution& solution) {
        word(by, CONTACTD_BY_VELOCITY_PITCH, "by");
        given(forces, "forces");
        if (!solution.derivatives)
            throw nothing_of("derivatives: they were not wanted, or there is no contact, or it did not converge");
        put(wrench_of(*solution.derivatives, by), forces);
    });
}

std::int32_t contactd_wheel_get_converged(contactd_wheel* wheel, std::int32_t* converged) {
    return with(wheel, [&](Wheel& asked) { *given(converged, "converged") = asked.converged() ? 1 : 0; });
}

std::int32_t contactd_wheel_get_evidence(contactd_wheel* wheel, std::int32_t solver, std::int32_t* iterations,
                                         double* residual, std::int32_t* converged) {
    return with(wheel, [&](Wheel& asked) {
        given(iterations, "iterations"), given(residual, "residual"), given(converged, "converged");
        if (word(solver, CONTACTD_RAIL_SHIFT, "solver") < CONTACTD_FORCE)
            throw contactd::InvalidArgument("solver", "is " + std::to_string(solver) +
                                                          "; it must be CONTACTD_FORCE, CONTACTD_PITCH, "
                                                          "CONTACTD_ROLL or CONTACTD_RAIL_SHIFT");
        const std::array<const std::optional<SolverEvidence>*, 4> searches{
            &asked.solution().force, &asked.solution().pitch_search, &asked.roll_search(),
            &asked.solution().rail_search};
        const std::optional<SolverEvidence>& search = *searches[static_cast<std::size_t>(solver - CONTACTD_FORCE)];
        if (!search) throw nothing_of("evidence of this search: it did not run");
        *iterations = search->iterations;
        *residual = search->residual;
        *converged = search->converged ? 1 : 0;
    });
}

std::int32_t contactd_wheel_get_warnings(contactd_wheel* wheel, std::int32_t* count) {
    return read(wheel, [&](const WheelRailSolution& solution) {
        *given(count, "count") = static_cast<std::int32_t>(solution.warnings.size());
    });
}

std::int32_t contactd_wheel_get_warning(contactd_wheel* wheel, std::int32_t index, char* text, std::int32_t length) {
    return read(wheel, [&](const WheelRailSolution& solution) { put_warning(solution.warnings, index, text, length); });
}

std::int32_t contactd_wheel_get_patches(contactd_wheel* wheel, std::int32_t* count) {
    return read(wheel, [&](const WheelRailSolution& solution) {
        *given(count, "count") = static_cast<std::int32_t>(solution.patches.size());
    });
}

std::int32_t contactd_wheel_get_patch_forces(contactd_wheel* wheel, std::int32_t patch, std::int32_t coordinates,
                                             double* forces) {
    return with(wheel, [&](Wheel& asked) { put(wrench_of(asked.patch(patch).forces, coordinates), forces); });
}
