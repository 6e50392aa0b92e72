// Computes coefficients of a longitudinally uniform body in three dimensions, to check the transform along x.
#pragma once

#include "contactd/observer.hpp"
#include "contactd/strip_table.hpp"
#include "section/solid_mesh.hpp"

namespace contactd::fem {

struct SolidSpec {
    Solver solver = Solver::amg_pcg;
    int order = 2;          ///< of the elements
    MeshDensity density{};  ///< of the section's mesh
    Slices slices{};
    int nx = 1;  ///< offsets 0..nx-1 of a strip's width along x
};

struct SolidTable {
    StripTable table;  ///< for G = 1 and ds = 1, on elements as long as wide, symmetric like the transform's table
    long long elements = 0, dofs = 0;
    int loads = 0, iterations = 0;                                      ///< iterations of all loads together
    double assembly_seconds = 0, setup_seconds = 0, solve_seconds = 0;  ///< of all loads together
};

/// Collective. Each strip in turn carries a unit traction along each axis on a mesh of the paper's kind (Mesh2). The
/// paper's solver is BoomerAMG with conjugate gradients, but elements of order three are faster with a factorisation.
/// Suitable for a few strips only: eighty would take hours. Throws as make_solid_mesh() does, and NotConverged.
SolidTable build_solid_table(MPI_Comm comm, const SectionOutline& outline, double nu, const SolidSpec& solid,
                             Observer& observer);

/// Returns the degrees of freedom of a load's problem; makes only its mesh.
long long solid_dofs(const SectionOutline& outline, const SolidSpec& solid);

}  // namespace contactd::fem
