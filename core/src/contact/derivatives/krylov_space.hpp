// Solves linear equations with one matrix and several right-hand sides. The outputs are a few sums of the solutions.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "contactd/observer.hpp"

namespace contactd {

struct LinearEquations {
    using Vector = Eigen::VectorXd;

    std::function<void(const Vector& x, Vector& y)> matrix;
    // Computes z ~ matrix^-1 r. `step` counts those for one right-hand side.
    std::function<void(const Vector& r, Vector& z, int step)> precondition;
    // If set, matrix and preconditioner are symmetric and positive definite, and the preconditioner is the same in all
    // steps.
    bool symmetric = false;
    Vector weights;           // > 0; they measure residuals
    Eigen::MatrixXd outputs;  // columns c: the sums c . x
    Eigen::Index kept = 0;    // number of leading components of the solutions that are kept; symmetric: all are
};

// Makes steps of the preconditioner for each right-hand side in turn; all right-hand sides use them. The combination of
// steps has the smallest residual (GCR; Eisenstat, Elman and Schultz 1983), or for symmetric equations the smallest
// energy of the error (conjugate gradients with several right-hand sides; O'Leary 1980). In the symmetric case, sums
// with the right-hand sides have the square of that error.
class KrylovSpace {
   public:
    using Vector = LinearEquations::Vector;
    using Matrix = Eigen::MatrixXd;

    struct Right {
        Vector values;
        double size;         // weighted length of the vectors whose difference it is
        Vector known;        // to be added to its sums
        double measure = 1;  // factor on its length, to which the residual is relative
    };
    using Change = std::function<double(const Vector& now, const Vector& before)>;
    struct Tolerance {
        double residual;  // relative
        // Limits the change of the sums that future steps are expected to make, measured by change_of; 0: only
        // residuals count.
        double change = 0;
        Change change_of{};
    };

    explicit KrylovSpace(LinearEquations equations);

    // Solves to the tolerance, or until the memory for steps is full. It must be called only once.
    void solve(const std::vector<Right>& rights, const Tolerance& tolerance, const Observer& observer);

    bool converged() const { return converged_; }
    double residual() const { return largest_; }
    int steps() const { return static_cast<int>(count_); }
    // Returns the sums of one right-hand side.
    Vector sums(std::size_t right) const { return sums_.col(static_cast<Eigen::Index>(right)); }
    // Returns the components of x that are kept.
    Vector solution(std::size_t right) const;

   private:
    struct State {
        double length = 0, change = 1;
        int steps = 0;
        bool ended = false;
    };

    void begin(const std::vector<Right>& rights);
    double relative(Eigen::Index right) const;
    // Returns whether another step was possible.
    bool add_step(Eigen::Index right);
    void make_orthogonal(double length);
    void use_newest();
    void make_room();

    const LinearEquations equations_;
    const Eigen::Index size_, kept_, most_;
    Eigen::Index count_ = 0;
    // Columns are the images of directions under the matrix, the kept components of the directions, their sums, and, in
    // rows, their shares in the solutions. Images are orthonormal, or directions conjugate.
    Matrix images_, directions_, direction_sums_, shares_;
    Matrix residuals_, sums_;  // for the right-hand sides; residuals weighted unless symmetric
    std::vector<State> states_;
    Vector residual_, step_, image_, step_sums_;
    bool converged_ = false;
    double largest_ = 0;
};

}  // namespace contactd
