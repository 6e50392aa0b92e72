// Linear equations with one matrix and several right-hand sides, of whose solutions a few sums are outputs.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "contactd/observer.hpp"

namespace contactd {

struct LinearEquations {
    using Vector = Eigen::VectorXd;

    std::function<void(const Vector& x, Vector& y)> matrix;
    // z ~ matrix^-1 r. `step` counts those for one right-hand side.
    std::function<void(const Vector& r, Vector& z, int step)> precondition;
    // Matrix and preconditioner are their own transposes and positive definite, the latter the same in all steps.
    bool symmetric = false;
    Vector weights;           // > 0: residuals are measured with them
    Eigen::MatrixXd outputs;  // columns c: the sums c . x
};

// Steps of the preconditioner, for one right-hand side after the other and of use to all. Of the combinations of steps
// that is taken which leaves the least residual (GCR; Eisenstat, Elman and Schultz 1983), or for symmetric equations
// the least error in energy (conjugate gradients with several right-hand sides; O'Leary 1980), where sums with the
// right-hand sides err by the square of that.
class KrylovSpace {
   public:
    using Vector = LinearEquations::Vector;
    using Matrix = Eigen::MatrixXd;

    struct Right {
        Vector values;
        double size;         // length of what it is a difference of, weighted
        Vector known;        // to be added to its sums
        double measure = 1;  // its residual is relative to that many times its length
    };
    using Change = std::function<double(const Vector& now, const Vector& before)>;
    struct Tolerance {
        double residual;  // relative
        // Or what steps to come are expected to change of the sums, as told by change_of; 0: residuals alone count.
        double change = 0;
        Change change_of{};
    };

    explicit KrylovSpace(LinearEquations equations);

    // To the tolerance, or until no more steps are kept. To be called once.
    void solve(const std::vector<Right>& rights, const Tolerance& tolerance, const Observer& observer);

    bool converged() const { return converged_; }
    double residual() const { return largest_; }
    int steps() const { return static_cast<int>(count_); }
    // Returns the sums of one right-hand side.
    Vector sums(std::size_t right) const { return sums_.col(static_cast<Eigen::Index>(right)); }
    // x itself; of symmetric equations only.
    Vector solution(std::size_t right) const;

   private:
    struct State {
        double length = 0, change = 1;
        int steps = 0;
        bool ended = false;
    };

    void begin(const std::vector<Right>& rights);
    double relative(Eigen::Index right) const;
    // Whether there was another step to make.
    bool add_step(Eigen::Index right);
    void make_orthogonal(double length);
    void use_newest();
    void make_room();

    const LinearEquations equations_;
    const Eigen::Index size_, most_;
    Eigen::Index count_ = 0;
    // Columns: what the matrix makes of directions; the directions, which only symmetric equations need; the sums of
    // them; shares of them in the solutions, by rows. Images are orthonormal, or the directions conjugate.
    Matrix images_, directions_, direction_sums_, shares_;
    Matrix residuals_, sums_;  // of the right-hand sides; residuals weighted unless symmetric
    std::vector<State> states_;
    Vector residual_, step_, image_, step_sums_;
    bool converged_ = false;
    double largest_ = 0;
};

}  // namespace contactd
