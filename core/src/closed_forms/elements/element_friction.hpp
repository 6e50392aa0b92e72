// Solves rolling by the models of vehicle codes: FASTSIM on elements, FaStrip, Polach.
#pragma once

#include <string>
#include <vector>

#include "closed_forms/forces_by_motion.hpp"
#include "element_patch.hpp"

namespace contactd {

/// Returns whether FASTSIM uses whole elements: for velocity-weakening friction, a reduced slope, an elliptic bound,
/// blended or printed flexibilities, or if requested.
bool needs_elements(const ContactSetup& setup);

/// Returns whether this file solves the rolling model of this set-up.
bool rolls_on_elements(const ContactSetup& setup);

/// Solves steady rolling of `problem` on a patch, with one coefficient of friction. Velocity-weakening friction depends
/// on the velocity V sqrt(xi^2 + eta^2) of the whole contact. Forces, areas and power are sums over elements. Polach
/// yields only forces, without tractions and moment, and the whole contact counts as slip. Motions are searched for
/// prescribed forces. Adds warnings. Throws InvalidArgument ("friction.rolling.chi", "friction.rolling.force", "gap").
EllipticFriction element_friction(const ContactProblem& problem, const ElementPatch& patch,
                                  std::vector<std::string>& warnings);

/// Differentiates the forces at known creepages. `patch` is not empty, and mu > 0 is constant.
ForcesByMotion element_friction_by_motion(const ContactProblem& problem, const ElementPatch& patch,
                                          const Rolling& rolling);

}  // namespace contactd
