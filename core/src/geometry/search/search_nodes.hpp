// Creates the nodes that reference programs use to search contacts on a mesh.
#pragma once

#include "geometry/distance/node_mesh.hpp"
#include "geometry/placement/wheel_surface.hpp"

namespace contactd::geometry {

/// Returns nodes of the wheel's lower part, in the track, with straight lines between. Nodes of a round wheel are its
/// profile's points, on lines 1.5 elements apart, an eighth of the radius to both sides. Those of an out-of-round wheel
/// are its slices' points (OutOfRound::node), on lines four elements apart, up to 0.2 rad to both sides. Throws
/// InvalidArgument ("dx") as lines_within_bound does.
NodeMesh search_nodes(const WheelSurface& wheel, double dx);

}  // namespace contactd::geometry
