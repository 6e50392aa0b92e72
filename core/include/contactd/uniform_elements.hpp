// Which elements the tables of longitudinally uniform bodies by finite elements serve.
#pragma once

namespace contactd {

/// dx over the width of a strip from which on errors are stated. Shorter elements feel waves that strips and meshes
/// of their size do not resolve.
inline constexpr double shortest_uniform_element = 0.5;

}  // namespace contactd
