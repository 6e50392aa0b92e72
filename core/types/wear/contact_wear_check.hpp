// Checks whether the wear of a contact is known.
#pragma once

#include <optional>

#include "contactd/contact.hpp"

namespace contactd {

/// Throws InvalidArgument naming the field as on the wire; nothing where no wear is wanted. `problem` is checked
/// otherwise; where it is not `complete` later steps may bring friction.
void check_wear(const ContactProblem& problem, bool complete);

/// Throws InvalidArgument ("model") where the model does not tell the slip of each element.
void check_wear_model(Model model);
/// Throws InvalidArgument ("friction.layer.yield_stress") for a layer that flows.
void check_wear_layer(const std::optional<InterfacialLayer>& layer);

}  // namespace contactd
