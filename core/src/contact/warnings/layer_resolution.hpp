// Checks the resolution of layers by elements: a wide element deforms a thin incompressible layer only at its rim.
#pragma once

#include <optional>
#include <string>

#include "contactd/contact_setup.hpp"

namespace contactd {

/// Holds lengths along x and y (mm), such as those of a contact.
struct PatchSize {
    double along_x = 0, along_y = 0;
};

/// Returns the compliance of both bodies that elements of the grid give for a contact of this size, relative to the
/// exact compliance. Returns 1 for fine elements, and nothing if neither body has layers. The pressures are a wave with
/// the curvature of (1 - (r/a)^2)^2 at its middle. Uniform elements, or hat functions, add waves shorter than an
/// element. The result excludes the error that half-spaces and foundations of springs have on any grid.
std::optional<double> compliance_ratio(const ContactSetup& setup, const PatchSize& contact);

/// Returns the relative error of the normal force for an approach, and of the largest pressure, at such a ratio.
double compliance_error(double ratio);

/// Returns a warning if these elements, or elements down to half their width, have an error of 1 % or more. Coarse
/// elements whose error happens to be smaller than that of finer ones are therefore reported, too.
std::optional<std::string> layer_warning(const ContactSetup& setup, const PatchSize& contact);

/// Throws InvalidArgument for "grid.dx" or "grid.dy", the longer one, if the compliance is wrong by a factor of two or
/// more.
void require_layers_resolved(const ContactSetup& setup, const PatchSize& contact);
/// Checks before a solve, and throws only if it holds for every contact on the grid. Smaller contacts are less precise.
void require_layers_resolved(const ContactSetup& setup);

}  // namespace contactd
