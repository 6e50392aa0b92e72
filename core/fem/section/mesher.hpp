// Fills outlines with triangles: a module of its own, contactd-gmsh.so, that is opened when it is first needed.
#pragma once

#include <functional>
#include <string>

#include "triangulation.hpp"

namespace contactd::fem {

using SizeAt = std::function<double(const PlanePoint&)>;

}  // namespace contactd::fem

extern "C" {

/// Fills `outline` with triangles as long as `size` says. False when that fails, with the reason in `problem`; throws
/// nothing. Not for use by several threads.
using FillOutline = bool(const contactd::fem::DividedOutline& outline, const contactd::fem::SizeAt& size,
                         contactd::fem::Triangulation& result, std::string& problem);

/// The function that the module exports.
FillOutline contactd_fill_outline;
}
