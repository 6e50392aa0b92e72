// Selects the models for the digits B and M.
#pragma once

#include <array>
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

/// Returns the models. FASTSIM steps by whole elements, with blended flexibilities and the printed coefficients, as in
/// CONTACT. Throws NotCovered for FaStrip with a parabolic bound.
CaseModels models_of(const Given& settings);

/// Returns the materials for the solve: the combined material for both bodies if Dundurs' constant K is below 1e-4, for
/// which CONTACT treats bodies as quasi-identical.
MaterialPair solved_materials(const MaterialPair& given);

/// Returns the layer between the bodies if the digit M requests one.
std::optional<InterfacialLayer> layer_of(const Given& settings);

/// Returns the creep of the bodies if the digit M requests viscoelastic ones.
std::optional<std::array<Viscoelasticity, 2>> creep_of(const Given& settings);

/// Removes the memory of friction in a simplified theory, which uses one coefficient for the whole contact.
void forget_memory(std::optional<KineticFriction>& kinetic, Model model);
/// Returns a warning about a memory that has no effect, or an empty string.
std::string warning_of_memory(const Given& settings);

}  // namespace contactd::cases
