#include "cattaneo_mindlin.hpp"

#include <cmath>

#include "closed_forms/ellipse_compliance.hpp"
#include "ellipse_difference.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

// Uses Johnson (7.42): shift = C mu Fn (1 - k^2), force = mu Fn (1 - k^3), where C times the force is the displacement
// of the adhesion area. For a strip, shift = C mu Fn (1 - k^2 + l k^2 ln k), force = mu Fn (1 - k^2), with l the
// logarithm of EllipseCompliance.
class ShiftLaw {
   public:
    ShiftLaw(const EllipticContact& contact, double mu) : bound_(mu * contact.Fn), n_(contact.force_power()) {
        const EllipseCompliance u = compliance_of(contact, contact.axes);
        compliance_ = {u.centre_x, u.centre_y};
        logarithm_ = u.logarithm;
    }

    Pair full_shift() const { return {bound_ * compliance_[0], bound_ * compliance_[1]}; }

    template <class Number>
    EllipseState<Number> state(const std::array<Number, 2>& w) const {
        using std::hypot, std::sqrt;
        const std::array<Number, 2> force{-w[0] / compliance_[0], -w[1] / compliance_[1]};  // as if all adhered
        const Number size = hypot(force[0], force[1]);
        if (size == Number(0)) return {};
        if (size >= Number(bound_)) return {direction_of_slip(w, full_shift()), Number(0)};
        return {{force[0] / size, force[1] / size}, sqrt(square_of_k(size / bound_))};
    }
    template <class Number>
    std::array<Number, 2> force(const std::array<Number, 2>& w) const {
        return state(w).force(bound_, n_);
    }

    Pair shift_of_force(const Pair& force) const {
        const double size = std::hypot(force[0], force[1]);
        if (size == 0) return {};
        const double share = bound_ * part(root(1 - size / bound_, n_)) / size;
        return {-compliance_[0] * share * force[0], -compliance_[1] * share * force[1]};
    }

    // Returns the exponent of Fn in the shift at constant k, which is 2/3 for ellipses of one gap. For strips, the
    // shift is C mu Fn, which is proportional to ln(2 datum/a) + 1/2, times the part above, of which only 1 - k^2 grows
    // with this logarithm. The logarithm decreases by 1/2 if Fn grows e-fold.
    double exponent(const Pair& w) const {
        if (logarithm_ == 0) return 2.0 / 3;
        const double k = state(w).k;
        return k < 1 ? 1 - 0.5 * logarithm_ * (1 - k * k) / part(k) : 1;
    }

   private:
    double part(double k) const {
        return 1 - k * k + (logarithm_ != 0 && k > 0 ? logarithm_ * k * k * std::log(k) : 0);
    }
    /// Computes k^2 from the fraction of the shift of full slip, below 1. For a strip it uses Newton's method: the
    /// fraction decreases with the square, and is convex. The last step adds derivatives.
    template <class Number>
    Number square_of_k(const Number& given) const {
        if (logarithm_ == 0) return 1 - given;
        const double half = 0.5 * logarithm_, target = value_of(given);
        const auto rest = [&](double s) { return 1 - s + half * s * std::log(s); };
        const auto slope = [&](double s) { return -1 + half * (std::log(s) + 1); };
        double s = 1 - target;
        for (int iteration = 0; iteration < 60; ++iteration) {
            const double change = (rest(s) - target) / slope(s);
            s -= change;
            if (std::abs(change) <= 1e-16 * s) break;
        }
        return Number(s) + (given - rest(s)) / slope(s);
    }
    static double value_of(double number) { return number; }
    static double value_of(const Dual& number) { return number.value; }

    double bound_, logarithm_ = 0;
    int n_;
    Pair compliance_{};
};

}  // namespace

EllipticFriction cattaneo_mindlin(const Grid& grid, const EllipticContact& contact, double mu, const Shift& shift) {
    if (shift.rotation != 0)
        throw InvalidArgument(
            "friction.rotation",
            "is " + number_text(shift.rotation) + " rad; the closed form does not support a rotation: use model full");
    const PrescribedForce prescribed{shift.force.Fx, shift.force.Fy, mu * contact.Fn};
    check_reach(prescribed, "friction.force");
    Shift motion = shift;
    EllipseState<double> state{{}, 0};
    std::optional<SolverEvidence> evidence;
    if (!contact.empty() && mu > 0) {
        const ShiftLaw law(contact, mu);
        const Pair start = law.shift_of_force({shift.force.Fx.value_or(0), shift.force.Fy.value_or(0)});
        Pair w{shift.force.Fx ? start[0] : shift.rigid_shift.x, shift.force.Fy ? start[1] : shift.rigid_shift.y};
        evidence = find_motion([&](const Pair& trial) { return law.force(trial); }, prescribed, law.full_shift(), w);
        state = law.state(w);
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
    const ShiftLaw law(contact, mu);
    const Pair w = away_from_zero({shift.rigid_shift.x, shift.rigid_shift.y}, law.full_shift()[0]);
    const auto force = law.force(std::array{Dual::input(w[0], 0), Dual::input(w[1], 1)});
    return {force[0].by, force[1].by, {}};
}

double cattaneo_mindlin_exponent(const EllipticContact& contact, double mu, const Shift& shift) {
    return ShiftLaw(contact, mu).exponent({shift.rigid_shift.x, shift.rigid_shift.y});
}

}  // namespace contactd
