#include "vermeulen_johnson.hpp"

#include <cmath>

#include "ellipse_compliance.hpp"
#include "ellipse_difference.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

struct State {
    Pair direction{};
    double k = 1;
};

// 1 - k is the length of the creepage in units of what makes all slip, each direction its own.
State state_of_creepage(const Pair& creepage, const Pair& full) {
    const Pair share{-creepage[0] / full[0], -creepage[1] / full[1]};
    const double size = std::hypot(share[0], share[1]);
    if (size == 0) return {};
    if (size >= 1) return {direction_of_slip(creepage, full), 0};
    return {{share[0] / size, share[1] / size}, 1 - size};
}

}  // namespace

// Both tractions bend the surface alike, by `along` of the ellipse's compliance, about centres (1-k) a apart: in the
// adhesion area du/dx is the constant 2 along mu Fn (1-k) a, which is the creepage.
EllipticFriction vermeulen_johnson(const Grid& grid, const EllipticContact& contact, double mu,
                                   const Rolling& rolling) {
    if (rolling.phi != 0)
        throw InvalidArgument("friction.rolling.phi",
                              "is " + number_text(rolling.phi) +
                                  " rad/mm; the closed form has no spin, the models fastsim and full have");
    const PrescribedForce prescribed{rolling.force.Fx, rolling.force.Fy, mu * contact.Fn};
    check_reach(prescribed, "friction.rolling.force");
    Rolling motion = rolling;
    State state{{}, 0};
    std::optional<SolverEvidence> evidence;
    RollingFrame frame;
    if (!contact.empty()) frame = rolling_frame(contact.axes, rolling.chi);
    if (!contact.empty() && mu > 0) {
        const EllipseCompliance u = ellipse_compliance(frame.axes, contact.combined);
        const double bound = prescribed.bound, unit = 2 * bound * frame.axes.a;
        const Pair full{unit * u.along_x, unit * u.along_y};
        const auto state_of = [&](const Pair& w) {
            State local = state_of_creepage({frame.along(w[0], w[1]), frame.across(w[0], w[1])}, full);
            const Pair n = local.direction;
            return State{{frame.x_of(n[0], n[1]), frame.y_of(n[0], n[1])}, local.k};
        };
        const auto force = [&](const Pair& w) {
            const State there = state_of(w);
            const double size = bound * (1 - there.k * there.k * there.k);
            return Pair{size * there.direction[0], size * there.direction[1]};
        };
        const double Fx = rolling.force.Fx.value_or(0), Fy = rolling.force.Fy.value_or(0), size = std::hypot(Fx, Fy);
        const double share = size > 0 ? (1 - std::cbrt(1 - size / bound)) / size : 0;
        const double along = -share * full[0] * frame.along(Fx, Fy), across = -share * full[1] * frame.across(Fx, Fy);
        Pair w{rolling.force.Fx ? frame.x_of(along, across) : rolling.xi,
               rolling.force.Fy ? frame.y_of(along, across) : rolling.eta};
        evidence = find_motion(force, prescribed, {full[0], full[1]}, w);
        state = state_of(w);
        motion.xi = w[0], motion.eta = w[1];
    } else if (prescribed.Fx || prescribed.Fy) {
        evidence = SolverEvidence{0, 0, true, 0};
    }
    EllipticFriction result =
        ellipse_difference(grid, contact, mu, state.direction, state.k, contact.empty() ? nullptr : &frame);
    result.frictional_power = -rolling.velocity * (result.Fx * motion.xi + result.Fy * motion.eta);
    result.motion = motion;
    result.force = evidence;
    return result;
}

}  // namespace contactd
