// Solves the transposed equations of a frozen contact for several outputs.
#pragma once

#include <vector>

#include "contact/derivatives/frozen_contact.hpp"
#include "contactd/observer.hpp"
#include "output_weights.hpp"

namespace contactd {

// Holds derivatives of an output with respect to the undeformed distance (with the opposite sign), the bounds of the
// tractions and the slip of each element, on the whole grid; zero outside the contact.
struct Adjoint {
    std::vector<double> normal;  // l; dJ/dh = -l
    std::vector<double> bound;   // dJ/dg at constant pressures
    Field slip;                  // v = dJ/ds, of the rigid slip in mm
};

struct Adjoints {
    std::vector<Adjoint> outputs;
    SolverEvidence evidence;
};

// `contact` holds the transposed equations. There is at least one output.
Adjoints solve_adjoints(FrozenContact& contact, const std::vector<OutputWeights>& outputs, bool has_friction,
                        const Observer& observer);

}  // namespace contactd
