// Computes stiffness matrices of linear elasticity by dense products. With order 4, this saves some milliseconds per
// element compared with MFEM's own integrator.
#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>
#include <mfem.hpp>

#include "contactd/material.hpp"

namespace contactd::fem {

class ElementStiffness {
   public:
    explicit ElementStiffness(const Material& material);

    /// Returns the integral of sigma(u) : epsilon(v) over the element, shape [3n, 3n], for its n nodes in MFEM's order:
    /// all displacements along x, then y, then z. Valid until the next call.
    const Eigen::MatrixXd& of(const mfem::FiniteElement& element, mfem::ElementTransformation& transformation);

   private:
    void prepare(const mfem::FiniteElement& element);

    double lambda_, mu_;
    const mfem::FiniteElement* prepared_for_ = nullptr;
    const mfem::IntegrationRule* rule_ = nullptr;
    std::vector<mfem::DenseMatrix> reference_gradients_;  ///< [n, 3] at each point
    mfem::DenseMatrix gradients_;                         ///< the same in space
    Eigen::MatrixXd weighted_;                            ///< shape [3n, points]: gradients times sqrt(weight)
    Eigen::MatrixXd products_, stiffness_;
};

/// Called with each element of the space and its stiffness matrix, from the origin outwards.
using VisitStiffness = std::function<void(int element, const Eigen::MatrixXd& stiffness)>;

/// Calls `monitor` with the fraction done and the time (s) expected until the next call, at the same points on all
/// processes.
void for_each_stiffness(mfem::ParFiniteElementSpace& space, const Material& material, const VisitStiffness& visit,
                        const std::function<void(double fraction, double seconds)>& monitor);

}  // namespace contactd::fem
