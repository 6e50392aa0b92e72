#include "cattaneo_mindlin.hpp"

#include <cmath>

#include "ellipse_compliance.hpp"
#include "ellipse_difference.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

// Johnson (7.42): shift = C mu Fn (1 - k^2), force = mu Fn (1 - k^3); `compliance` C times the force is the
// displacement of the adhesion area.
template <class Number>
EllipseState<Number> state_of_shift(const std::array<Number, 2>& w, const Pair& compliance, double bound) {
    using std::hypot, std::sqrt;
    const std::array<Number, 2> force{-w[0] / compliance[0], -w[1] / compliance[1]};  // as if all adhered
    const Number size = hypot(force[0], force[1]);
    if (size == Number(0)) return {};
    if (size >= Number(bound)) return {direction_of_slip(w, {bound * compliance[0], bound * compliance[1]}), Number(0)};
    return {{force[0] / size, force[1] / size}, sqrt(1 - size / bound)};
}

Pair shift_of_force(const Pair& force, const Pair& compliance, double bound) {
    const double size = std::hypot(force[0], force[1]);
    if (size == 0) return {};
    const double k = std::cbrt(1 - size / bound);
    const double share = bound * (1 - k * k) / size;
    return {-compliance[0] * share * force[0], -compliance[1] * share * force[1]};
}

}  // namespace

EllipticFriction cattaneo_mindlin(const Grid& grid, const EllipticContact& contact, double mu, const Shift& shift) {
    if (shift.rotation != 0)
        throw InvalidArgument("friction.rotation", "is " + number_text(shift.rotation) +
                                                       " rad; the closed form has none, the model full takes it");
    const PrescribedForce prescribed{shift.force.Fx, shift.force.Fy, mu * contact.Fn};
    check_reach(prescribed, "friction.force");
    Shift motion = shift;
    EllipseState<double> state{{}, 0};
    std::optional<SolverEvidence> evidence;
    if (!contact.empty() && mu > 0) {
        const EllipseCompliance u = ellipse_compliance(contact.axes, contact.combined);
        const Pair compliance{u.centre_x, u.centre_y};
        const double bound = prescribed.bound;
        const Pair start = shift_of_force({shift.force.Fx.value_or(0), shift.force.Fy.value_or(0)}, compliance, bound);
        Pair w{shift.force.Fx ? start[0] : shift.rigid_shift.x, shift.force.Fy ? start[1] : shift.rigid_shift.y};
        const auto force = [&](const Pair& trial) { return state_of_shift(trial, compliance, bound).force(bound); };
        evidence = find_motion(force, prescribed, {bound * compliance[0], bound * compliance[1]}, w);
        state = state_of_shift(w, compliance, bound);
        motion.rigid_shift.x = w[0], motion.rigid_shift.y = w[1];
    } else if (prescribed.Fx || prescribed.Fy) {
        evidence = SolverEvidence{0, 0, true, 0};
    }
    EllipticFriction result = ellipse_difference(grid, contact, mu, state.direction, state.k, nullptr);
    result.motion = motion;
    result.force = evidence;
    return result;
}

ForcesByMotion cattaneo_mindlin_by_motion(const EllipticContact& contact, double mu, const Shift& shift) {
    const EllipseCompliance u = ellipse_compliance(contact.axes, contact.combined);
    const double bound = mu * contact.Fn;
    const Pair compliance{u.centre_x, u.centre_y};
    const Pair w = away_from_zero({shift.rigid_shift.x, shift.rigid_shift.y}, bound * compliance[0]);
    const std::array<Dual, 2> motion{Dual::input(w[0], 0), Dual::input(w[1], 1)};
    const auto force = state_of_shift(motion, compliance, bound).force(bound);
    return {force[0].by, force[1].by, {}};
}

}  // namespace contactd
