// Defines valid elements for finite-element tables of longitudinally uniform bodies.
#pragma once

namespace contactd {

/// dx must be at least this fraction of the width of a strip for stated errors. Shorter elements excite waves that
/// strips and meshes of their size do not resolve.
inline constexpr double shortest_uniform_element = 0.5;

}  // namespace contactd
