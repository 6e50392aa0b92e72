#include "contactd/normal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver_support.hpp"

namespace contactd {
namespace {

using Values = std::vector<double>;

constexpr int patience = 8;  // changes of the set that do not lower f
constexpr double coarse_tolerance = 1e-4;
constexpr double rounding = 1e-14;

// Minimises f(p) = p'Ap/2 + h'p over p >= 0, whose optimality conditions are the contact conditions: preconditioned
// conjugate gradients on the contact set; after each step negative pressures leave the set and elements with a negative
// gap enter it. A watch on f keeps the set from changing for ever.
class Norm {
   public:
    Norm(const InfluenceOperator& influence, std::span<const double> gap, const SolverSettings& settings,
         Observer& observer)
        : influence_(influence), h_(gap), settings_(settings), observer_(observer), n_(gap.size()) {
        for (Values* values : {&p_, &u_, &r_, &z_, &v_, &q_}) values->resize(n_);
        in_contact_.resize(n_);
    }

    NormalSolution solve(std::span<const double> initial) {
        start(initial);
        NormalSolution result;
        bool stalled = false;
        for (int iteration = 0;; ++iteration) {
            observer_.throw_if_cancelled();
            const Check check = check_conditions();
            report(iteration, check.residual);
            result.evidence.iterations = iteration;
            result.evidence.residual = check.residual;
            result.evidence.converged = check.residual <= settings_.tolerance && check.right_set();
            if (result.evidence.converged || iteration == settings_.max_iterations || stalled) break;
            if (!check.right_set()) change_set();
            stalled = !step();
        }
        if (!result.evidence.converged) result.evidence.residual = clip().residual;
        result.pressure = std::move(p_);
        return result;
    }

   private:
    struct Check {
        double residual = 0;
        int negative_pressures = 0;
        int overlaps = 0;
        bool right_set() const { return negative_pressures == 0 && overlaps == 0; }
    };

    double gap(std::size_t i) const { return u_[i] + h_[i]; }
    bool overlaps(std::size_t i) const { return gap(i) < -rounding * (std::abs(u_[i]) + std::abs(h_[i])); }

    void start(std::span<const double> initial) {
        if (!initial.empty()) take_multiple_of(initial);
        for (std::size_t i = 0; i < n_; ++i) in_contact_[i] = p_[i] > 0 || overlaps(i);
        watch();
    }

    // The multiple of the estimate with the lowest f; zero when f rises along it.
    void take_multiple_of(std::span<const double> initial) {
        const double unit = *std::max_element(initial.begin(), initial.end());
        if (!(unit > 0)) return;
        for (std::size_t i = 0; i < n_; ++i) p_[i] = std::max(initial[i] / unit, 0.0);
        influence_.normal(p_, u_);
        const double energy = dot(p_, u_), work = -dot(p_, h_);
        const double factor = energy > 0 && work > 0 ? work / energy : 0;
        for (std::size_t i = 0; i < n_; ++i) {
            p_[i] *= factor;
            u_[i] *= factor;
        }
    }

    Check check_conditions() const {
        Check check;
        double defect = 0, reference = 0;
        for (std::size_t i = 0; i < n_; ++i) {
            if (in_contact_[i]) {
                defect += gap(i) * gap(i);
                reference += h_[i] * h_[i];
                if (p_[i] < 0) ++check.negative_pressures;
            } else if (overlaps(i)) {
                ++check.overlaps;
            }
        }
        check.residual = reference > 0 ? std::sqrt(defect / reference) : 0;
        return check;
    }

    void report(int iteration, double residual) {
        if (iteration == 0) first_residual_ = residual;
        if (iteration % 4 != 0) return;
        observer_.on_progress(
            {"normal", log_fraction(first_residual_, residual, settings_.tolerance), iteration, residual});
    }

    double f() const {
        double sum = 0;
        for (std::size_t i = 0; i < n_; ++i) sum += p_[i] * (0.5 * u_[i] + h_[i]);
        return sum;
    }

    // Keeps the pressures of the lowest f. Removing pressures may raise f for a while; when it does so too often in a
    // row, a step that cannot raise f starts again from the best.
    void watch() {
        const double value = f();
        if (value < best_f_) {
            failures_ = 0;
        } else if (++failures_ > patience) {
            failures_ = 0;
            projected_gradient_step();
        } else {
            return;
        }
        best_p_ = p_;
        best_u_ = u_;
        best_f_ = f();
    }

    // Takes negative pressures out of the set.
    Check clip() {
        for (std::size_t i = 0; i < n_; ++i) {
            if (p_[i] > 0) continue;
            p_[i] = 0;
            in_contact_[i] = false;
        }
        influence_.normal(p_, u_);
        return check_conditions();
    }

    void change_set() {
        if (std::any_of(p_.begin(), p_.end(), [](double p) { return p < 0; })) clip();
        watch();
        for (std::size_t i = 0; i < n_; ++i)
            if (!in_contact_[i] && overlaps(i)) in_contact_[i] = true;
        steps_ = 0;
    }

    // From the best pressures, with a step no longer than 1/||A||: f cannot rise.
    void projected_gradient_step() {
        if (norm_of_A_ == 0) {
            const Values ones(n_, 1.0);
            influence_.normal(ones, q_);
            norm_of_A_ = *std::max_element(q_.begin(), q_.end());
        }
        for (std::size_t i = 0; i < n_; ++i) p_[i] = std::max(best_p_[i] - (best_u_[i] + h_[i]) / norm_of_A_, 0.0);
        for (std::size_t i = 0; i < n_; ++i) in_contact_[i] = p_[i] > 0;
        influence_.normal(p_, u_);
    }

    // One step of conjugate gradients on the set; false when rounding or an indefinite table leaves no way down.
    bool step() {
        for (std::size_t i = 0; i < n_; ++i) r_[i] = in_contact_[i] ? -gap(i) : 0;
        influence_.precondition(Axis::z, r_, z_);
        for (std::size_t i = 0; i < n_; ++i)
            if (!in_contact_[i]) z_[i] = 0;
        const double beta = steps_ == 0 ? 0 : -dot(z_, q_) / curvature_;
        for (std::size_t i = 0; i < n_; ++i) v_[i] = z_[i] + beta * v_[i];
        influence_.normal(v_, q_);
        curvature_ = dot(v_, q_);
        const double slope = dot(r_, v_);
        if (!(curvature_ > 0) || !(slope > 0)) return false;
        const double alpha = slope / curvature_;
        for (std::size_t i = 0; i < n_; ++i) {
            p_[i] += alpha * v_[i];
            u_[i] += alpha * q_[i];
        }
        ++steps_;
        return true;
    }

    const InfluenceOperator& influence_;
    const std::span<const double> h_;
    const SolverSettings& settings_;
    Observer& observer_;
    const std::size_t n_;
    Values p_, u_, r_, z_, v_, q_;  // u = A p
    std::vector<char> in_contact_;
    Values best_p_, best_u_;
    double best_f_ = std::numeric_limits<double>::infinity();  // lowest at a change of the set
    int failures_ = 0;
    double curvature_ = 0;
    int steps_ = 0;  // since the last change of the set
    double norm_of_A_ = 0;
    double first_residual_ = 0;
};

// Coarser grids find the contact set for a small part of the cost.
Values estimate_on_coarser_grid(const InfluenceOperator& influence, std::span<const double> gap,
                                const SolverSettings& settings, Observer& observer) {
    const InfluenceOperator* coarser = influence.coarser();
    if (coarser == nullptr) return {};
    Values coarse_gap(coarser->size());
    influence.to_coarser(gap, coarse_gap);
    SilentObserver silent(observer);
    SolverSettings coarse_settings = settings;
    coarse_settings.tolerance = std::max(settings.tolerance, coarse_tolerance);
    const NormalSolution coarse = solve_normal(*coarser, coarse_gap, coarse_settings, {}, silent);
    Values estimate(influence.size());
    influence.from_coarser(coarse.pressure, estimate);
    return estimate;
}

}  // namespace

NormalSolution solve_normal(const InfluenceOperator& influence, std::span<const double> gap,
                            const SolverSettings& settings, std::span<const double> initial, Observer& observer) {
    require_size(gap, influence.size(), "gap");
    if (!initial.empty()) require_size(initial, influence.size(), "initial.pressure");
    const Stopwatch stopwatch;
    Values estimate(initial.begin(), initial.end());
    if (estimate.empty()) estimate = estimate_on_coarser_grid(influence, gap, settings, observer);
    NormalSolution solution = Norm(influence, gap, settings, observer).solve(estimate);
    solution.evidence.seconds = stopwatch.seconds();
    return solution;
}

}  // namespace contactd
