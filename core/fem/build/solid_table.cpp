#include "solid_table.hpp"

#include <utility>

#include "mesh_build.hpp"

namespace contactd::fem {
namespace {

IcSpec spec_of(const SectionOutline& outline, double nu, const SolidSpec& solid) {
    IcSpec spec;
    spec.source = IcSource::fem;
    spec.material = {1, nu};
    spec.dx = spec.dy = 1;
    spec.nx = solid.nx;
    spec.ny = outline.strips;
    spec.fem.mesh = MeshKind::prism;
    spec.fem.order = solid.order;
    spec.fem.far_boundary = FarBoundary::clamped;
    spec.fem.solver = solid.solver;
    return spec;
}

/// Extracts the table of offsets from a strip. Its rows are strips, because the mesh begins with the first of them.
void add_strip(const IcTable& rows, int strip, StripTable& table) {
    for (const Axis i : {Axis::x, Axis::y, Axis::z})
        for (const Axis j : {Axis::x, Axis::y, Axis::z})
            for (int I = 0; I < rows.ny; ++I)
                for (int k = 0; k < rows.nx; ++k) table(i, j, I, strip, k) = rows(i, j, k, I);
}

}  // namespace

SolidTable build_solid_table(MPI_Comm comm, const SectionOutline& outline, double nu, const SolidSpec& solid,
                             Observer& observer) {
    const DividedOutline divided = divide(outline, solid.density);
    const Triangulation triangulation = triangulate(divided, solid.density);
    CollectiveObserver collective(comm, observer);
    SolidTable result;
    result.table = StripTable(solid.nx, outline.strips);
    for (int strip = 0; strip < outline.strips; ++strip) {
        ElasticityProblem problem(comm, spec_of(outline, nu, solid),
                                  make_solid_mesh(outline, divided, triangulation, strip, solid.slices));
        const double share = 1.0 / outline.strips;
        const IcRecord record =
            solve_and_sample(problem, [](ElasticityProblem& of, Axis load) { return of.load_case(load); },
                             {&collective, strip * share, share});
        add_strip(record.table(), strip, result.table);
        const IcEvidence& evidence = record.evidence;
        result.elements = evidence.elements;
        result.dofs = evidence.dofs;
        for (const LoadCaseEvidence& one : evidence.load_cases) {
            ++result.loads;
            result.iterations += one.iterations;
        }
        result.assembly_seconds += evidence.seconds.assembly;
        result.setup_seconds += evidence.seconds.setup;
        result.solve_seconds += evidence.seconds.solve;
    }
    result.table = symmetrised(std::move(result.table));
    return result;
}

long long solid_dofs(const SectionOutline& outline, const SolidSpec& solid) {
    const DividedOutline divided = divide(outline, solid.density);
    BlockMesh block = make_solid_mesh(outline, divided, triangulate(divided, solid.density), 0, solid.slices);
    const mfem::H1_FECollection collection(solid.order, 3);
    return mfem::FiniteElementSpace(&block.mesh, &collection, 3).GetTrueVSize();
}

}  // namespace contactd::fem
