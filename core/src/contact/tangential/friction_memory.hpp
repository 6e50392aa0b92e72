// Defines friction with memory: coefficients that particles carry through the contact.
#pragma once

#include <span>
#include <vector>

#include "contactd/contact.hpp"

namespace contactd {

/// Over a step of dt, the coefficient of a particle changes from mu_v to theta mu_v + (1 - theta) mu(v), with theta =
/// d/(d + dt max(v, v_0)), which is implicit Euler (Vollebregt and Schuttelaars, J. Sound Vib. 2012).
class CarriedFriction {
   public:
    /// `problem` has kinetic friction with memory, and must outlive this object. `mu_static` has one value for each
    /// element.
    CarriedFriction(const ContactProblem& problem, std::span<const double> mu_static);

    /// Begins a new step. `before` has the coefficients at the end of the previous step, shape [ny, nx]; empty means
    /// static.
    void begin(const std::vector<double>& before);
    /// Returns the coefficients behind the step, for elements under pressure with the coefficients `asked` of the law
    /// at the slip velocities `slip_velocity` (mm/s). Elsewhere they are the static ones.
    std::vector<double> after(std::span<const double> asked, std::span<const double> slip_velocity,
                              std::span<const double> pressure) const;

   private:
    double theta(double slip_velocity) const;

    const ContactProblem& problem_;
    const FrictionMemory& memory_;
    const std::vector<double> static_;
    double seconds_ = 1;          // of the step
    std::vector<double> before_;  // coefficients of the particles; empty for steady rolling
};

}  // namespace contactd
