// Checks whether the wear of a contact can be computed.
#pragma once

#include <optional>

#include "contactd/contact.hpp"

namespace contactd {

/// Throws InvalidArgument, which names the field as on the wire, if it cannot; never if no wear is requested. Other
/// properties of `problem` are not checked. If it is not `complete`, later steps may add friction.
void check_wear(const ContactProblem& problem, bool complete);

/// Throws InvalidArgument ("model") if the model does not compute the slip of each element.
void check_wear_model(Model model);
/// Throws InvalidArgument ("friction.layer.yield_stress") for a layer that flows.
void check_wear_layer(const std::optional<InterfacialLayer>& layer);

}  // namespace contactd
