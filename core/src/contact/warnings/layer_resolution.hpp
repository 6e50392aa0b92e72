// How elements see the waves of layers: one that is wide beside an incompressible layer loads it only at its rim.
#pragma once

#include <optional>
#include <string>

#include "contactd/contact_setup.hpp"

namespace contactd {

/// Lengths along x and y (mm), such as those of a contact.
struct PatchSize {
    double along_x = 0, along_y = 0;
};

/// Compliance of both bodies to pressures in a contact of this size as elements of the grid give it, over that of the
/// bodies themselves; 1 where elements are fine. Nothing where neither body has layers. The pressures are a wave with
/// the curvature that (1 - (r/a)^2)^2 has at its middle; uniform elements, or hat functions, add waves that are shorter
/// than an element. What half-spaces and foundations of springs err by, too, is left out, since it is an error of any
/// grid.
std::optional<double> compliance_ratio(const ContactSetup& setup, const PatchSize& contact);

/// Returns the relative error that such a ratio causes in the normal force for an approach, and in the largest
/// pressure.
double compliance_error(double ratio);

/// A sentence from an error of 1 % on, of these elements or of some that are up to half as wide: where coarser elements
/// happen to err less than finer ones, they are not to be trusted more.
std::optional<std::string> layer_warning(const ContactSetup& setup, const PatchSize& contact);

/// Throws InvalidArgument "grid.dx" or "grid.dy", the longer one, where the compliance is off by a factor of two or
/// more, so that the elements say nothing of the layers.
void require_layers_resolved(const ContactSetup& setup, const PatchSize& contact);
/// Checks before a solve, where it holds of every contact on the grid. Smaller ones are less precise.
void require_layers_resolved(const ContactSetup& setup);

}  // namespace contactd
