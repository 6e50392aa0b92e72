#include "cattaneo_mindlin.hpp"

#include <cmath>

#include "ellipse_compliance.hpp"
#include "ellipse_difference.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

// Force direction and k for a rigid shift; `compliance` times the force is the displacement of the adhesion area.
struct State {
    Pair direction{};
    double k = 1;
};

// Johnson (7.42): shift = C mu Fn (1 - k^2), force = mu Fn (1 - k^3).
State state_of_shift(const Pair& w, const Pair& compliance, double bound) {
    const Pair force{-w[0] / compliance[0], -w[1] / compliance[1]};  // as if all adhered
    const double size = std::hypot(force[0], force[1]);
    if (size == 0) return {};
    if (size >= bound) return {direction_of_slip(w, {bound * compliance[0], bound * compliance[1]}), 0};
    return {{force[0] / size, force[1] / size}, std::sqrt(1 - size / bound)};
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
    State state{{}, 0};
    std::optional<SolverEvidence> evidence;
    if (!contact.empty() && mu > 0) {
        const EllipseCompliance u = ellipse_compliance(contact.axes, contact.combined);
        const Pair compliance{u.centre_x, u.centre_y};
        const double bound = prescribed.bound;
        const Pair start = shift_of_force({shift.force.Fx.value_or(0), shift.force.Fy.value_or(0)}, compliance, bound);
        Pair w{shift.force.Fx ? start[0] : shift.rigid_shift.x, shift.force.Fy ? start[1] : shift.rigid_shift.y};
        const auto force = [&](const Pair& trial) {
            const State there = state_of_shift(trial, compliance, bound);
            const double size = bound * (1 - there.k * there.k * there.k);
            return Pair{size * there.direction[0], size * there.direction[1]};
        };
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

}  // namespace contactd
