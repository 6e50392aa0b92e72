// Implements finite elements along one axis; elements of a block divided by planes are products of them.
#pragma once

#include <vector>

#include <Eigen/Core>

namespace contactd::fem {

/// Describes continuous functions that are polynomials of order p between neighbouring planes. Their nodes are the
/// Gauss-Lobatto points of the intervals, ascending. Matrices have the shape [nodes, nodes]; all integrals are exact.
class AxisElements {
   public:
    /// `planes` ascend strictly; there are at least two.
    AxisElements(std::vector<double> planes, int order);

    Eigen::Index nodes() const { return positions_.size(); }
    const Eigen::VectorXd& positions() const { return positions_; }  ///< of the nodes
    const Eigen::MatrixXd& mass() const { return mass_; }            ///< (a, b): integral of N_a N_b
    const Eigen::MatrixXd& stiffness() const { return stiffness_; }  ///< of N_a' N_b'
    const Eigen::MatrixXd& slope() const { return slope_; }          ///< of N_a N_b'

    /// Returns the functions at points between the first plane and the last, shape [points, nodes].
    Eigen::MatrixXd values_at(const std::vector<double>& points) const;

   private:
    std::vector<double> planes_;
    int order_;
    Eigen::VectorXd positions_;
    Eigen::MatrixXd mass_, stiffness_, slope_;
};

/// Holds functions that diagonalise mass and stiffness together; their mass matrix is the identity.
struct AxisModes {
    Eigen::MatrixXd vectors;    ///< shape [nodes, modes]; rows of prescribed ends are zero
    Eigen::VectorXd stiffness;  ///< eigenvalue of each mode, not negative
};

enum class AxisEnd { free, given };

/// Returns the modes of all functions that vanish at the prescribed ends.
AxisModes modes_of(const AxisElements& elements, AxisEnd first, AxisEnd last);

}  // namespace contactd::fem
