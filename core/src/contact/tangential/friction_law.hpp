// Velocity-weakening (falling) friction: the law, and how coefficients follow the slip that they cause.
#pragma once

#include <span>
#include <vector>

#include "contactd/friction.hpp"
#include "friction_memory.hpp"

namespace contactd {

/// The coefficients of friction on their way to the slip they cause. Every element is relaxed by a secant of its own,
/// because falling friction would overshoot: less friction, more slip, less friction.
class SlipLawIteration {
   public:
    /// One static coefficient per element; starts with these, or with the kinetic one (KineticFriction::start).
    SlipLawIteration(const KineticFriction& kinetic, std::span<const double> mu_static);

    /// With memory: what particles carry, which outlives this, in place of what the law asks for.
    void carry(const CarriedFriction& memory) { memory_ = &memory; }

    /// For the next solve, per element.
    const std::vector<double>& mu() const { return mu_; }

    /// Follows the slip velocities (mm/s, >= 0) of the last solve. Returns how far the coefficients were from those the
    /// law asks for, weighted with the pressure (N/mm^2): ||(mu(v) - mu) p|| / ||mu_s p||, 0 where there is no contact.
    double follow(std::span<const double> slip_velocity, std::span<const double> pressure);

   private:
    KineticFriction kinetic_;
    const CarriedFriction* memory_ = nullptr;
    std::vector<double> static_, mu_, last_mu_, last_error_;
    bool is_first_ = true;
};

}  // namespace contactd
