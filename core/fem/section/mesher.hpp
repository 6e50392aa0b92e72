// Fills outlines with triangles, by a separate module, contactd-gmsh.so, which is opened when it is first needed.
#pragma once

#include <functional>
#include <string>

#include "triangulation.hpp"

namespace contactd::fem {

using SizeAt = std::function<double(const PlanePoint&)>;

}  // namespace contactd::fem

extern "C" {

/// Fills `outline` with triangles whose edges are as long as `size` specifies. Returns false on failure, with the
/// reason in `problem`. Throws nothing. Not thread-safe.
using FillOutline = bool(const contactd::fem::DividedOutline& outline, const contactd::fem::SizeAt& size,
                         contactd::fem::Triangulation& result, std::string& problem);

/// Declares the function that the module exports.
FillOutline contactd_fill_outline;
}
