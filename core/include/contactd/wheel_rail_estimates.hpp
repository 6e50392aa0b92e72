// Keeps estimates from a step of a wheel on its rail for the next one.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "contactd/contact_load.hpp"
#include "contactd/grid.hpp"
#include "contactd/wheel_rail_solution.hpp"

namespace contactd {

/// Describes the logarithm of the vertical force over that of Hertz's theory at the same height as a linear function of
/// z.
struct HeightCorrection {
    double logarithm = 0, slope = 0;  ///< (1, 1/mm)
};

/// Extrapolates a number that changes slowly from step to step.
class Trend {
   public:
    /// Returns the value learnt in this step, or else one extrapolated from earlier steps, or nothing if none is known.
    const std::optional<double>& expected() const { return expected_; }
    /// Sets the value, or unsets it if the step does not have it.
    void learn(std::optional<double> value) { expected_ = value; }
    /// Ends the step with the value learnt last.
    void end_step() {
        const bool goes_on = expected_ && last_ && std::abs(*expected_ - *last_) <= largest_change;
        before_that_ = goes_on ? before_ : std::nullopt;
        before_ = goes_on ? last_ : std::nullopt;
        last_ = expected_;
        if (before_that_)
            expected_ = 3 * (*last_ - *before_) + *before_that_;
        else if (before_)
            expected_ = 2 * *last_ - *before_;
    }

   private:
    static constexpr double largest_change = 0.05;  // in a step: a larger change is a jump and is not extrapolated
    std::optional<double> expected_, last_, before_, before_that_;
};

/// Holds starts of the searches and solvers of a step. They affect its cost, and its answer only within the tolerances.
/// A step that is not steady continues from the tractions.
struct WheelRailEstimates {
    HeightCorrection height{};
    Trend height_logarithm{};  ///< correction at the computed height
    Trend vertical_share{};    ///< Fz over the normal force of the only patch, including friction

    struct Patch {
        Grid grid;
        double y = 0;  ///< position of the reference of a right wheel (mm)
        RailPlace on_rail;
        double x = 0;  ///< position.x at that time (mm)
        SurfaceState tractions;
    };
    std::vector<Patch> patches{};          ///< of model full
    std::optional<double> rail_y{};        ///< lateral deflection of a flexible rail (mm)
    std::optional<double> slip{};          ///< the pitch rate that produces Fx, over that without creepage, minus 1
    std::vector<double> balance_slopes{};  ///< derivatives of the forces with respect to both, row by row
    std::size_t regions = 0;               ///< number of regions of overlap, in all patches; 0: unknown

    void end_step() {
        height_logarithm.end_step();
        vertical_share.end_step();
    }
};

/// Keeps estimates from a step of a wheelset with free roll for the next one.
struct WheelsetEstimates {
    WheelRailEstimates left{}, right{};
    Trend roll{};  ///< (rad)
};

}  // namespace contactd
