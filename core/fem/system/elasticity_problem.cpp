#include "elasticity_problem.hpp"

#include <string>

#include "contactd/error.hpp"
#include "contactd/half_space.hpp"

namespace contactd::fem {
namespace {

/// Returns the components that vanish on a plane of symmetry (Table 1). Across x = 0, u_i keeps or changes its sign by
/// its parity; components that change their sign are zero there. The others are natural. On the far faces all
/// components are prescribed.
bool is_given(Axis component, Axis load, BoundaryPart part) {
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

mfem::Array<int> marker(BoundaryPart part) {
    mfem::Array<int> result(static_cast<int>(BoundaryPart::far));
    result = 0;
    result[static_cast<int>(part) - 1] = 1;
    return result;
}

mfem::Vector unit(Axis axis) {
    mfem::Vector result(3);
    result = 0.0;
    result[static_cast<int>(axis)] = 1;
    return result;
}

}  // namespace

ElasticityProblem::ElasticityProblem(MPI_Comm comm, const IcSpec& spec, BlockMesh block)
    : comm_(comm), spec_(spec), locate_(std::move(block.locate)), collection_(spec.fem.order, 3) {
    MPI_Comm_rank(comm, &rank_);
    MPI_Comm_size(comm, &processes_);
    elements_ = block.mesh.GetNE();
    if (processes_ > elements_)
        throw InvalidArgument("ics.h_over_hs", "results in a mesh of " + std::to_string(elements_) +
                                                   " elements, fewer than the " + std::to_string(processes_) +
                                                   " processes of the build");
    std::vector<int> owner = owners();
    mesh_ = std::make_unique<mfem::ParMesh>(comm, block.mesh, owner.data());
    int own = 0;
    for (const int process : owner) local_number_.push_back(process == rank_ ? own++ : -1);
    space_ = std::make_unique<mfem::ParFiniteElementSpace>(mesh_.get(), &collection_, 3, mfem::Ordering::byVDIM);
}

// Slices from the origin outwards touch along one shell each; no graph partitioner does better.
std::vector<int> ElasticityProblem::owners() const {
    std::vector<int> result(static_cast<std::size_t>(elements_));
    for (int rank = 0; rank < processes_; ++rank)
        for (long long i = elements_ * rank / processes_; i < elements_ * (rank + 1) / processes_; ++i)
            result[static_cast<std::size_t>(i)] = rank;
    return result;
}

ElementPoint ElasticityProblem::locate(double X, double Y) const {
    ElementPoint result = locate_(X, Y);
    result.element = local_number_[static_cast<std::size_t>(result.element)];
    return result;
}

mfem::Array<int> ElasticityProblem::essential_dofs(Axis load, const std::vector<BoundaryPart>& parts) {
    mfem::Array<int> result;
    for (const BoundaryPart part : parts)
        for (const Axis component : {Axis::x, Axis::y, Axis::z}) {
            if (!is_given(component, load, part)) continue;
            mfem::Array<int> dofs;
            space_->GetEssentialTrueDofs(marker(part), dofs, static_cast<int>(component));
            result.Append(dofs);
        }
    result.Sort();
    result.Unique();
    return result;
}

void ElasticityProblem::give_far_displacements(Axis load, LoadCase& result) {
    mfem::VectorFunctionCoefficient displacement(3, [&](const mfem::Vector& at, mfem::Vector& u) {
        const auto value = half_space_displacement(spec_, load, {at[0], at[1], at[2]});
        for (int i = 0; i < 3; ++i) u[i] = value[static_cast<std::size_t>(i)];
    });
    mfem::ParGridFunction u(space_.get());
    u = 0.0;
    mfem::Array<int> far = marker(BoundaryPart::far);
    u.ProjectBdrCoefficient(displacement, far);
    mfem::Vector true_values;
    u.GetTrueDofs(true_values);
    for (const int dof : essential_dofs(load, {BoundaryPart::far})) result.given[dof] = true_values[dof];
    for (const int dof : essential_dofs(load, {BoundaryPart::front, BoundaryPart::right})) result.given[dof] = 0;
}

LoadCase ElasticityProblem::empty_case(Axis load) {
    LoadCase result;
    result.essential = essential_dofs(load, {BoundaryPart::front, BoundaryPart::right, BoundaryPart::far});
    for (mfem::Vector* vector : {&result.given, &result.forces}) {
        vector->SetSize(space_->GetTrueVSize());
        *vector = 0.0;
    }
    return result;
}

LoadCase ElasticityProblem::load_case(Axis load) {
    LoadCase result = empty_case(load);
    if (spec_.fem.far_boundary == FarBoundary::half_space) give_far_displacements(load, result);

    const mfem::Vector direction = unit(load);
    mfem::VectorFunctionCoefficient traction(3, [&](const mfem::Vector& at, mfem::Vector& value) {
        value = direction;
        if (spec_.load_shape == LoadShape::bilinear) value *= (1 + at[0] / spec_.dx) * (1 + at[1] / spec_.dy);
    });
    mfem::Array<int> loaded = marker(BoundaryPart::loaded);
    mfem::ParLinearForm form(space_.get());
    auto* integrator = new mfem::VectorBoundaryLFIntegrator(traction);  // the form deletes it
    const int degree = 2 * spec_.fem.order + 2;  // the bilinear map, times the hat function, times the shape function
    const mfem::IntegrationRule& rule = mfem::IntRules.Get(mfem::Geometry::SQUARE, degree);
    integrator->SetIntRule(&rule);
    form.AddBoundaryIntegrator(integrator, loaded);
    form.Assemble();
    form.ParallelAssemble(result.forces);
    return result;
}

}  // namespace contactd::fem
