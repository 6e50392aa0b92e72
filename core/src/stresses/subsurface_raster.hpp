// Computes subsurface stresses at points that differ by whole elements by convolutions, depth by depth.
#pragma once

#include <array>
#include <vector>

#include "contactd/observer.hpp"
#include "patch_field.hpp"

namespace contactd {

/// Holds a rectangle of elements with the traction along one axis, shape [ny, nx].
struct TractionPatch {
    int nx, ny;
    double dx, dy;
    std::vector<double> values;
};

/// Describes points (k + offset_x) dx, (l + offset_y) dy from the centre of the first element of the patch, k =
/// 0..nx-1, l = 0..ny-1.
struct Raster {
    int nx, ny;
    double offset_x, offset_y;
};

/// Adds the field at depth d to `sum`, each of whose arrays has the shape [ny, nx] of the raster. Throws Cancelled if
/// the observer, which is called for each row, cancels.
void add_field(const StressField& field, Axis load, const TractionPatch& patch, const Raster& raster, double d,
               std::array<std::vector<double>, 6>& sum, const Observer& observer);
void add_field(const DisplacementField& field, Axis load, const TractionPatch& patch, const Raster& raster, double d,
               std::array<std::vector<double>, 3>& sum, const Observer& observer);

}  // namespace contactd
