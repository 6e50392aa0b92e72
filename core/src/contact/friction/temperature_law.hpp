// Friction by the temperature of the surfaces: how coefficients follow the slip of a solve.
#pragma once

#include <span>
#include <vector>

#include "contactd/contact.hpp"
#include "temperature/row_heat.hpp"

namespace contactd {

/// The motion of each element in the last solve.
struct MotionOfElements {
    std::vector<double> slip_velocity;  ///< (mm/s), >= 0; 0 in adhesion
    std::vector<double> plastic_heat;   ///< of a layer that flows (N/(mm s)); empty: none
    std::vector<double> slip_of_rows;   ///< mean relative slip along x in each row, per distance rolled
};

/// With given slip the temperature of an element follows from those ahead of it, and from its own heat, which its
/// friction makes. So each row is marched from the leading edge, and no temperature is one of the pass before: friction
/// that falls steeply does not oscillate. With memory the coefficients that particles carry are marched along.
class TemperatureLaw {
   public:
    /// The problem has a temperature and friction by it, and rolls steadily along x; starts with the coefficients of
    /// surfaces that no friction heats.
    explicit TemperatureLaw(const ContactProblem& problem);

    /// For the next solve, per element.
    const std::vector<double>& mu() const { return mu_; }
    /// Returns whether particles carry their coefficients, which are then no function of the temperature alone.
    bool has_memory() const;

    /// Follows the last solve. Returns how far the coefficients were from what they become, weighted with the pressure
    /// (N/mm^2): ||(mu(T) - mu) p|| / ||mu p||, 0 where there is no contact.
    double follow(const MotionOfElements& motion, std::span<const double> pressure);

   private:
    class Row;

    const TemperatureFriction& law_of(std::size_t row) const { return laws_[laws_.size() == 1 ? 0 : row]; }

    const std::vector<TemperatureFriction> laws_;  // one, or one a row
    const std::size_t nx_, ny_;
    const bool backwards_;  // rolling along -x: the leading edge is that of small x
    const double step_;     // dq over dx
    const double seconds_;  // of a step
    const RowHeat heat_;
    std::vector<double> cold_, mu_;
};

/// Solves T = T0 + rise mu(T) for the coefficient mu(T), rise >= 0 (K): of several solutions, which friction that rises
/// with the temperature may have, the coldest.
double coefficient_of_own_heat(const TemperatureFriction& law, double mu, double T0, double rise);

}  // namespace contactd
