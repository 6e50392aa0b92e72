#include "vermeulen_johnson.hpp"

#include <cmath>

#include "closed_forms/ellipse_compliance.hpp"
#include "ellipse_difference.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

// 1 - k is the length of the creepage, in units of the creepage of full slip in each direction.
template <class Number>
EllipseState<Number> state_of_creepage(const std::array<Number, 2>& creepage, const Pair& full) {
    using std::hypot;
    const std::array<Number, 2> share{-creepage[0] / full[0], -creepage[1] / full[1]};
    const Number size = hypot(share[0], share[1]);
    if (size == Number(0)) return {};
    if (size >= Number(1)) return {direction_of_slip(creepage, full), Number(0)};
    return {{share[0] / size, share[1] / size}, 1 - size};
}

// Returns the creepages of full slip; the parts of both tractions are below.
Pair full_creepage(const RollingFrame& frame, const EllipticContact& contact, double bound) {
    const EllipseCompliance u = compliance_of(contact, frame.axes);
    const double unit = 2 * bound * frame.axes.a;
    return {unit * u.along_x, unit * u.along_y};
}

}  // namespace

// Both tractions bend the surface equally, by `along` of the ellipse's compliance, about centres (1-k) a apart. In the
// adhesion area du/dx is the constant 2 along mu Fn (1-k) a, which is the creepage.
EllipticFriction vermeulen_johnson(const Grid& grid, const EllipticContact& contact, double mu,
                                   const Rolling& rolling) {
    if (rolling.phi != 0)
        throw InvalidArgument("friction.rolling.phi",
                              "is " + number_text(rolling.phi) +
                                  " rad/mm; the closed form does not support spin: use model fastsim or full");
    const PrescribedForce prescribed{rolling.force.Fx, rolling.force.Fy, mu * contact.Fn};
    check_reach(prescribed, "friction.rolling.force");
    Rolling motion = rolling;
    EllipseState<double> state{{}, 0};
    std::optional<SolverEvidence> evidence;
    RollingFrame frame;
    if (!contact.empty()) frame = rolling_frame(contact.axes, rolling.chi);
    if (!contact.empty() && mu > 0) {
        const double bound = prescribed.bound;
        const Pair full = full_creepage(frame, contact, bound);
        const auto state_of = [&](const Pair& w) {
            const auto local = state_of_creepage(Pair{frame.along(w[0], w[1]), frame.across(w[0], w[1])}, full);
            const Pair n = local.direction;
            return EllipseState<double>{{frame.x_of(n[0], n[1]), frame.y_of(n[0], n[1])}, local.k};
        };
        const int n = contact.force_power();
        const auto force = [&](const Pair& w) { return state_of(w).force(bound, n); };
        const double Fx = rolling.force.Fx.value_or(0), Fy = rolling.force.Fy.value_or(0), size = std::hypot(Fx, Fy);
        const double share = size > 0 ? (1 - root(1 - size / bound, n)) / size : 0;
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

// The moment is that of the smaller ellipse, (1-k) a ahead.
ForcesByMotion vermeulen_johnson_by_motion(const EllipticContact& contact, double mu, const Rolling& rolling) {
    const RollingFrame frame = rolling_frame(contact.axes, rolling.chi);
    const double bound = mu * contact.Fn;
    const Pair full = full_creepage(frame, contact, bound);
    const Pair w =
        away_from_zero({frame.along(rolling.xi, rolling.eta), frame.across(rolling.xi, rolling.eta)}, full[0]);
    const auto state = state_of_creepage(std::array{Dual::input(w[0], 0), Dual::input(w[1], 1)}, full);
    const auto force = state.force(bound, contact.force_power());
    const Dual k = state.k;
    const Dual adhering = times_power(-bound * k, k, contact.force_power() - 1);
    const Dual moment = adhering * (1 - k) * frame.axes.a * state.direction[1];
    return in_coordinates(frame, {force[0].by, force[1].by, moment.by});
}

}  // namespace contactd
