// Friction that falls with the slip velocity: the law, and the loop that makes bounds and slip agree.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "contactd/contact.hpp"
#include "contactd/friction.hpp"
#include "contactd/observer.hpp"

namespace contactd {

/// mu(v) for a slip velocity v >= 0: the static coefficient in adhesion (v = 0), see SlipLaw.
double friction_coefficient(const KineticFriction& kinetic, double mu_static, double v);

/// Throws InvalidArgument ("friction.kinetic.mu", "friction.kinetic.slip_velocity") unless v_c is positive and finite
/// and 0 <= mu_k <= mu_s in every element. Friction that rises with velocity is refused: sticking would be easier to
/// leave than slip to enter, and adhesion at mu_s would no longer be the limit of slow slip.
void validate(const KineticFriction& kinetic, std::span<const double> mu_static);

/// The coefficients of friction on their way to the slip they cause. Every element is relaxed by a secant of its own,
/// because falling friction would overshoot: less friction, more slip, less friction.
class SlipLawIteration {
   public:
    /// One static coefficient per element; starts with these.
    SlipLawIteration(const KineticFriction& kinetic, std::span<const double> mu_static);

    /// For the next solve, per element.
    const std::vector<double>& mu() const { return mu_; }

    /// Follows the slip velocities (mm/s, >= 0) of the last solve. Returns how far the coefficients were from those the
    /// law asks for, weighted with the pressure (N/mm^2): ||(mu(v) - mu) p|| / ||mu_s p||, 0 where there is no contact.
    double follow(std::span<const double> slip_velocity, std::span<const double> pressure);

   private:
    KineticFriction kinetic_;
    std::vector<double> static_, mu_, last_mu_, last_error_;
    bool is_first_ = true;
};

/// Solves with these bounds g = mu p (N/mm^2) and writes the slip velocity per element (mm/s). Should start from its
/// last solution.
using SolveWithBounds = std::function<void(std::span<const double> bound, std::span<double> slip_velocity)>;

/// Alternates between `solve` and the law until the figure of SlipLawIteration::follow is at most the tolerance; the
/// last solve belongs to the bounds it leaves. Evidence: number of solves, the figure, converged. Falling friction need
/// not have a steady answer: then it says so.
SolverEvidence iterate_slip_law(SlipLawIteration& law, std::span<const double> pressure, const SolverSettings& settings,
                                const SolveWithBounds& solve, Observer& observer);

}  // namespace contactd
