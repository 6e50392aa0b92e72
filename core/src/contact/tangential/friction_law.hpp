// Defines velocity-weakening (falling) friction: the law, and how coefficients follow the slip that they cause.
#pragma once

#include <span>
#include <vector>

#include "contactd/friction.hpp"
#include "friction_memory.hpp"

namespace contactd {

/// Iterates the coefficients of friction towards the slip that they cause. Every element is relaxed by its own secant,
/// because falling friction would overshoot: less friction, more slip, less friction.
class SlipLawIteration {
   public:
    /// Starts with one static coefficient per element, or with the kinetic one (KineticFriction::start).
    SlipLawIteration(const KineticFriction& kinetic, std::span<const double> mu_static);

    /// Sets the memory of friction, which must outlive this object. Its carried coefficients then replace those of the
    /// law.
    void carry(const CarriedFriction& memory) { memory_ = &memory; }

    /// Returns the coefficients for the next solve, per element.
    const std::vector<double>& mu() const { return mu_; }

    /// Updates the coefficients for the slip velocities (mm/s, >= 0) of the last solve. Returns their distance from
    /// those of the law, weighted with the pressure (N/mm^2): ||(mu(v) - mu) p|| / ||mu_s p||, or 0 without contact.
    double follow(std::span<const double> slip_velocity, std::span<const double> pressure);

   private:
    KineticFriction kinetic_;
    const CarriedFriction* memory_ = nullptr;
    std::vector<double> static_, mu_, last_mu_, last_error_;
    bool is_first_ = true;
};

}  // namespace contactd
