// Defines two numbers, along x and along y.
#pragma once

#include <Eigen/Core>

namespace contactd {

using Pair = Eigen::Vector2d;

}  // namespace contactd
