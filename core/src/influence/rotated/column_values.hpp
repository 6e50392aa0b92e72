// The nine coefficients between two columns, and what turning their axes does to them.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "contactd/section.hpp"

namespace contactd {

/// Displacement along i for a load along j at [3 i + j]; axes x, s, n, as Axis counts them.
using NineValues = std::array<double, 9>;

/// The position of a column as another one's half-space sees it: the normal of the half-space lies midway between the
/// normals of both.
struct ColumnView {
    double s = 0;     ///< of the observed column from the loaded one, along the surface (mm)
    double turn = 0;  ///< angle of the observed column's normal less that of the loaded one's, in (-pi, pi] (rad)
};

/// Columns are of arc length ds, side by side. On a closed curve (`perimeter` > 0) the shorter way counts.
ColumnView view_of(std::span<const ColumnFrame> frames, double ds, double perimeter, int observed, int loaded);

/// Coefficients in the axes of both columns from those in the axes midway between them: displacements are taken along
/// axes turned by turn/2, loads along those turned by -turn/2 (Blanco-Lorenzo et al., 2016).
NineValues in_column_axes(const NineValues& midway, double turn);

}  // namespace contactd
