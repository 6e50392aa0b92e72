// Finite elements along one axis, of which those of a block divided by planes are products.
#pragma once

#include <vector>

#include <Eigen/Core>

namespace contactd::fem {

/// Continuous functions that are polynomials of order p between neighbouring planes. Their nodes are the Gauss-Lobatto
/// points of the intervals, ascending. Matrices are of shape [nodes, nodes]; all integrals are exact.
class AxisElements {
   public:
    /// `planes` ascend strictly, two at least.
    AxisElements(std::vector<double> planes, int order);

    Eigen::Index nodes() const { return positions_.size(); }
    const Eigen::VectorXd& positions() const { return positions_; }  ///< of the nodes
    const Eigen::MatrixXd& mass() const { return mass_; }            ///< (a, b): integral of N_a N_b
    const Eigen::MatrixXd& stiffness() const { return stiffness_; }  ///< of N_a' N_b'
    const Eigen::MatrixXd& slope() const { return slope_; }          ///< of N_a N_b'

    /// Shape [points, nodes]: the functions at points between the first plane and the last.
    Eigen::MatrixXd values_at(const std::vector<double>& points) const;

   private:
    std::vector<double> planes_;
    int order_;
    Eigen::VectorXd positions_;
    Eigen::MatrixXd mass_, stiffness_, slope_;
};

/// Functions that diagonalise mass and stiffness together: their mass matrix is the identity.
struct AxisModes {
    Eigen::MatrixXd vectors;    ///< shape [nodes, modes]; rows of ends that are given are zero
    Eigen::VectorXd stiffness;  ///< of each mode, not negative
};

enum class AxisEnd { free, given };

/// The modes of all functions that vanish at the ends that are given.
AxisModes modes_of(const AxisElements& elements, AxisEnd first, AxisEnd last);

}  // namespace contactd::fem
