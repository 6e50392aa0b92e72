// The nodes by which reference programs look for contacts on a mesh.
#pragma once

#include "geometry/distance/node_mesh.hpp"
#include "geometry/placement/wheel_surface.hpp"

namespace contactd::geometry {

/// Nodes of the wheel's lower part, in the track, with straight lines between. A round wheel has those of its profile's
/// points, on lines that are 1.5 elements apart, an eighth of the radius to both sides; an out-of-round one those of
/// its slices (OutOfRound::node), on lines that are four elements apart, up to 0.2 rad to both sides. Throws
/// InvalidArgument ("dx") as lines_within_bound does.
NodeMesh search_nodes(const WheelSurface& wheel, double dx);

}  // namespace contactd::geometry
