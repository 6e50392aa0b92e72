#include "fastsim.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "fastsim_slice.hpp"
#include "force_search.hpp"
#include "kalker_coefficients.hpp"
#include "rolling_frame.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

template <class Number>
struct Totals {
    Number Fx = 0, Fy = 0, Mz = 0, power = 0, slip_area = 0;  // in the rolling frame; power over the rolling velocity
};

// The ellipse by its own slices: y = b sin t at equally spaced t, x = a(y) cos s at equally spaced s, so that steps are
// small at the edges, where traction changes from adhesion to zero.
class Ellipse {
   public:
    Ellipse(const RollingFrame& frame, const Material& combined, double bound, const FastsimSettings& settings)
        : axes_(frame.axes), L_(flexibilities(frame.axes, combined)), bound_(bound) {
        for (int j = 1; j <= settings.steps; ++j)
            positions_.push_back(j == settings.steps ? -1.0 : std::cos(std::numbers::pi * j / settings.steps));
        set_widths(settings.slices);
    }

    template <class Number>
    FastsimSlice<Number> slice(const FastsimCreepages<Number>& creepages, double y) const {
        return {axes_, L_, bound_, creepages, y};
    }
    const Flexibilities& L() const { return L_; }

    template <class Number>
    Totals<Number> totals(const FastsimCreepages<Number>& creepages) const {
        Totals<Number> sum;
        for (std::size_t k = 0; k < heights_.size(); ++k) {
            const double y = axes_.b * heights_[k], dy = axes_.b * widths_[k];
            FastsimSlice<Number> along = slice(creepages, y);
            const SliceSums<Number> line = sums(along);
            sum.Fx += dy * line.px;
            sum.Fy += dy * line.py;
            sum.Mz += dy * (line.x_py - y * line.px);
            // Slip does the work of the rigid slip: what the springs take up they give back, since the traction is zero
            // at both ends of the slice.
            sum.power -= dy * (L_.L1 * along.slope_x() * line.px +
                               L_.L2 * (along.slope_y(0) * line.py + along.slope_yx() * line.x_py));
            sum.slip_area += dy * line.slip;
        }
        return sum;
    }

   private:
    // Where all adheres or all slips a slice carries a multiple of its chord squared (creepage) or cubed (spin, bound).
    // Equal steps of t are exact for its chord and the cube, which are cos^2 t and cos^4 t there, and nearly so for the
    // square, cos^3 t: a share of cos 6t, which alters neither of the others, makes up for the rest.
    void set_widths(int slices) {
        const double dt = std::numbers::pi / slices;
        const auto angle = [&](int k) { return (k + 0.5) * dt - 0.5 * std::numbers::pi; };
        double square = 0, change = 0;
        for (int k = 0; k < slices; ++k) {
            const double cos3 = std::pow(std::cos(angle(k)), 3) * dt;
            square += cos3;
            change += cos3 * std::cos(6 * angle(k));
        }
        const double share = (4.0 / 3 - square) / change;
        for (int k = 0; k < slices; ++k) {
            heights_.push_back(std::sin(angle(k)));
            widths_.push_back(std::cos(angle(k)) * dt * (1 + share * std::cos(6 * angle(k))));
        }
    }

    template <class Number>
    struct SliceSums {
        Number px = 0, py = 0, x_py = 0, slip = 0;  // integrals of p_x, p_y, x p_y; length that slips
    };

    // Each step has a part that adheres, a part that slips, or one after the other. The traction is a quadratic
    // function of x on the first; on the second it follows the bound, a parabola, and its direction changes little.
    template <class Number>
    SliceSums<Number> sums(FastsimSlice<Number>& slice) const {
        SliceSums<Number> sum;
        for (const double position : positions_) {
            TractionAt<Number> from = slice.here();
            slice.step_to(slice.half_chord() * position);
            const Number corner = slice.slip_start();
            if (corner < from.x) {
                const TractionAt<Number> end = slice.adhering(from, corner);
                add(from, slice.adhering(from, 0.5 * (from.x + corner)), end, sum);
                from = end;
            }
            if (Number(slice.x()) < corner) {
                add(from, slipping(slice, from), slice.here(), sum);
                sum.slip += corner - slice.x();
            }
        }
        return sum;
    }

    // In the middle of the way to where the slice stands: the bound, in the mean direction.
    template <class Number>
    static TractionAt<Number> slipping(const FastsimSlice<Number>& slice, const TractionAt<Number>& from) {
        using std::sqrt;
        const Number x = 0.5 * (from.x + slice.x()), px = from.px + slice.px(), py = from.py + slice.py();
        const Number size = sqrt(px * px + py * py), share = size > Number(0) ? slice.bound_at(x) / size : Number(0);
        return {x, share * px, share * py};
    }

    // Simpson's rule, exact for cubics.
    template <class Number>
    static void add(const TractionAt<Number>& from, const TractionAt<Number>& middle, const TractionAt<Number>& to,
                    SliceSums<Number>& sum) {
        const Number unit = (from.x - to.x) / 6;
        sum.px += unit * (from.px + 4 * middle.px + to.px);
        sum.py += unit * (from.py + 4 * middle.py + to.py);
        sum.x_py += unit * (from.x * from.py + 4 * middle.x * middle.py + to.x * to.py);
    }

    SemiAxes axes_;
    Flexibilities L_;
    double bound_;
    std::vector<double> positions_;         // of x over half the chord, after the leading edge
    std::vector<double> heights_, widths_;  // of the slices over b
};

// Samples at element centres, found by at most twice as long steps: forces do not come from them.
class Sampler {
   public:
    Sampler(const Grid& grid, const RollingFrame& frame, const Ellipse& ellipse, int steps, EllipticFriction& result)
        : grid_(grid), frame_(frame), ellipse_(ellipse), steps_(steps), result_(result) {}

    void run(const FastsimCreepages<double>& creepages) {
        // Along the elements of a row or column where that is the rolling direction, else from the edge each time.
        const bool rows = frame_.s == 0, columns = frame_.c == 0;
        const int lines = columns ? grid_.nx : grid_.ny, length = columns ? grid_.ny : grid_.nx;
        const bool backwards = (columns ? frame_.s : frame_.c) > 0;
        for (int line = 0; line < lines; ++line) {
            std::optional<FastsimSlice<double>> slice;
            for (int k = 0; k < length; ++k) {
                const int at = backwards ? length - 1 - k : k;
                const int ix = columns ? line : at, iy = columns ? at : line;
                const double along = frame_.along(grid_.x(ix), grid_.y(iy));
                const double across = frame_.across(grid_.x(ix), grid_.y(iy));
                const double X = along / frame_.axes.a, Y = across / frame_.axes.b;
                if (X * X + Y * Y >= 1) continue;
                if (!slice || !(rows || columns)) slice.emplace(ellipse_.slice(creepages, across));
                advance(*slice, along);
                store(*slice, static_cast<std::size_t>(iy) * grid_.nx + ix);
            }
        }
    }

   private:
    void advance(FastsimSlice<double>& slice, double x) const {
        const double longest = 2 * slice.half_chord() / steps_;
        const double from = slice.x();
        const int n = std::max(1, static_cast<int>(std::ceil((from - x) / longest)));
        for (int j = 1; j <= n; ++j) slice.step_to(j == n ? x : from + (x - from) * j / n);
    }

    void store(const FastsimSlice<double>& slice, std::size_t i) {
        result_.traction_x[i] = frame_.x_of(slice.px(), slice.py());
        result_.traction_y[i] = frame_.y_of(slice.px(), slice.py());
        result_.element_division[i] = slice.slips() ? ElementState::slip : ElementState::adhesion;
        const double sx = -ellipse_.L().L1 * slice.excess_x(), sy = -ellipse_.L().L2 * slice.excess_y();
        result_.slip_x[i] = frame_.x_of(sx, sy);
        result_.slip_y[i] = frame_.y_of(sx, sy);
    }

    const Grid& grid_;
    const RollingFrame& frame_;
    const Ellipse& ellipse_;
    int steps_;
    EllipticFriction& result_;
};

void validate(const FastsimSettings& settings) {
    const auto check = [](int value, const char* field) {
        if (value < 8 || value > 10'000)
            throw InvalidArgument(field, "is " + std::to_string(value) + "; it must lie in 8 to 10000");
    };
    check(settings.steps, "fastsim.steps");
    check(settings.slices, "fastsim.slices");
}

// An estimate of the creepage for a force: the cubic law of Vermeulen and Johnson with Kalker's slopes.
Pair estimate(const Pair& force, double bound, const Pair& slope) {
    const double size = std::hypot(force[0], force[1]);
    if (size == 0) return {};
    const double share = 3 * bound * (1 - std::cbrt(1 - size / bound)) / size;
    return {-share * force[0] / slope[0], -share * force[1] / slope[1]};
}

}  // namespace

Flexibilities flexibilities(const SemiAxes& axes, const Material& combined) {
    const double ratio = axes.a / axes.b;
    if (!has_kalker_coefficients(ratio))
        throw InvalidArgument("gap", "has a contact ellipse with semi-axes of " + number_text(axes.a) +
                                         " mm along and " + number_text(axes.b) +
                                         " mm across the rolling direction, a ratio of " + number_text(ratio) +
                                         "; fastsim has Kalker's coefficients for 1/32 to 32. Take model full, or "
                                         "hertz where there is no spin");
    const KalkerCoefficients C = kalker_coefficients(ratio, combined.nu);
    const double unit = axes.a / combined.G;
    return {8 * unit / (3 * C.C11), 8 * unit / (3 * C.C22),
            std::numbers::pi * unit * std::sqrt(axes.a / axes.b) / (4 * C.C23)};
}

EllipticFriction fastsim(const Grid& grid, const EllipticContact& contact, double mu, const Rolling& rolling,
                         const FastsimSettings& settings) {
    validate(settings);
    const PrescribedForce prescribed{rolling.force.Fx, rolling.force.Fy, mu * contact.Fn};
    check_reach(prescribed, "friction.rolling.force");
    EllipticFriction result;
    for (auto* values : {&result.traction_x, &result.traction_y, &result.slip_x, &result.slip_y})
        values->resize(grid.size());
    result.element_division.assign(grid.size(), ElementState::exterior);
    result.frictional_power = 0;
    result.motion = rolling;
    if (contact.empty()) {
        if (!rolling.force.empty()) result.force = SolverEvidence{0, 0, true, 0};
        return result;
    }
    const RollingFrame frame = rolling_frame(contact.axes, rolling.chi);
    const Ellipse ellipse(frame, contact.combined, 2 * prescribed.bound / contact.area(), settings);
    const auto local = [&](const Pair& w) {
        return FastsimCreepages<double>{frame.along(w[0], w[1]), frame.across(w[0], w[1]), rolling.phi};
    };
    const auto force = [&](const Pair& w) {
        const Totals<double> sum = ellipse.totals(local(w));
        return Pair{frame.x_of(sum.Fx, sum.Fy), frame.y_of(sum.Fx, sum.Fy)};
    };
    const Flexibilities& L = ellipse.L();
    const double volume = 8 * frame.axes.a * frame.axes.a * frame.axes.b / 3;
    const Pair slope{volume / L.L1, volume / L.L2};
    const double Fx = rolling.force.Fx.value_or(0), Fy = rolling.force.Fy.value_or(0);
    const Pair guess = estimate({frame.along(Fx, Fy), frame.across(Fx, Fy)}, prescribed.bound, slope);
    Pair w{rolling.force.Fx ? frame.x_of(guess[0], guess[1]) : rolling.xi,
           rolling.force.Fy ? frame.y_of(guess[0], guess[1]) : rolling.eta};
    result.force = find_motion(force, prescribed, {prescribed.bound / slope[0], prescribed.bound / slope[1]}, w);
    std::get<Rolling>(result.motion).xi = w[0];
    std::get<Rolling>(result.motion).eta = w[1];

    const Totals<double> sum = ellipse.totals(local(w));
    result.Fx = frame.x_of(sum.Fx, sum.Fy);
    result.Fy = frame.y_of(sum.Fx, sum.Fy);
    result.Mz = sum.Mz;
    result.frictional_power = sum.power * rolling.velocity;
    result.slip_area = sum.slip_area;
    result.adhesion_area = std::max(0.0, contact.area() - sum.slip_area);
    Sampler(grid, frame, ellipse, settings.steps / 2, result).run(local(w));
    return result;
}

ForcesByMotion fastsim_by_motion(const EllipticContact& contact, double mu, const Rolling& rolling,
                                 const FastsimSettings& settings) {
    const RollingFrame frame = rolling_frame(contact.axes, rolling.chi);
    const Ellipse ellipse(frame, contact.combined, 2 * mu * contact.Fn / contact.area(), settings);
    const Totals<Dual> sum = ellipse.totals(
        FastsimCreepages<Dual>{Dual::input(frame.along(rolling.xi, rolling.eta), 0),
                               Dual::input(frame.across(rolling.xi, rolling.eta), 1), Dual::input(rolling.phi, 2)});
    return in_coordinates(frame, {sum.Fx.by, sum.Fy.by, sum.Mz.by});
}

}  // namespace contactd
