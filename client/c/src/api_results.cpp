// contactd.h: the results of the last step.
#include "edge.hpp"

using namespace contactd::c;
using contactd::ContactSolution;
using contactd::SolverEvidence;

namespace {

template <class Body>
std::int32_t read(contactd_contact* contact, const Body& body) {
    return with(contact, [&](Contact& asked) { body(asked.result().reply.solution); });
}

template <class Motion>
const Motion& motion_of(const ContactSolution& solution, const char* what) {
    const Motion* motion = solution.motion ? std::get_if<Motion>(&*solution.motion) : nullptr;
    if (motion == nullptr) throw nothing_of(what);
    return *motion;
}

/// Null when it did not run.
const SolverEvidence* evidence_of(const ContactSolution& solution, std::int32_t solver) {
    const contactd::ContactEvidence& all = solution.evidence;
    if (solver == CONTACTD_NORMAL) return &all.normal;
    const auto& some = solver == CONTACTD_TANGENTIAL ? all.tangential
                       : solver == CONTACTD_OUTER    ? all.outer
                                                     : all.force;
    return some ? &*some : nullptr;
}

}  // namespace

std::int32_t contactd_get_step(contactd_contact* contact, std::int32_t* step) {
    return with(contact, [&](Contact& asked) {
        given(step, "step");
        *step = asked.step_number();
    });
}

std::int32_t contactd_get_forces(contactd_contact* contact, double* Fn, double* Fx, double* Fy, double* Mz) {
    return read(contact, [&](const ContactSolution& solution) {
        given(Fn, "Fn"), given(Fx, "Fx"), given(Fy, "Fy"), given(Mz, "Mz");
        *Fn = solution.forces.Fn;
        *Fx = solution.forces.Fx;
        *Fy = solution.forces.Fy;
        *Mz = solution.forces.Mz;
    });
}

std::int32_t contactd_get_approach(contactd_contact* contact, double* approach) {
    return read(contact, [&](const ContactSolution& solution) { *given(approach, "approach") = solution.approach; });
}

std::int32_t contactd_get_pmax(contactd_contact* contact, double* pmax) {
    return read(contact, [&](const ContactSolution& solution) { *given(pmax, "pmax") = solution.pmax; });
}

std::int32_t contactd_get_areas(contactd_contact* contact, double* in_contact, double* adhesion, double* slip) {
    return read(contact,
                [&](const ContactSolution& solution) { put_areas(solution.area, in_contact, adhesion, slip); });
}

std::int32_t contactd_get_counts(contactd_contact* contact, std::int32_t* in_contact, std::int32_t* adhesion,
                                 std::int32_t* slip, std::int32_t* border) {
    return read(contact, [&](const ContactSolution& solution) {
        put_counts(solution.elements, in_contact, adhesion, slip, border);
    });
}

std::int32_t contactd_get_creepages(contactd_contact* contact, double* xi, double* eta, double* phi) {
    return read(contact, [&](const ContactSolution& solution) {
        given(xi, "xi"), given(eta, "eta"), given(phi, "phi");
        const auto& rolling = motion_of<contactd::Rolling>(solution, "creepages: nothing rolled, or without friction");
        *xi = rolling.xi;
        *eta = rolling.eta;
        *phi = rolling.phi;
    });
}

std::int32_t contactd_get_shift(contactd_contact* contact, double* x, double* y, double* rotation) {
    return read(contact, [&](const ContactSolution& solution) {
        given(x, "x"), given(y, "y"), given(rotation, "rotation");
        const auto& shift = motion_of<contactd::Shift>(solution, "shift: the bodies rolled, or there was no friction");
        *x = shift.rigid_shift.x;
        *y = shift.rigid_shift.y;
        *rotation = shift.rotation;
    });
}

std::int32_t contactd_get_frictional_work(contactd_contact* contact, double* work) {
    return read(contact, [&](const ContactSolution& solution) {
        given(work, "work");
        if (!solution.frictional_work) throw nothing_of("frictional work: the bodies rolled, or there was no friction");
        *work = *solution.frictional_work;
    });
}

std::int32_t contactd_get_frictional_power(contactd_contact* contact, double* power) {
    return read(contact, [&](const ContactSolution& solution) {
        given(power, "power");
        if (!solution.frictional_power) throw nothing_of("frictional power: nothing rolled, or without friction");
        *power = *solution.frictional_power;
    });
}

std::int32_t contactd_get_converged(contactd_contact* contact, std::int32_t* converged) {
    return read(contact, [&](const ContactSolution& solution) {
        *given(converged, "converged") = solution.converged() ? 1 : 0;
    });
}

std::int32_t contactd_get_evidence(contactd_contact* contact, std::int32_t solver, std::int32_t* iterations,
                                   double* residual, std::int32_t* converged) {
    return read(contact, [&](const ContactSolution& solution) {
        given(iterations, "iterations"), given(residual, "residual"), given(converged, "converged");
        const SolverEvidence* evidence = evidence_of(solution, word(solver, CONTACTD_FORCE, "solver"));
        if (evidence == nullptr) throw nothing_of("evidence of this solver: it did not run");
        *iterations = evidence->iterations;
        *residual = evidence->residual;
        *converged = evidence->converged ? 1 : 0;
    });
}

std::int32_t contactd_get_discretisation(contactd_contact* contact, std::int32_t* elements_across, double* force_error,
                                         double* pmax_error, double* rolling_error) {
    return read(contact, [&](const ContactSolution& solution) {
        given(elements_across, "elements_across"), given(force_error, "force_error");
        given(pmax_error, "pmax_error"), given(rolling_error, "rolling_error");
        const auto& errors = solution.evidence.discretisation;
        if (!errors) throw nothing_of("discretisation: a quick model solved it, or there was no contact");
        *elements_across = errors->elements_across;
        *force_error = errors->force_error;
        *pmax_error = errors->pmax_error;
        *rolling_error = errors->rolling_error.value_or(0);
    });
}

std::int32_t contactd_get_warnings(contactd_contact* contact, std::int32_t* count) {
    return read(contact, [&](const ContactSolution& solution) {
        *given(count, "count") = static_cast<std::int32_t>(solution.warnings.size());
    });
}

std::int32_t contactd_get_warning(contactd_contact* contact, std::int32_t index, char* text, std::int32_t length) {
    return read(contact, [&](const ContactSolution& solution) { put_warning(solution.warnings, index, text, length); });
}

std::int32_t contactd_get_origin(contactd_contact* contact, std::int32_t body, char* text, std::int32_t length) {
    return with(contact, [&](Contact& asked) {
        word(body, CONTACTD_PAIR, "body");
        const contactd::IcUses& uses = asked.ics();
        const auto& use = body == CONTACTD_UPPER ? uses.upper : body == CONTACTD_LOWER ? uses.lower : uses.pair;
        if (body == CONTACTD_BOTH || !use)
            throw contactd::StatusError(contactd::StatusCode::not_found, no_result,
                                        "There are no coefficients of that body.");
        put_text(use->origin, text, length);
    });
}
