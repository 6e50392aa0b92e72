// The models that the flags B and M ask for.
#pragma once

#include <optional>
#include <string>

#include "contactd/contact_setup.hpp"
#include "contactd/material.hpp"
#include "given/given.hpp"

namespace contactd::cases {

struct CaseModels {
    Model model = Model::full;
    NormalModel normal_model = NormalModel::of_model;
    SimplifiedSettings simplified{};
};

/// FASTSIM goes in whole elements, with blended flexibilities and the printed coefficients, as the other program has
/// it. Throws NotCovered for a bound of 2 or 3 without a simplified theory, and for a simplified theory that has no
/// such bound.
CaseModels models_of(const Given& settings);

/// Returns the materials to solve with: the combined one for both bodies if Dundurs' constant K is below 1e-4, where
/// the other program treats bodies as quasi-identical.
MaterialPair solved_materials(const MaterialPair& given);

/// The layer between the bodies, where the flag of materials asks for one; else none.
std::optional<InterfacialLayer> layer_of(const Given& settings);

/// Takes the memory from the friction of a simplified theory, which has one coefficient for the whole contact.
void forget_memory(std::optional<KineticFriction>& kinetic, Model model);
/// Names a memory that has no effect; empty: there is none.
std::string warning_of_memory(const Given& settings);

}  // namespace contactd::cases
