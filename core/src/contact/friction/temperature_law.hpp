// Computes temperature-dependent friction: how coefficients follow the slip of a solve.
#pragma once

#include <span>
#include <vector>

#include "contactd/contact.hpp"
#include "temperature/row_heat.hpp"

namespace contactd {

/// Holds the motion of each element in the last solve.
struct MotionOfElements {
    std::vector<double> slip_velocity;  ///< (mm/s), >= 0; 0 in adhesion
    std::vector<double> plastic_heat;   ///< heat of a layer that flows (N/(mm s)); empty if none
    std::vector<double> slip_of_rows;   ///< mean relative slip along x in each row, per distance rolled
};

/// Computes coefficients by marching each row from the leading edge. With given slip, the temperature of an element
/// depends on those ahead of it, and on its own heat, which depends on its friction. Therefore, no temperature comes
/// from the previous pass, and friction that decreases steeply does not oscillate. With memory, the coefficients of
/// particles are marched as well.
class TemperatureLaw {
   public:
    /// The problem has temperatures and temperature-dependent friction, and rolls steadily along x. The initial
    /// coefficients are those of surfaces that friction does not heat.
    explicit TemperatureLaw(const ContactProblem& problem);

    /// Returns the coefficients for the next solve, per element.
    const std::vector<double>& mu() const { return mu_; }
    /// Returns whether friction has memory. Coefficients are then not a function of the temperature alone.
    bool has_memory() const;

    /// Updates the coefficients after a solve. Returns their distance from the new ones, weighted with the pressure
    /// (N/mm^2): ||(mu(T) - mu) p|| / ||mu p||, or 0 without contact.
    double follow(const MotionOfElements& motion, std::span<const double> pressure);

   private:
    class Row;

    const TemperatureFriction& law_of(std::size_t row) const { return laws_[laws_.size() == 1 ? 0 : row]; }

    const std::vector<TemperatureFriction> laws_;  // one law, or one per row
    const std::size_t nx_, ny_;
    const bool backwards_;  // whether rolling is along -x, with the leading edge at small x
    const double step_;     // dq over dx
    const double seconds_;  // duration of a step
    const RowHeat heat_;
    std::vector<double> cold_, mu_;
};

/// Solves T = T0 + rise mu(T) for the coefficient mu(T), rise >= 0 (K). If friction increases with the temperature,
/// there may be several solutions; returns that of the lowest temperature.
double coefficient_of_own_heat(const TemperatureFriction& law, double mu, double T0, double rise);

}  // namespace contactd
