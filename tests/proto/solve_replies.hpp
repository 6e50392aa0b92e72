// Creates a reply to contact.solve like a solver, on a grid of 3 x 2.
#pragma once

#include "contactd/proto/codec.hpp"

namespace wire {

inline contactd::SolveReply solve_reply() {
    using namespace contactd;
    SolveReply reply;
    ContactSolution& solution = reply.solution;
    solution.approach = 0.02;
    solution.forces.Fn = 9.195402;
    solution.forces.Fx = -3.2216;
    solution.forces.Fy = 1e-17;
    solution.forces.Mz = 1e-3;
    solution.pmax = 4.39;
    solution.area.contact = 3.1;
    solution.area.adhesion = 1.1;
    solution.area.slip = 2.0;
    solution.elements.contact = 3;
    solution.elements.adhesion = 1;
    solution.elements.slip = 2;
    solution.elements.border = 1;
    solution.element_division = {ElementState::exterior, ElementState::adhesion, ElementState::slip,
                                 ElementState::exterior, ElementState::slip,     ElementState::exterior};
    solution.pressure = {0, 1, 2, 0, 3, 0};
    solution.traction_x = {0, -0.1, -0.2, 0, -0.3, 0};
    solution.traction_y = {0, 0.1 + 0.2, 0, 0, 1e-300, 0};
    solution.slip_x = {0, 0, 1e-3, 0, 1.0 / 7, 0};
    solution.slip_y = {0, 0, -1e-3, 0, 0, 0};
    solution.frictional_work = 1.0 / 3;
    solution.motion = Shift{{0.00817, 0}, 0, {}, 1};
    solution.warnings = {"1 contact element lies at the border of the potential contact area."};
    solution.evidence.normal = {12, 3e-7, true, 0.01};
    solution.evidence.tangential = SolverEvidence{40, 2e-3, false, 0.02};
    reply.ics.upper = {"closed_form", "abc", {}};
    reply.ics.upper->evidence.source = "analytic";
    reply.ics.lower = reply.ics.upper;
    reply.ics.lower->key = "def";
    return reply;
}

}  // namespace wire
