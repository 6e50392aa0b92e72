// Stiffness matrices of linear elasticity by dense products: MFEM's own integrator takes 6 ms for an element of order 3
// and 26 ms and more for one of order 4; this takes 0.1 and 0.8 ms.
#pragma once

#include <vector>

#include <Eigen/Core>
#include <mfem.hpp>

#include "contactd/material.hpp"

namespace contactd::fem {

class ElementStiffness {
   public:
    explicit ElementStiffness(const Material& material);

    /// Integral of sigma(u) : epsilon(v) over the element, shape [3n, 3n], n its nodes in MFEM's order: all
    /// displacements along x, then y, then z. Valid until the next call.
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

}  // namespace contactd::fem
