// Corrects displacements of the half-space to those of the block [-L, L]^2 x [-L, 0] with clamped faces. The correction
// has no traction on the surface, and cancels the half-space's displacements on these faces. It is smooth except near
// the block's edges.
#pragma once

#include <memory>
#include <vector>

#include "contactd/ic_spec.hpp"
#include "tensor_elasticity.hpp"

namespace contactd::fem {

/// Describes a mesh: the order of its elements, and their number along each axis, at least four.
struct BlockLevel {
    int order;
    int intervals;
};

/// Holds the position of the centre of a loaded element, with x and y not negative.
struct LoadPlace {
    double x = 0, y = 0;
};

class BlockCorrection {
   public:
    /// `spec` is dimensionless, for a block and one Poisson's ratio.
    BlockCorrection(const IcSpec& spec, const BlockLevel& level);

    /// Called before each iteration with the progress of the solve.
    using Monitor = std::function<void(double fraction, int iteration, double residual, double seconds)>;

    /// Solves one load. A load beside the middle is the sum of up to four loads that are symmetric or odd about both
    /// planes.
    class Solution {
       public:
        /// Returns the displacement along `i` at the points (xs, ys) of the surface, of any sign: shape [ys, xs]. Valid
        /// as long as the BlockCorrection exists.
        Eigen::MatrixXd at(Axis i, const std::vector<double>& xs, const std::vector<double>& ys) const;
        const SolveResult& result() const { return result_; }  ///< for all parts: the total and the largest one

       private:
        friend class BlockCorrection;
        struct Part {
            std::shared_ptr<const TensorElasticity> system;
            Eigen::VectorXd modes;
            PerAxis<Eigen::MatrixXd> given;  ///< at its surface nodes: shape [y, x], zero except at the far ends
            PerAxis<double> sign_x, sign_y;  ///< symmetry of each component across x = 0 and y = 0
        };
        const BlockCorrection* of_ = nullptr;
        std::vector<Part> parts_;
        SolveResult result_;
    };

    Solution solve(Axis load, const LoadPlace& place, const Monitor& monitor) const;

    long long elements() const { return elements_; }
    long long dofs() const;

   private:
    PerAxis<TensorField> far_displacements(Axis load, const LoadPlace& place, const PerAxis<double>& sign_x,
                                           const PerAxis<double>& sign_y) const;

    IcSpec spec_;
    long long elements_;
    PerAxis<AxisElements> axes_;
};

}  // namespace contactd::fem
