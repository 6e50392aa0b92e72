#include "equilibrium_search.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

namespace contactd {
namespace {

using Vector = Eigen::VectorXd;
using Values = EquilibriumTask::Values;

Vector vector_of(const Values& values) {
    return Eigen::Map<const Vector>(values.data(), static_cast<Eigen::Index>(values.size()));
}

Values values_of(const Vector& vector) {
    return {vector.begin(), vector.end()};
}

/// Unknowns are in units of their first steps.
class Search {
   public:
    explicit Search(const EquilibriumTask& task)
        : task_(task),
          unit_(vector_of(task.first_step)),
          low_(vector_of(task.low).cwiseQuotient(unit_)),
          high_(vector_of(task.high).cwiseQuotient(unit_)),
          slopes_(Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
                      task.slopes.data(), unit_.size(), unit_.size()) *
                  unit_.asDiagonal()) {}

    EquilibriumFound run() {
        Vector x = clamped(vector_of(task_.start).cwiseQuotient(unit_)), r = evaluate(x);
        double reach = 1;  // limit of a step, in first steps
        while (!found_.converged && found_.evaluations < task_.max_evaluations && r.allFinite()) {
            const Vector step = clamped(x + limited(slopes_.fullPivLu().solve(-r), reach)) - x;
            if (!step.allFinite() || step.isZero(1e-15)) break;
            const Vector at = x + step, there = evaluate(at);
            if (there.allFinite()) slopes_ += (there - r - slopes_ * step) * step.transpose() / step.squaredNorm();
            const bool nearer = there.allFinite() && there.norm() < r.norm();
            reach = nearer ? 4 * std::max(reach, largest(step)) : 0.5 * largest(step);
            if (!nearer && reach < shortest) break;
            if (!nearer) continue;
            x = at;
            r = there;
        }
        found_.slopes.resize(task_.slopes.size());
        Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
            found_.slopes.data(), unit_.size(), unit_.size()) = slopes_ * unit_.cwiseInverse().asDiagonal();
        return std::move(found_);
    }

   private:
    static constexpr double shortest = 1e-9;

    static double largest(const Vector& vector) { return vector.lpNorm<Eigen::Infinity>(); }
    static Vector limited(const Vector& step, double reach) {
        const double length = largest(step);
        return length > reach ? Vector(step * (reach / length)) : step;
    }
    Vector clamped(const Vector& x) const { return x.cwiseMax(low_).cwiseMin(high_); }

    Vector evaluate(const Vector& x) {
        found_.at = values_of(x.cwiseProduct(unit_));
        const Vector residuals = vector_of(task_.residuals(found_.at));
        ++found_.evaluations;
        found_.residual = largest(residuals);
        found_.converged = residuals.allFinite() && found_.residual <= task_.tolerance;
        return residuals;
    }

    const EquilibriumTask& task_;
    const Vector unit_, low_, high_;
    Eigen::MatrixXd slopes_;
    EquilibriumFound found_;
};

}  // namespace

EquilibriumFound find_equilibrium(const EquilibriumTask& task) {
    return Search(task).run();
}

}  // namespace contactd
