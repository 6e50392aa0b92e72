// contactd.h: the results of the last step.
#include <algorithm>
#include <limits>

#include "edge.hpp"

using namespace contactd::c;
using contactd::ContactSolution;
using contactd::SolutionField;
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

const std::vector<double>& array_of(const ContactSolution& solution, SolutionField field) {
    switch (field) {
        case SolutionField::pressure:
            return solution.pressure;
        case SolutionField::traction_x:
            return solution.traction_x;
        case SolutionField::traction_y:
            return solution.traction_y;
        case SolutionField::slip_x:
            return solution.slip_x;
        default:
            return solution.slip_y;
    }
}

/// Of an array that is read into `length` values.
void check_array(const Contact& contact, SolutionField field, std::int32_t length) {
    const std::vector<SolutionField>& wanted = contact.result().fields;
    if (std::find(wanted.begin(), wanted.end(), field) == wanted.end())
        throw contactd::StatusError(contactd::StatusCode::failed_precondition, no_result,
                                    "The last step did not bring this array along; contactd_want asks for it before.");
    const std::size_t size = contact.said.problem.grid.size();
    if (length < 0 || static_cast<std::size_t>(length) != size)
        throw contactd::InvalidArgument(
            "length", "is " + std::to_string(length) + "; the grid has " + std::to_string(size) + " elements");
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
    return read(contact, [&](const ContactSolution& solution) {
        given(in_contact, "in_contact"), given(adhesion, "adhesion"), given(slip, "slip");
        *in_contact = solution.area.contact;
        *adhesion = solution.area.adhesion;
        *slip = solution.area.slip;
    });
}

std::int32_t contactd_get_counts(contactd_contact* contact, std::int32_t* in_contact, std::int32_t* adhesion,
                                 std::int32_t* slip, std::int32_t* border) {
    return read(contact, [&](const ContactSolution& solution) {
        given(in_contact, "in_contact"), given(adhesion, "adhesion"), given(slip, "slip"), given(border, "border");
        *in_contact = solution.elements.contact;
        *adhesion = solution.elements.adhesion;
        *slip = solution.elements.slip;
        *border = solution.elements.border;
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
    return read(contact, [&](const ContactSolution& solution) {
        if (index < 0 || static_cast<std::size_t>(index) >= solution.warnings.size())
            throw contactd::InvalidArgument("index", "is " + std::to_string(index) + "; there are " +
                                                         std::to_string(solution.warnings.size()) + " warnings");
        put_text(solution.warnings[static_cast<std::size_t>(index)], text, length);
    });
}

std::int32_t contactd_get_array(contactd_contact* contact, std::int32_t array, double* values, std::int32_t length) {
    return with(contact, [&](Contact& asked) {
        given(values, "values");
        if (word(array, CONTACTD_SLIP_Y, "array") == CONTACTD_DIVISION)
            throw contactd::InvalidArgument("array", "is CONTACTD_DIVISION; contactd_get_division reads it");
        const auto field = static_cast<SolutionField>(array);
        check_array(asked, field, length);
        const std::vector<double>& source = array_of(asked.result().reply.solution, field);
        std::fill_n(values, length, 0.0);  // slip without friction
        std::copy(source.begin(), source.end(), values);
    });
}

std::int32_t contactd_get_division(contactd_contact* contact, std::int32_t* division, std::int32_t length) {
    return with(contact, [&](Contact& asked) {
        given(division, "division");
        check_array(asked, SolutionField::element_division, length);
        const auto& source = asked.result().reply.solution.element_division;
        std::transform(source.begin(), source.end(), division,
                       [](contactd::ElementState state) { return static_cast<std::int32_t>(state); });
    });
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
