// Linear elasticity of the quarter block under a unit traction, div sigma(u) = 0, for the three load directions.
#pragma once

#include <functional>
#include <memory>

#include <mfem.hpp>

#include "contactd/ic_table.hpp"
#include "quarter_block.hpp"

namespace contactd::fem {

/// The system of one load case: essential rows and columns eliminated, true degrees of freedom.
struct LoadCase {
    std::unique_ptr<mfem::HypreParMatrix> A;
    mfem::Vector b;
};

/// Vector H1 elements on Mesh1, the dofs of a node side by side (byVDIM), distributed in slices from the origin
/// outwards. The matrix is assembled once, without constraints; each load case eliminates its own.
class ElasticityProblem {
   public:
    /// Collective. `spec` must be dimensionless. Throws InvalidArgument when there are more processes than elements.
    ElasticityProblem(MPI_Comm comm, const IcSpec& spec);

    /// Collective. `on_chunk(fraction)` is called at the same points by all processes.
    void assemble(const std::function<void(double)>& on_chunk);

    /// Collective. Table 1 of the paper: essential conditions of the load's direction, u = 0 on the far faces, unit
    /// traction along `load` on the quarter of the loaded element.
    LoadCase load_case(Axis load);

    const Shells& shells() const { return shells_; }
    mfem::ParFiniteElementSpace& space() { return *space_; }
    long long dofs() const { return space_->GlobalTrueVSize(); }

    /// Number on this process of an element of the whole mesh, or -1 when another process has it.
    int local_element(int element) const;

   private:
    std::array<long long, 2> own_elements(int rank) const;  ///< first and one past the last

    MPI_Comm comm_;
    int rank_ = 0, processes_ = 1;
    IcSpec spec_;
    Shells shells_;
    std::unique_ptr<mfem::ParMesh> mesh_;
    mfem::H1_FECollection elements_;
    std::unique_ptr<mfem::ParFiniteElementSpace> space_;
    std::unique_ptr<mfem::HypreParMatrix> unconstrained_;
};

}  // namespace contactd::fem
