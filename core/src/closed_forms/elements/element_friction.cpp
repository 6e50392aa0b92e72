#include "element_friction.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "closed_forms/force_search.hpp"
#include "fastrip.hpp"
#include "polach.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

constexpr double least_mu = 1e-100;  // Products of smaller coefficients with pressures are too small as divisors.

class RollingModel {
   public:
    RollingModel(const ContactProblem& problem, const ElementPatch& patch, const Rolling& rolling)
        : problem_(problem), patch_(patch), rolling_(rolling), frame_(rolling_frame(patch.axes, rolling.chi)) {
        const double mu = problem.friction->mu[0];
        theory_.axes = frame_.axes;
        theory_.counted = rotated(patch.counted);
        theory_.C = coefficients_of(frame_.axes, patch.combined.nu, problem.simplified.coefficients);
        theory_.G = patch.combined.G;
        theory_.nu = patch.combined.nu;
        theory_.Fn = patch.Fn;
        theory_.static_mu = mu >= least_mu ? mu : 0;
        theory_.settings = problem.simplified;
        if (!rolling.force.empty()) theory_.given = local({rolling.xi, rolling.eta});
        if (problem.model == Model::polach) return;
        lines_.emplace(problem.grid, frame_);
        theory_.spin_ahead = rolling.spin_offset * lines_->step();
    }

    const RollingFrame& frame() const { return frame_; }
    const RollingTheory& theory() const { return theory_; }
    const ElementLines& lines() const { return *lines_; }
    bool has_tractions() const { return lines_.has_value(); }

    /// Returns the one coefficient of the whole contact, at the velocity of its creepage.
    double mu(const Pair& w) const {
        const auto& kinetic = problem_.friction->kinetic;
        if (!kinetic) return theory_.static_mu;
        const double mu =
            friction_coefficient(*kinetic, problem_.friction->mu[0], rolling_.velocity * std::hypot(w[0], w[1]));
        return mu >= least_mu ? mu : 0;
    }
    FastsimCreepages<double> local(const Pair& w) const {
        return {frame_.along(w[0], w[1]), frame_.across(w[0], w[1]), rolling_.phi};
    }
    template <class Number>
    ElementTractions<Number> tractions(const FastsimCreepages<Number>& w, double mu) const {
        return problem_.model == Model::fastrip ? fastrip(*lines_, patch_.bound, theory_, w, mu)
                                                : fastsim_on_elements(*lines_, patch_.bound, theory_, w, mu);
    }
    template <class Number>
    ElementSums<Number> sums(const FastsimCreepages<Number>& w, double mu) const {
        if (has_tractions()) return sums_of(*lines_, tractions(w, mu));
        ElementSums<Number> sums;
        const auto forces = polach(theory_, w, mu);
        sums.Fx = forces.Fx;
        sums.Fy = forces.Fy;
        sums.power = -(forces.Fx * w.xi + forces.Fy * w.eta);
        sums.slip_area = patch_.area;
        return sums;
    }
    Pair force(const Pair& w) const {
        const auto sum = sums(local(w), mu(w));
        return {frame_.x_of(sum.Fx, sum.Fy), frame_.y_of(sum.Fx, sum.Fy)};
    }
    /// Returns the forces of a small unit creepage along and across.
    Pair slope() const {
        const double unit = theory_.G * theory_.axes.a * theory_.axes.b * theory_.settings.slope.k0;
        const double k = 0.5 * (theory_.settings.k_adhesion + theory_.settings.k_slip);
        return {unit * k * theory_.C.C11, unit * k * theory_.C.C22};
    }

   private:
    SemiAxes rotated(const SemiAxes& axes) const { return frame_.c == 0 ? SemiAxes{axes.b, axes.a} : axes; }

    const ContactProblem& problem_;
    const ElementPatch& patch_;
    const Rolling& rolling_;
    RollingFrame frame_;
    RollingTheory theory_;
    std::optional<ElementLines> lines_;
};

/// Estimates the creepage for a force by the cubic law of Vermeulen and Johnson with Kalker's slopes.
Pair creepage_for(const RollingModel& model, const Force& force, double bound) {
    const double x = force.Fx.value_or(0), y = force.Fy.value_or(0), size = std::hypot(x, y);
    if (size == 0) return {};
    const double share = 3 * bound * (1 - std::cbrt(1 - size / bound)) / size;
    const Pair slope = model.slope();
    const double along = -share * model.frame().along(x, y) / slope[0];
    const double across = -share * model.frame().across(x, y) / slope[1];
    return {model.frame().x_of(along, across), model.frame().y_of(along, across)};
}

void take_tractions(const RollingModel& model, const Pair& w, EllipticFriction& result) {
    const RollingFrame& frame = model.frame();
    ElementTractions<double> t = model.tractions(model.local(w), model.mu(w));
    for (std::size_t i = 0; i < t.px.size(); ++i) {
        if (t.division[i] == ElementState::exterior) continue;
        result.traction_x[i] = frame.x_of(t.px[i], t.py[i]);
        result.traction_y[i] = frame.y_of(t.px[i], t.py[i]);
        result.slip_x[i] = frame.x_of(t.slip_x[i], t.slip_y[i]);
        result.slip_y[i] = frame.y_of(t.slip_x[i], t.slip_y[i]);
    }
    result.element_division = std::move(t.division);
}

/// Returns the division without tractions: elements in contact count as slip.
std::vector<ElementState> all_slip(const std::vector<double>& bound) {
    std::vector<ElementState> division(bound.size(), ElementState::exterior);
    for (std::size_t i = 0; i < bound.size(); ++i)
        if (bound[i] > 0) division[i] = ElementState::slip;
    return division;
}

void warn(const ContactProblem& problem, const RollingModel& model, double mu, std::vector<std::string>& warnings) {
    constexpr double strips_end = 0.9;
    const SlopeReduction& slope = problem.simplified.slope;
    if (slope.k0 > 1)
        warnings.push_back("simplified.slope.k0 is " + number_text(slope.k0) +
                           ", but a reduction of Kalker's slope lies in (0, 1].");
    if (slope.alpha > 1)
        warnings.push_back("simplified.slope.alpha is " + number_text(slope.alpha) +
                           ", so the slope increases with creepage. Use at most 1.");
    if (problem.model != Model::fastrip || !(mu > 0)) return;
    const double S = strip_spin(model.theory(), std::get<Rolling>(problem.motion).phi, mu);
    if (std::abs(S) > strips_end)
        warnings.push_back(
            "The spin is " + short_text(std::abs(S)) +
            " times the spin at which strips slip, but strip theory requires less than 1. Use model fastsim or full.");
}

}  // namespace

bool needs_elements(const ContactSetup& setup) {
    const SimplifiedSettings& settings = setup.simplified;
    return settings.on_elements || settings.blended || settings.bound == TractionBound::elliptic ||
           settings.coefficients == CreepageCoefficients::printed || settings.slope != SlopeReduction{} ||
           setup.normal_model != NormalModel::of_model || (setup.friction && setup.friction->kinetic);
}

bool rolls_on_elements(const ContactSetup& setup) {
    return setup.model == Model::fastrip || setup.model == Model::polach ||
           (setup.model == Model::fastsim && needs_elements(setup));
}

EllipticFriction element_friction(const ContactProblem& problem, const ElementPatch& patch,
                                  std::vector<std::string>& warnings) {
    const auto& rolling = std::get<Rolling>(problem.motion);
    const PrescribedForce prescribed{rolling.force.Fx, rolling.force.Fy, problem.friction->mu[0] * patch.Fn};
    check_reach(prescribed, "friction.rolling.force");
    EllipticFriction result;
    for (auto* values : {&result.traction_x, &result.traction_y, &result.slip_x, &result.slip_y})
        values->resize(problem.grid.size());
    result.element_division = all_slip(patch.bound);
    if (problem.friction->kinetic) result.friction_coefficient.assign(problem.grid.size(), problem.friction->mu[0]);
    result.frictional_power = 0;
    result.motion = rolling;
    if (patch.empty()) {
        if (!rolling.force.empty()) result.force = SolverEvidence{0, 0, true, 0};
        return result;
    }
    const RollingModel model(problem, patch, rolling);
    const Pair guess = creepage_for(model, rolling.force, prescribed.bound), slope = model.slope();
    Pair w{rolling.force.Fx ? guess[0] : rolling.xi, rolling.force.Fy ? guess[1] : rolling.eta};
    result.force = find_motion([&](const Pair& trial) { return model.force(trial); }, prescribed,
                               {prescribed.bound / slope[0], prescribed.bound / slope[1]}, w);
    std::get<Rolling>(result.motion).xi = w[0];
    std::get<Rolling>(result.motion).eta = w[1];

    const double mu = model.mu(w);
    const ElementSums<double> sum = model.sums(model.local(w), mu);
    result.Fx = model.frame().x_of(sum.Fx, sum.Fy);
    result.Fy = model.frame().y_of(sum.Fx, sum.Fy);
    result.Mz = sum.Mz;
    result.frictional_power = sum.power * rolling.velocity;
    result.slip_area = std::min(sum.slip_area, patch.area);
    result.adhesion_area = patch.area - result.slip_area;
    if (model.has_tractions()) {
        take_tractions(model, w, result);
    } else {
        result.slip_x.clear();
        result.slip_y.clear();
    }
    for (std::size_t i = 0; i < result.friction_coefficient.size(); ++i)
        if (result.element_division[i] != ElementState::exterior) result.friction_coefficient[i] = mu;
    warn(problem, model, mu, warnings);
    return result;
}

ForcesByMotion element_friction_by_motion(const ContactProblem& problem, const ElementPatch& patch,
                                          const Rolling& rolling) {
    const RollingModel model(problem, patch, rolling);
    const double full = model.theory().static_mu * patch.Fn / model.slope()[0];
    const Pair w = rolling.phi != 0 ? Pair{rolling.xi, rolling.eta} : away_from_zero({rolling.xi, rolling.eta}, full);
    const FastsimCreepages<double> at = model.local(w);
    const ElementSums<Dual> sum = model.sums(
        FastsimCreepages<Dual>{Dual::input(at.xi, 0), Dual::input(at.eta, 1), Dual::input(at.phi, 2)}, model.mu(w));
    return in_coordinates(model.frame(), {sum.Fx.by, sum.Fy.by, sum.Mz.by});
}

}  // namespace contactd
