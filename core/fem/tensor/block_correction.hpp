// The correction of displacements of the half-space to those of the block [-L, L]^2 x [-L, 0], whose faces are clamped:
// no traction, and on these faces the half-space's displacements taken back. It is smooth but near the block's edges.
#pragma once

#include <memory>
#include <vector>

#include "contactd/ic_spec.hpp"
#include "tensor_elasticity.hpp"

namespace contactd::fem {

/// A mesh: order of its elements, and their number along each axis, four at least.
struct BlockLevel {
    int order;
    int intervals;
};

/// Where the centre of a loaded element lies, x and y not negative.
struct LoadPlace {
    double x = 0, y = 0;
};

class BlockCorrection {
   public:
    /// `spec`: dimensionless, body block, for one Poisson's ratio.
    BlockCorrection(const IcSpec& spec, const BlockLevel& level);

    /// Called before each iteration with how far the solve has come.
    using Monitor = std::function<void(double fraction, int iteration, double residual, double seconds)>;

    /// One load, solved. A load beside the middle is the sum of up to four that are symmetric to both planes.
    class Solution {
       public:
        /// While the BlockCorrection lives: displacement along `i` at the points (xs, ys) of the surface, of any sign:
        /// shape [ys, xs].
        Eigen::MatrixXd at(Axis i, const std::vector<double>& xs, const std::vector<double>& ys) const;
        const SolveResult& result() const { return result_; }  ///< of all parts: iterations added, the largest residual

       private:
        friend class BlockCorrection;
        struct Part {
            std::shared_ptr<const TensorElasticity> system;
            Eigen::VectorXd modes;
            PerAxis<Eigen::MatrixXd> given;  ///< on the surface, at its nodes: shape [y, x], zero but at the far ends
            PerAxis<double> sign_x, sign_y;  ///< of each component across x = 0 and y = 0
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
