// Assembles the elasticity of a body that is uniform along x, under loads proportional to cos(xi x) or sin(xi x).
//
// With u_x = w sin(xi x), u_y = v cos(xi x), u_z = t cos(xi x) the strains are e_xx = xi w, e_yy = v_y, e_zz = t_z,
// g_yz = v_z + t_y (times cos) and g_xy = w_y - xi v, g_xz = w_z - xi t (times sin). The energy of
// lambda (e_xx + e_yy + e_zz)^2 + 2 mu (e_xx^2 + e_yy^2 + e_zz^2) + mu (g_yz^2 + g_xy^2 + g_xz^2), mu = 1, gives one
// real symmetric matrix K0 + xi K1 + xi^2 K2 of (w, v, t), positive definite when the section is clamped or xi > 0.
#pragma once

#include <vector>

#include "section/section_mesh.hpp"

namespace contactd::fem {

/// Holds the lower triangle of a symmetric matrix by columns, rows ascending: the pattern of all wavenumbers.
struct LowerPattern {
    std::vector<int> begin;  ///< start of each column, and the number of entries
    std::vector<int> row;
    int size() const { return static_cast<int>(begin.size()) - 1; }
};

class WaveMatrices {
   public:
    /// G = 1. Nodes on clamped edges are omitted.
    WaveMatrices(const SectionMesh& mesh, int order, double nu);

    const LowerPattern& pattern() const { return pattern_; }
    std::vector<double> at(double xi) const;

    const mfem::FiniteElementSpace& space() const { return *space_; }
    /// Returns the first of the three unknowns w, v, t of a scalar node, or -1 if it is clamped.
    int unknown(int node) const { return number_[static_cast<std::size_t>(node)] < 0 ? -1 : 3 * number_[node]; }

   private:
    void number_nodes(const SectionMesh& mesh);
    void make_pattern();
    void assemble(double nu);
    std::size_t entry(int row, int column) const;  ///< of unknowns, row >= column

    mfem::H1_FECollection collection_;
    std::unique_ptr<mfem::FiniteElementSpace> space_;
    std::vector<int> number_;
    int free_nodes_ = 0;
    LowerPattern nodes_;  ///< of scalar nodes
    LowerPattern pattern_;
    std::vector<double> k0_, k1_, k2_;
};

}  // namespace contactd::fem
