// Estimates that a step of a wheel on its rail leaves to the next one.
#pragma once

#include <optional>
#include <vector>

#include "contactd/contact_load.hpp"
#include "contactd/grid.hpp"

namespace contactd {

/// The logarithm of the vertical force over that which Hertz's theory expects at the same height, a straight line in z.
struct HeightCorrection {
    double logarithm = 0, slope = 0;  ///< (1, 1/mm)
};

/// Where the searches and solvers of a step start. They change what it costs; its answer within the tolerances only.
struct WheelRailEstimates {
    HeightCorrection height{};

    struct Patch {
        Grid grid;
        double y = 0;  ///< of the reference of a right wheel (mm)
        SurfaceState tractions;
    };
    std::vector<Patch> patches{};    ///< of model full
    std::optional<double> rail_y{};  ///< lateral deflection of a flexible rail (mm)
};

}  // namespace contactd
