// Defines friction and the motion of the bodies, which are the tangential half of a contact problem.
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

/// Selects a law of velocity-weakening (falling) friction: the coefficient as a function of the slip velocity v, with m
/// = mu_s - mu_k minus the decrease by a second term. linear is mu_k + m max(0, 1 - v / v_c), exponential is mu_k + m
/// exp(-v / v_c), and rational is mu_k + m / (1 + v / v_c). The second term of a rational law is m / (1 + (v / v_c)^2).
enum class SlipLaw { linear, exponential, rational };

/// Selects the initial coefficients of the iterations: those of adhesion, or of full slip. A steep law may have several
/// solutions. A start from adhesion leads to one with little slip, a start from full slip to one with much slip.
enum class SlipStart { adhesion, full_slip };

/// Describes a second term of a slip law.
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

/// Describes a layer of a third body between the surfaces (Hou, Kalousek, Magel, Wear 1997). Its shear deformation is
/// flexibility times the traction. Where its yield stress is below the friction bound, it flows instead of slip, or
/// before it. It does not flow where the surfaces stick. The layer does not affect the normal problem.
struct InterfacialLayer {
    double flexibility = 0;  ///< thickness over shear modulus, h3/G3 >= 0 (mm^3/N); 0: the layer only flows
    /// A particle that has just entered yields at the shear stress tau_c0 > 0 (N/mm^2); if infinite, it never yields.
    double yield_stress = std::numeric_limits<double>::infinity();
    /// Slope k_tau of the yield stress over the accumulated length of a particle's flow (N/mm^3) is negative for
    /// softening.
    double hardening = 0;
    double residual = 0.1;  ///< fraction of yield_stress that remains after softening, 0 to 1

    bool yields() const { return yield_stress < std::numeric_limits<double>::infinity(); }
    /// Returns whether the yield stress changes with flow and is therefore part of the state of a step.
    bool hardens() const { return yields() && hardening != 0; }
    bool operator==(const InterfacialLayer&) const = default;
};

/// Prescribes the tangential force on the upper body (N).
struct Force {
    std::optional<double> Fx{}, Fy{};

    bool empty() const { return !Fx && !Fy; }
    bool operator==(const Force&) const = default;
};

/// Describes the rigid displacement of the upper body over the lower at the origin (mm).
struct RigidShift {
    double x = 0, y = 0;

    bool operator==(const RigidShift&) const = default;
};

/// Describes a shift: slip over the step s = A p - A_prev p_prev + w, w = rigid_shift + rotation (-y, x) (mm).
struct Shift {
    RigidShift rigid_shift{};  ///< an initial estimate for components that `force` prescribes
    double rotation = 0;       ///< about z, positive from x to y (rad)
    Force force{};
    double duration = 1;  ///< duration of the step (s); only a slip law uses slip velocity = slip / duration

    bool operator==(const Shift&) const = default;
};

/// In steady rolling, u_old = u; in transient rolling, u_old belongs to the previous tractions.
enum class RollingKind { steady, transient };

/// Describes rolling along (cos chi, sin chi): a particle now at x was at x + dq (cos chi, sin chi) one step ago. Slip
/// over the step is s = dq w + u(x) - u_old(x + dq), with w = (xi - phi y, eta + phi x) (Kalker 1990; verification of
/// steady rolling). w is evaluated at the point spin_offset dq ahead of x.
struct Rolling {
    double xi = 0, eta = 0;  ///< longitudinal and lateral creepage
    double phi = 0;          ///< spin creepage (rad/mm)
    double chi = 0;          ///< rolling direction, angle from the x axis (rad)
    double dq = 0;           ///< distance rolled in one step (mm); 0: size of an element along chi
    /// The rigid slip of spin is evaluated at this distance ahead of the element's centre, in steps dq, 0 to 1. The
    /// limit for small elements is the same. With much spin, 1/6 has a smaller error on typical grids
    /// (docs/contact.md).
    double spin_offset = 0;
    RollingKind kind = RollingKind::steady;
    int steps = 1;        ///< of transient rolling
    double velocity = 1;  ///< rolling velocity (mm/s), for slip velocities and the frictional power
    Force force{};        ///< xi or eta of a prescribed component is an initial estimate

    bool steady() const { return kind == RollingKind::steady; }

    bool operator==(const Rolling&) const = default;
};

/// Throws InvalidArgument ("friction.kinetic...") unless velocities and distances are positive and finite,
/// 0 <= mu_k <= mu_s in every element, and the second term is at most the total decrease. Friction that increases with
/// velocity is refused, because adhesion at mu_s would no longer be the limit of slow slip.
void validate(const KineticFriction& kinetic, std::span<const double> mu_static);

/// Returns mu(v) for a slip velocity v >= 0 (mm/s), which is the static coefficient in adhesion (v = 0). SlipLaw
/// defines it.
double friction_coefficient(const KineticFriction& kinetic, double mu_static, double v);

/// Throws InvalidArgument ("friction.layer...") unless all values except the yield stress are finite, flexibility >= 0,
/// the yield stress > 0, the residual fraction is in 0 to 1, and hardening > -1/flexibility. With that bound, softening
/// is slower than elastic unloading of the layer.
void validate(const InterfacialLayer& layer);

using Motion = std::variant<Shift, Rolling>;
enum class MotionKind { shift, rolling };

/// Holds the rigid slip of each element, shape [ny, nx], in mm over a step or per distance rolled.
struct RigidSlip {
    std::vector<double> x, y;

    bool empty() const { return x.empty() && y.empty(); }
    bool operator==(const RigidSlip&) const = default;
};

/// Represents FrictionLaw::mu in messages: one number for all elements, or an array over the grid.
struct ElementwiseCoefficient;

/// Describes Coulomb friction: |p_t| <= mu p_n. In slip, |p_t| = mu p_n and the traction opposes the slip.
struct FrictionLaw {
    std::vector<double> mu{0};  ///< (static) coefficient, >= 0: one for all elements, or an array of shape [ny, nx]
    std::optional<KineticFriction> kinetic{};
    std::optional<InterfacialLayer> layer{};  ///< for model full
    std::optional<TemperatureFriction> temperature{};
    /// These laws, one per row of the grid, replace `temperature` for wheels on rails.
    std::vector<TemperatureFriction> temperature_of_rows{};

    bool follows_temperature() const { return temperature || !temperature_of_rows.empty(); }
    bool operator==(const FrictionLaw&) const = default;
    double mu_of(std::size_t element) const { return mu.size() == 1 ? mu[0] : mu[element]; }
};

}  // namespace contactd
