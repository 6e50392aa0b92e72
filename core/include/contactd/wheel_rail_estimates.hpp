// What a step of a wheel on its rail leaves to the next one.
#pragma once

#include <optional>
#include <vector>

#include "contactd/contact_load.hpp"
#include "contactd/grid.hpp"
#include "contactd/wheel_rail_solution.hpp"

namespace contactd {

/// The logarithm of the vertical force over that which Hertz's theory expects at the same height, a straight line in z.
struct HeightCorrection {
    double logarithm = 0, slope = 0;  ///< (1, 1/mm)
};

/// Where the searches and solvers of a step start. They change what it costs; its answer within the tolerances only.
/// The tractions are those, too, which a step that is not steady goes on from.
struct WheelRailEstimates {
    HeightCorrection height{};

    struct Patch {
        Grid grid;
        double y = 0;  ///< of the reference of a right wheel (mm)
        RailPlace on_rail;
        double x = 0;  ///< position.x then (mm)
        SurfaceState tractions;
    };
    std::vector<Patch> patches{};    ///< of model full
    std::optional<double> rail_y{};  ///< lateral deflection of a flexible rail (mm)
};

}  // namespace contactd
