// Solves linear elasticity of a quarter block divided by planes, in the modes of its axes (fast diagonalisation: Lynch,
// Rice and Thomas, Numer. Math. 6, 185-199, 1964).
//
// On products of functions along x, y and z, the equations are sums of products of matrices of one axis. In modes that
// diagonalise mass and stiffness of each axis, the blocks that couple a component with itself are diagonal. They form
// the preconditioner. A product with the other blocks takes six matrices along an axis. Nothing is factorised.
#pragma once

#include "axis_elements.hpp"
#include "contactd/axis.hpp"
#include "contactd/material.hpp"
#include "system/linear_system.hpp"
#include "tensor_field.hpp"

namespace contactd::fem {

/// The name of its solver in evidence.
inline constexpr const char* tensor_solver = "tensor_pcg";

/// Selects the symmetry: on the planes x = 0 and y = 0, either the displacement across vanishes, or those along the
/// plane.
struct PlaneSymmetry {
    bool x_is_odd = true;  ///< u_x changes its sign across x = 0, and u_y and u_z keep it; otherwise the reverse
    bool y_is_odd = true;  ///< u_y changes its sign across y = 0, and u_x and u_z keep it; otherwise the reverse
};

/// Holds one value for each axis, or each component.
template <class Value>
using PerAxis = std::array<Value, 3>;

/// Describes the block 0 <= x <= L, 0 <= y <= L, -L <= z <= 0, with a free top and prescribed displacements at x = L, y
/// = L and z = -L.
class TensorElasticity {
   public:
    /// The elements of z end at z = 0.
    TensorElasticity(const PerAxis<AxisElements>& elements, const Material& material, const PlaneSymmetry& symmetry);

    /// Returns the forces due to displacements at the nodes of the far faces if the others are fixed: K g, in modes.
    /// `given` is [nodes, nodes, nodes] for each component, zero inside.
    Eigen::VectorXd forces_of(const PerAxis<TensorField>& given) const;

    /// Solves K w = b in modes by conjugate gradients, to a relative residual of `tolerance`. `monitor` is called
    /// before each iteration with its expected time. The residual is the true one.
    SolveResult solve(const Eigen::VectorXd& b, Eigen::VectorXd& w, double tolerance, int max_iterations,
                      const std::function<void(int iteration, double residual, double seconds)>& monitor) const;

    /// Returns component `i` of w on the surface, shape [ys, xs].
    Eigen::MatrixXd on_surface(const Eigen::VectorXd& w, Axis i, const std::vector<double>& xs,
                               const std::vector<double>& ys) const;

   private:
    struct Work;
    const AxisModes& modes(int component, int axis) const;
    void multiply(const Eigen::VectorXd& w, Eigen::VectorXd& result, Work& work) const;

    PerAxis<AxisElements> elements_;
    double lambda_, mu_;
    PerAxis<AxisModes> own_;              ///< for each axis, modes of the component along it
    PerAxis<AxisModes> other_;            ///< modes of the other two components; the same along z
    PerAxis<Eigen::MatrixXd> own_slope_;  ///< along x and y: (p, q) is the integral of p' q, own modes p, others q
    Eigen::MatrixXd shear_;               ///< along z, of u_x or u_y with u_z
    PerAxis<TensorSize> size_;
    PerAxis<Eigen::Index> begin_;  ///< start of each component among the unknowns
    Eigen::VectorXd diagonal_;
};

}  // namespace contactd::fem
