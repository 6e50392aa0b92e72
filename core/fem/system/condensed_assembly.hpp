// Assembles the stiffness matrix without the nodes inside elements, which are eliminated element by element (static
// condensation). It is the lower half of a sparse matrix, on one process.
#pragma once

#include <vector>

#include <Eigen/SparseCore>

#include "contactd/material.hpp"
#include "linear_system.hpp"

namespace contactd::fem {

class CondensedAssembly {
   public:
    explicit CondensedAssembly(mfem::ParFiniteElementSpace& space);

    /// Returns for each node of the space its number in the matrix, whose rows are 3 number + axis; -1 inside an
    /// element.
    const std::vector<int>& node_numbers() const { return number_; }

    Eigen::SparseMatrix<double> assemble(const Material& material, const AssemblyMonitor& monitor);

   private:
    std::vector<int> outer_nodes(int element) const;  ///< numbers of an element's remaining nodes, in MFEM's order
    void find_neighbours();
    Eigen::SparseMatrix<double> empty_matrix() const;
    void add(const std::vector<int>& nodes, const Eigen::MatrixXd& stiffness, Eigen::SparseMatrix<double>& lower) const;

    mfem::ParFiniteElementSpace& space_;
    std::vector<int> number_;
    int count_ = 0;
    std::vector<std::vector<int>> below_;  ///< for each numbered node: itself and its neighbours of larger number
};

}  // namespace contactd::fem
