// Linear equations with one matrix and several right-hand sides.
#pragma once

#include <Eigen/Core>
#include <functional>

#include "contactd/observer.hpp"

namespace contactd {

// By conjugate residuals: of the combinations of all steps so far, also those of right-hand sides before, the one that
// leaves the least residual, then a step of the preconditioner (GCR; Eisenstat, Elman and Schultz 1983).
class KrylovSpace {
   public:
    using Vector = Eigen::VectorXd;
    using Map = std::function<void(const Vector& from, Vector& to)>;

    // `precondition` may differ from call to call.
    KrylovSpace(Eigen::Index size, Map matrix, Map precondition);

    struct Solution {
        Vector x, residual;
        double relative = 0;  // length of the residual, over that of the right-hand side
    };
    // To the relative `tolerance`, or until no more steps are kept. `size` is the length of what the right-hand side is
    // a difference of.
    Solution solve(const Vector& right, double size, double tolerance, const Observer& observer);
    int steps() const { return static_cast<int>(count_); }

   private:
    bool add_step(const Vector& residual);
    void make_room();

    Map matrix_, precondition_;
    Eigen::Index most_, count_ = 0;
    // Columns: steps z, orthonormal v, and what the matrix makes of the steps, v times a triangle.
    Eigen::MatrixXd steps_, images_, triangle_;
    Vector step_, image_;
};

}  // namespace contactd
