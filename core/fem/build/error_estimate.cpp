#include "error_estimate.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace contactd::fem {
namespace {

/// These offsets represent all others. They are dense near the origin, where displacements vary most.
std::vector<int> chosen_indices(int count) {
    std::vector<int> result;
    for (int k = 0; k < count - 1; k = std::max(k + 1, k * 5 / 4)) result.push_back(k);
    result.push_back(count - 1);
    return result;
}

struct Offset {
    double x, y;  ///< negative, because the mesh is the quarter block
    double rho;   ///< distance from the load, at least its size
};

std::vector<Offset> chosen_offsets(const IcSpec& spec) {
    const double size_of_load = 0.5 * std::sqrt(spec.dx * spec.dy);
    std::vector<Offset> result;
    for (const int l : chosen_indices(spec.ny))
        for (const int k : chosen_indices(spec.nx)) {
            const double x = k * spec.dx, y = l * spec.dy;
            result.push_back({-x, -y, std::max(std::hypot(x, y), size_of_load)});
        }
    return result;
}

/// Closer to an element, the displacements of a point load are not smooth in it, but those of the computed load are.
/// Among 1.5, 2 and 3 element sizes, this one reduces errors most evenly.
constexpr double nearest = 2;

}  // namespace

std::vector<double> energy_errors(ElasticityProblem& problem, const std::vector<Solution>& solutions) {
    const auto [G, nu] = problem.spec().material;
    mfem::ConstantCoefficient lambda(2 * G * nu / (1 - 2 * nu)), mu(G);
    mfem::ElasticityIntegrator elasticity(lambda, mu);
    constexpr int stress_components = 6;
    mfem::ParFiniteElementSpace& space = problem.space();
    mfem::ParFiniteElementSpace stresses(space.GetParMesh(), space.FEColl(), stress_components);
    std::vector<double> result(static_cast<std::size_t>(space.GetNE()));
    for (const Solution& solution : solutions) {
        mfem::ParGridFunction u(&space);
        u.SetFromTrueDofs(solution.displacements);
        mfem::ZienkiewiczZhuEstimator estimator(elasticity, u, stresses);
        const mfem::Vector& errors = estimator.GetLocalErrors();
        for (int i = 0; i < errors.Size(); ++i) {
            double& error = result[static_cast<std::size_t>(i)];
            error = std::hypot(error, errors[i]);
        }
    }
    return result;
}

std::vector<double> table_weights(ElasticityProblem& problem) {
    const std::vector<Offset> offsets = chosen_offsets(problem.spec());
    const double order = problem.spec().fem.order;
    mfem::ParMesh& mesh = *problem.space().GetParMesh();
    std::vector<double> result;
    mfem::Vector centre(3);
    for (int i = 0; i < mesh.GetNE(); ++i) {
        mesh.GetElementCenter(i, centre);
        const double size = std::cbrt(mesh.GetElementVolume(i));
        double weight = 0;
        for (const Offset& offset : offsets) {
            const double d = std::hypot(centre[0] - offset.x, centre[1] - offset.y, centre[2]);
            weight = std::max(weight, offset.rho / std::pow(std::max(d, nearest * size), order + 2));
        }
        result.push_back(weight * std::pow(size, order + 1.5));
    }
    return result;
}

}  // namespace contactd::fem
