#include "contactd/fastsim.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "contactd/kalker_coefficients.hpp"
#include "fastsim_slice.hpp"
#include "force_search.hpp"
#include "rolling_frame.hpp"

namespace contactd {
namespace {

struct Totals {
    double Fx = 0, Fy = 0, Mz = 0, power = 0, slip_area = 0;  // in the rolling frame; power over the rolling velocity
};

// The ellipse by its own slices: y = b sin t at equally spaced t, x = a(y) cos s at equally spaced s, so that steps are
// small at the edges, where traction changes from adhesion to zero. The weights of s are scaled for the paraboloid
// bound to come out exactly; those of t do so by themselves.
class Ellipse {
   public:
    Ellipse(const RollingFrame& frame, const Material& combined, double bound, const FastsimSettings& settings)
        : axes_(frame.axes), L_(flexibilities(frame.axes, combined)), bound_(bound), settings_(settings) {
        double parabola = 0;
        for (int j = 1; j <= settings.steps; ++j) {
            const double s = std::numbers::pi * j / settings.steps;
            positions_.push_back(j == settings.steps ? -1.0 : std::cos(s));
            weights_.push_back(j == settings.steps ? 0.0 : std::sin(s));
            parabola += weights_.back() * (1 - positions_.back() * positions_.back());
        }
        for (double& weight : weights_) weight *= 4 / (3 * parabola);
    }

    FastsimSlice slice(const FastsimCreepages& creepages, double y) const { return {axes_, L_, bound_, creepages, y}; }
    const Flexibilities& L() const { return L_; }

    Totals totals(const FastsimCreepages& creepages) const {
        Totals sum;
        const double dt = std::numbers::pi / settings_.slices;
        for (int k = 0; k < settings_.slices; ++k) {
            const double t = (k + 0.5) * dt - 0.5 * std::numbers::pi;
            add(slice(creepages, axes_.b * std::sin(t)), axes_.b * std::sin(t), axes_.b * std::cos(t) * dt, sum);
        }
        return sum;
    }

   private:
    void add(FastsimSlice slice, double y, double dy, Totals& sum) const {
        const double half = slice.half_chord();
        const auto count = [&](double area, double x, double px, double py) {
            sum.Fx += area * px;
            sum.Fy += area * py;
            sum.Mz += area * (x * py - y * px);
            // Slip does the work of the rigid slip: what the springs take up they give back, since the traction is zero
            // at both ends of the slice.
            sum.power -= area * (L_.L1 * slice.slope_x() * px + L_.L2 * slice.slope_y(x) * py);
        };
        for (std::size_t j = 0; j < positions_.size(); ++j) {
            const double before = slice.x();
            slice.step_to(half * positions_[j]);
            const double h = before - slice.x();
            count(half * weights_[j] * dy, slice.x(), slice.px(), slice.py());
            sum.slip_area += (1 - slice.slip_start()) * h * dy;
            if (slice.slips() && slice.slip_start() > 0)
                count(0.5 * h * dy, before - slice.slip_start() * h, slice.corner_x(), slice.corner_y());
        }
    }

    SemiAxes axes_;
    Flexibilities L_;
    double bound_;
    FastsimSettings settings_;
    std::vector<double> positions_, weights_;  // of x over half the chord, after the leading edge
};

// Samples at element centres, found by steps of at most a share of the chord.
class Sampler {
   public:
    Sampler(const Grid& grid, const RollingFrame& frame, const Ellipse& ellipse, int steps, EllipticFriction& result)
        : grid_(grid), frame_(frame), ellipse_(ellipse), steps_(steps), result_(result) {}

    void run(const FastsimCreepages& creepages) {
        // Along the elements of a row or column where that is the rolling direction, else from the edge each time.
        const bool rows = frame_.s == 0, columns = frame_.c == 0;
        const int lines = columns ? grid_.nx : grid_.ny, length = columns ? grid_.ny : grid_.nx;
        const bool backwards = (columns ? frame_.s : frame_.c) > 0;
        for (int line = 0; line < lines; ++line) {
            std::optional<FastsimSlice> slice;
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
    void advance(FastsimSlice& slice, double x) const {
        const double longest = 2 * slice.half_chord() / steps_;
        const double from = slice.x();
        const int n = std::max(1, static_cast<int>(std::ceil((from - x) / longest)));
        for (int j = 1; j <= n; ++j) slice.step_to(j == n ? x : from + (x - from) * j / n);
    }

    void store(const FastsimSlice& slice, std::size_t i) {
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
        if (value < 4 || value > 10'000)
            throw InvalidArgument(field, "is " + std::to_string(value) + "; it must lie in 4 to 10000");
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
    const KalkerCoefficients C = kalker_coefficients(axes.a / axes.b, combined.nu);
    const double unit = axes.a / combined.G;
    return {8 * unit / (3 * C.C11), 8 * unit / (3 * C.C22),
            std::numbers::pi * unit * std::sqrt(axes.a / axes.b) / (4 * C.C23)};
}

EllipticFriction fastsim(const Grid& grid, const EllipticContact& contact, double mu, const Rolling& rolling,
                         const FastsimSettings& settings) {
    validate(settings);
    const PrescribedForce prescribed{rolling.Fx, rolling.Fy, mu * contact.Fn};
    check_reach(prescribed, "friction.rolling.force");
    EllipticFriction result;
    for (auto* values : {&result.traction_x, &result.traction_y, &result.slip_x, &result.slip_y})
        values->resize(grid.size());
    result.element_division.assign(grid.size(), ElementState::exterior);
    result.frictional_power = 0;
    result.motion = rolling;
    if (contact.empty()) {
        if (rolling.Fx || rolling.Fy) result.force = SolverEvidence{0, 0, true, 0};
        return result;
    }
    const RollingFrame frame = rolling_frame(contact.axes, rolling.chi);
    const Ellipse ellipse(frame, contact.combined, 2 * prescribed.bound / contact.area(), settings);
    const auto local = [&](const Pair& w) {
        return FastsimCreepages{frame.along(w[0], w[1]), frame.across(w[0], w[1]), rolling.phi};
    };
    const auto force = [&](const Pair& w) {
        const Totals sum = ellipse.totals(local(w));
        return Pair{frame.x_of(sum.Fx, sum.Fy), frame.y_of(sum.Fx, sum.Fy)};
    };
    const Flexibilities& L = ellipse.L();
    const double volume = 8 * frame.axes.a * frame.axes.a * frame.axes.b / 3;
    const Pair slope{volume / L.L1, volume / L.L2};
    const double Fx = rolling.Fx.value_or(0), Fy = rolling.Fy.value_or(0);
    const Pair guess = estimate({frame.along(Fx, Fy), frame.across(Fx, Fy)}, prescribed.bound, slope);
    Pair w{rolling.Fx ? frame.x_of(guess[0], guess[1]) : rolling.xi,
           rolling.Fy ? frame.y_of(guess[0], guess[1]) : rolling.eta};
    result.force = find_motion(force, prescribed, {prescribed.bound / slope[0], prescribed.bound / slope[1]}, w);
    std::get<Rolling>(result.motion).xi = w[0];
    std::get<Rolling>(result.motion).eta = w[1];

    const Totals sum = ellipse.totals(local(w));
    result.Fx = frame.x_of(sum.Fx, sum.Fy);
    result.Fy = frame.y_of(sum.Fx, sum.Fy);
    result.Mz = sum.Mz;
    result.frictional_power = sum.power * rolling.velocity;
    result.slip_area = sum.slip_area;
    result.adhesion_area = std::max(0.0, contact.area() - sum.slip_area);
    Sampler(grid, frame, ellipse, settings.steps, result).run(local(w));
    return result;
}

}  // namespace contactd
