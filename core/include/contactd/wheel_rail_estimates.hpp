// What a step of a wheel on its rail leaves to the next one.
#pragma once

#include <cmath>
#include <cstddef>
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

/// A number that changes little from step to step.
class Trend {
   public:
    /// Returns what was learnt in this step, or what the step has if it changes as in those before; none where nothing
    /// is known.
    const std::optional<double>& expected() const { return expected_; }
    /// None: the step has no such number.
    void learn(std::optional<double> value) { expected_ = value; }
    /// The step ends with what was learnt last.
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
    static constexpr double largest_change = 0.05;  // of a step: beyond, the number has jumped, and says no more
    std::optional<double> expected_, last_, before_, before_that_;
};

/// Where the searches and solvers of a step start. They change what it costs; its answer within the tolerances only.
/// The tractions are those, too, which a step that is not steady goes on from.
struct WheelRailEstimates {
    HeightCorrection height{};
    Trend height_logarithm{};  ///< of the correction at the height that was found
    Trend vertical_share{};    ///< Fz over the normal force of the only patch, which friction has a part in

    struct Patch {
        Grid grid;
        double y = 0;  ///< of the reference of a right wheel (mm)
        RailPlace on_rail;
        double x = 0;  ///< position.x then (mm)
        SurfaceState tractions;
    };
    std::vector<Patch> patches{};          ///< of model full
    std::optional<double> rail_y{};        ///< lateral deflection of a flexible rail (mm)
    std::optional<double> slip{};          ///< the pitch rate that brings Fx, over that without creepage, less 1
    std::vector<double> balance_slopes{};  ///< derivatives of the forces that both balance, row by row
    std::size_t regions = 0;               ///< of overlap, in all patches; 0: not known

    void end_step() {
        height_logarithm.end_step();
        vertical_share.end_step();
    }
};

/// What a step of a wheelset that is free to roll leaves to the next one.
struct WheelsetEstimates {
    WheelRailEstimates left{}, right{};
    Trend roll{};  ///< (rad)
};

}  // namespace contactd
