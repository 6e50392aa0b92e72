// Friction and the motion of the bodies: the tangential half of a contact problem.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "contactd/friction_with_memory.hpp"
#include "contactd/temperature_friction.hpp"

namespace contactd {

/// Velocity-weakening (falling) friction: the coefficient as a function of the slip velocity v, with m = mu_s - mu_k
/// minus the share of a second term. linear: mu_k + m max(0, 1 - v / v_c); exponential: mu_k + m exp(-v / v_c);
/// rational: mu_k + m / (1 + v / v_c), and for its second term m / (1 + (v / v_c)^2).
enum class SlipLaw { linear, exponential, rational };

/// Initial coefficients of the iterations: those of adhesion, or of full slip. A steep law may have several solutions.
/// A start from adhesion leads to one with little slip, a start from full slip to one with much slip.
enum class SlipStart { adhesion, full_slip };

/// A second term of a slip law.
struct SecondTerm {
    double fall = 0;           ///< m, 0 <= m <= mu_s - mu_k
    double slip_velocity = 0;  ///< v_c > 0 (mm/s)

    bool operator==(const SecondTerm&) const = default;
};

struct KineticFriction {
    SlipLaw law = SlipLaw::exponential;
    double mu = 0;             ///< kinetic coefficient mu_k, 0 <= mu_k <= the static one
    double slip_velocity = 0;  ///< v_c > 0 (mm/s)
    SlipStart start = SlipStart::adhesion;
    std::optional<SecondTerm> second{};
    std::optional<FrictionMemory> memory{};

    bool operator==(const KineticFriction&) const = default;
};

/// A layer of a third body between the surfaces (Hou, Kalousek, Magel, Wear 1997). Its shear deformation is
/// flexibility times the traction. Where its yield stress is below the friction bound, it flows instead of slip, or
/// before it. It does not flow where the surfaces stick. The layer does not affect the normal problem.
struct InterfacialLayer {
    double flexibility = 0;  ///< thickness over shear modulus, h3/G3 >= 0 (mm^3/N); 0 leaves flow only
    /// Shear stress tau_c0 > 0 at which a particle yields that has just entered (N/mm^2); infinite: it never yields.
    double yield_stress = std::numeric_limits<double>::infinity();
    /// Slope k_tau of the yield stress over the accumulated length of a particle's flow (N/mm^3); negative softens.
    double hardening = 0;
    double residual = 0.1;  ///< fraction of yield_stress that remains after softening, 0 to 1

    bool yields() const { return yield_stress < std::numeric_limits<double>::infinity(); }
    /// Returns whether the yield stress changes with flow, and thus is part of the state of a step.
    bool hardens() const { return yields() && hardening != 0; }
    bool operator==(const InterfacialLayer&) const = default;
};

/// Prescribed tangential force on the upper body (N).
struct Force {
    std::optional<double> Fx{}, Fy{};

    bool empty() const { return !Fx && !Fy; }
    bool operator==(const Force&) const = default;
};

/// Rigid displacement of the upper body over the lower, at the origin (mm).
struct RigidShift {
    double x = 0, y = 0;

    bool operator==(const RigidShift&) const = default;
};

/// A shift: slip over the step s = A p - A_prev p_prev + w, w = rigid_shift + rotation (-y, x) (mm).
struct Shift {
    RigidShift rigid_shift{};  ///< an initial estimate for components that `force` prescribes
    double rotation = 0;       ///< about z, positive from x to y (rad)
    Force force{};
    double duration = 1;  ///< of the step (s): slip velocity = slip / duration; only a slip law depends on it

    bool operator==(const Shift&) const = default;
};

/// steady: u_old = u; transient: u_old belongs to the previous tractions.
enum class RollingKind { steady, transient };

/// Rolling along (cos chi, sin chi): a particle now at x was at x + dq (cos chi, sin chi) one step ago. Slip over the
/// step s = dq w + u(x) - u_old(x + dq), w = (xi - phi y, eta + phi x) (Kalker 1990; verification of steady rolling),
/// with x and y of w those of the point spin_offset dq ahead.
struct Rolling {
    double xi = 0, eta = 0;  ///< longitudinal and lateral creepage
    double phi = 0;          ///< spin creepage (rad/mm)
    double chi = 0;          ///< rolling direction, angle from the x axis (rad)
    double dq = 0;           ///< distance rolled in one step (mm); 0: size of an element along chi
    /// Point where the rigid slip of spin is evaluated, in steps dq ahead of the element's centre, 0 to 1. The limit
    /// for small elements is the same. With much spin, 1/6 has a smaller error on typical grids (docs/contact.md).
    double spin_offset = 0;
    RollingKind kind = RollingKind::steady;
    int steps = 1;        ///< of transient rolling
    double velocity = 1;  ///< rolling velocity (mm/s): of slip velocities and of the frictional power
    Force force{};        ///< xi or eta of a prescribed component is an initial estimate

    bool steady() const { return kind == RollingKind::steady; }

    bool operator==(const Rolling&) const = default;
};

/// Throws InvalidArgument ("friction.kinetic...") unless velocities and distances are positive and finite,
/// 0 <= mu_k <= mu_s in every element, and the second term is at most the total decrease. Friction that increases with
/// velocity is refused, because adhesion at mu_s would no longer be the limit of slow slip.
void validate(const KineticFriction& kinetic, std::span<const double> mu_static);

/// Returns mu(v) for a slip velocity v >= 0 (mm/s): the static coefficient in adhesion (v = 0), see SlipLaw.
double friction_coefficient(const KineticFriction& kinetic, double mu_static, double v);

/// Throws InvalidArgument ("friction.layer...") unless all values except the yield stress are finite, flexibility >=
/// 0, the yield stress > 0, the residual fraction is in 0 to 1, and hardening > -1/flexibility, so that softening is
/// slower than elastic unloading of the layer.
void validate(const InterfacialLayer& layer);

using Motion = std::variant<Shift, Rolling>;
enum class MotionKind { shift, rolling };

/// Rigid slip of each element, shape [ny, nx]: (mm) over a step, or over the distance rolled.
struct RigidSlip {
    std::vector<double> x, y;

    bool empty() const { return x.empty() && y.empty(); }
    bool operator==(const RigidSlip&) const = default;
};

/// The form of FrictionLaw::mu in messages: one number for all elements, or an array over the grid.
struct ElementwiseCoefficient;

/// Coulomb friction: |p_t| <= mu p_n; in slip, equality and the direction opposite to the slip.
struct FrictionLaw {
    std::vector<double> mu{0};  ///< (static) coefficient, >= 0: one for all elements, or shape [ny, nx]
    std::optional<KineticFriction> kinetic{};
    std::optional<InterfacialLayer> layer{};  ///< for model full
    std::optional<TemperatureFriction> temperature{};
    /// Replaces `temperature` by one law per row of the grid, for wheels on rails.
    std::vector<TemperatureFriction> temperature_of_rows{};

    bool follows_temperature() const { return temperature || !temperature_of_rows.empty(); }
    bool operator==(const FrictionLaw&) const = default;
    double mu_of(std::size_t element) const { return mu.size() == 1 ? mu[0] : mu[element]; }
};

}  // namespace contactd
