// Describes linear elasticity of the quarter block under a unit traction, div sigma(u) = 0, for the three load
// directions: the finite-element space, and the values that each load prescribes. `linear_system.hpp` assembles the
// equations.
#pragma once

#include <memory>
#include <vector>

#include <mfem.hpp>

#include "contactd/ic_table.hpp"
#include "mesh/block_mesh.hpp"

namespace contactd::fem {

/// Holds the values that a load direction prescribes, in true degrees of freedom.
struct LoadCase {
    mfem::Array<int> essential;  ///< degrees of freedom with prescribed displacements, ascending
    mfem::Vector given;          ///< these displacements, zero elsewhere
    mfem::Vector forces;         ///< of the unit traction
};

/// Uses vector H1 elements on the quarter block, with the dofs of a node side by side (byVDIM), distributed in slices
/// from the origin outwards.
class ElasticityProblem {
   public:
    /// Collective. `spec` must be dimensionless, with a given mesh. Throws InvalidArgument if there are more processes
    /// than elements.
    ElasticityProblem(MPI_Comm comm, const IcSpec& spec) : ElasticityProblem(comm, spec, make_block_mesh(spec)) {}
    ElasticityProblem(MPI_Comm comm, const IcSpec& spec, BlockMesh block);

    /// Collective. Applies Table 1 of the paper for a load along `load`: symmetry conditions, displacements of the far
    /// boundary, and the unit traction (with the load's shape) on the quarter of the load.
    LoadCase load_case(Axis load);

    const IcSpec& spec() const { return spec_; }
    mfem::ParFiniteElementSpace& space() { return *space_; }
    long long elements() const { return elements_; }
    long long dofs() const { return space_->GlobalTrueVSize(); }
    int processes() const { return processes_; }

    /// Returns the place of the surface point (-X, -Y, 0) with the number of its element on this process, or -1 if it
    /// is on another process.
    ElementPoint locate(double X, double Y) const;

   private:
    LoadCase empty_case(Axis load);
    std::vector<int> owners() const;  ///< process of each element
    mfem::Array<int> essential_dofs(Axis load, const std::vector<BoundaryPart>& parts);
    void give_far_displacements(Axis load, LoadCase& result);

    MPI_Comm comm_;
    int rank_ = 0, processes_ = 1;
    IcSpec spec_;
    long long elements_ = 0;
    std::function<ElementPoint(double, double)> locate_;
    std::vector<int> local_number_;  ///< number of each element of the whole mesh; -1 for elements elsewhere
    std::unique_ptr<mfem::ParMesh> mesh_;
    mfem::H1_FECollection collection_;
    std::unique_ptr<mfem::ParFiniteElementSpace> space_;
};

}  // namespace contactd::fem
