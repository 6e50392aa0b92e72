#include "elasticity_problem.hpp"

#include <string>

#include "contactd/error.hpp"

namespace contactd::fem {
namespace {

constexpr int assembly_chunks = 16;

/// Components that vanish on a plane of symmetry (Table 1): across x = 0, u_i keeps or changes its sign by its parity,
/// and what changes its sign is zero there. The others are natural.
bool vanishes(Axis component, Axis load, BoundaryPart part) {
    const Parity sign = parity(component, load);
    switch (part) {
        case BoundaryPart::front:
            return sign.along_x < 0;
        case BoundaryPart::right:
            return sign.along_y < 0;
        case BoundaryPart::far:
            return true;
        default:
            return false;
    }
}

mfem::Array<int> marker(std::initializer_list<BoundaryPart> parts) {
    mfem::Array<int> result(static_cast<int>(BoundaryPart::far));
    result = 0;
    for (const BoundaryPart part : parts) result[static_cast<int>(part) - 1] = 1;
    return result;
}

mfem::Array<int> essential_dofs(mfem::ParFiniteElementSpace& space, Axis load) {
    mfem::Array<int> result;
    for (const BoundaryPart part : {BoundaryPart::front, BoundaryPart::right, BoundaryPart::far})
        for (const Axis component : {Axis::x, Axis::y, Axis::z}) {
            if (!vanishes(component, load, part)) continue;
            mfem::Array<int> dofs;
            space.GetEssentialTrueDofs(marker({part}), dofs, static_cast<int>(component));
            result.Append(dofs);
        }
    result.Sort();
    result.Unique();
    return result;
}

}  // namespace

ElasticityProblem::ElasticityProblem(MPI_Comm comm, const IcSpec& spec)
    : comm_(comm), spec_(spec), shells_(make_shells(spec)), elements_(spec.fem.order, 3) {
    MPI_Comm_rank(comm, &rank_);
    MPI_Comm_size(comm, &processes_);
    if (processes_ > shells_.elements())
        throw InvalidArgument("ics.h_over_hs", "gives a mesh of " + std::to_string(shells_.elements()) +
                                                   " elements, fewer than the " + std::to_string(processes_) +
                                                   " processes it shall be distributed to");
    mfem::Mesh whole = make_quarter_block(shells_);
    // Slices from the origin outwards touch in one shell each, which no graph partitioner betters.
    mfem::Array<int> owner(whole.GetNE());
    for (int rank = 0; rank < processes_; ++rank) {
        const auto [first, last] = own_elements(rank);
        for (long long i = first; i < last; ++i) owner[static_cast<int>(i)] = rank;
    }
    mesh_ = std::make_unique<mfem::ParMesh>(comm, whole, owner.GetData());
    space_ = std::make_unique<mfem::ParFiniteElementSpace>(mesh_.get(), &elements_, 3, mfem::Ordering::byVDIM);
}

std::array<long long, 2> ElasticityProblem::own_elements(int rank) const {
    return {shells_.elements() * rank / processes_, shells_.elements() * (rank + 1) / processes_};
}

int ElasticityProblem::local_element(int element) const {
    const auto [first, last] = own_elements(rank_);
    return element >= first && element < last ? static_cast<int>(element - first) : -1;
}

void ElasticityProblem::assemble(const std::function<void(double)>& on_chunk) {
    const double G = spec_.material.G, nu = spec_.material.nu;
    mfem::ConstantCoefficient lambda(2 * G * nu / (1 - 2 * nu)), mu(G);
    mfem::ElasticityIntegrator integrator(lambda, mu);
    // (p+1)^3 points: fewer make the matrix singular, more change nothing that can be seen.
    const mfem::IntegrationRule& rule = mfem::IntRules.Get(mfem::Geometry::CUBE, 2 * spec_.fem.order + 1);
    integrator.SetIntRule(&rule);

    mfem::ParBilinearForm form(space_.get());
    mfem::DenseMatrix element_matrix;
    mfem::Array<int> vdofs;
    const int count = mesh_->GetNE();
    int element = 0;
    for (int chunk = 1; chunk <= assembly_chunks; ++chunk) {
        const auto end = static_cast<int>(1LL * count * chunk / assembly_chunks);
        for (; element < end; ++element) {
            integrator.AssembleElementMatrix(*space_->GetFE(element), *space_->GetElementTransformation(element),
                                             element_matrix);
            form.AssembleElementMatrix(element, element_matrix, vdofs);
        }
        on_chunk(static_cast<double>(chunk) / assembly_chunks);
    }
    form.Finalize();
    unconstrained_.reset(form.ParallelAssemble());
}

LoadCase ElasticityProblem::load_case(Axis load) {
    const mfem::Array<int> essential = essential_dofs(*space_, load);

    LoadCase result;
    result.A = std::make_unique<mfem::HypreParMatrix>(*unconstrained_);
    result.A->EliminateBC(essential, mfem::Operator::DIAG_KEEP);

    mfem::Vector direction(3);
    direction = 0.0;
    direction[static_cast<int>(load)] = 1;
    mfem::VectorConstantCoefficient traction(direction);
    mfem::Array<int> loaded = marker({BoundaryPart::loaded});
    mfem::ParLinearForm form(space_.get());
    form.AddBoundaryIntegrator(new mfem::VectorBoundaryLFIntegrator(traction), loaded);
    form.Assemble();
    result.b.SetSize(space_->GetTrueVSize());
    form.ParallelAssemble(result.b);
    result.b.SetSubVector(essential, 0.0);
    return result;
}

}  // namespace contactd::fem
