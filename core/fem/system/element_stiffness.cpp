#include "element_stiffness.hpp"

#include <algorithm>
#include <cmath>

namespace contactd::fem {

ElementStiffness::ElementStiffness(const Material& material)
    : lambda_(2 * material.G * material.nu / (1 - 2 * material.nu)), mu_(material.G) {}

void ElementStiffness::prepare(const mfem::FiniteElement& element) {
    // Uses (p+1)^3 points for a hexahedron: fewer make the matrix singular, and more change nothing visible. Prisms are
    // affine, so degree 2p is exact; MFEM's rule of degree 3 has a negative weight.
    const bool prism = element.GetGeomType() == mfem::Geometry::PRISM;
    rule_ = &mfem::IntRules.Get(element.GetGeomType(), 2 * element.GetOrder() + (prism ? 0 : 1));
    const int n = element.GetDof(), points = rule_->GetNPoints();
    reference_gradients_.assign(static_cast<std::size_t>(points), mfem::DenseMatrix(n, 3));
    for (int q = 0; q < points; ++q)
        element.CalcDShape(rule_->IntPoint(q), reference_gradients_[static_cast<std::size_t>(q)]);
    gradients_.SetSize(n, 3);
    weighted_.resize(3 * n, points);
    products_.resize(3 * n, 3 * n);
    stiffness_.resize(3 * n, 3 * n);
    prepared_for_ = &element;
}

const Eigen::MatrixXd& ElementStiffness::of(const mfem::FiniteElement& element,
                                            mfem::ElementTransformation& transformation) {
    if (prepared_for_ != &element) prepare(element);
    const int n = element.GetDof();
    for (int q = 0; q < rule_->GetNPoints(); ++q) {
        const mfem::IntegrationPoint& point = rule_->IntPoint(q);
        transformation.SetIntPoint(&point);
        mfem::Mult(reference_gradients_[static_cast<std::size_t>(q)], transformation.InverseJacobian(), gradients_);
        const double weight = std::sqrt(point.weight * transformation.Weight());
        weighted_.col(q) = weight * Eigen::Map<const Eigen::VectorXd>(gradients_.Data(), 3 * n);
    }
    // Block (i, j) is the integral of d_i N_a d_j N_b; only the lower half is computed.
    products_.setZero();
    products_.selfadjointView<Eigen::Lower>().rankUpdate(weighted_);
    products_.triangularView<Eigen::StrictlyUpper>() = products_.transpose();

    const auto block = [n](Eigen::MatrixXd& matrix, int i, int j) { return matrix.block(i * n, j * n, n, n); };
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            block(stiffness_, i, j) = lambda_ * block(products_, i, j) + mu_ * block(products_, j, i);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) block(stiffness_, i, i) += mu_ * block(products_, j, j);
    return stiffness_;
}

void for_each_stiffness(mfem::ParFiniteElementSpace& space, const Material& material, const VisitStiffness& visit,
                        const std::function<void(double fraction, double seconds)>& monitor) {
    // A hundred elements of high order take a second or more.
    constexpr long long fewest_chunks = 16, elements_of_chunk = 64;
    const long long chunks = std::max(fewest_chunks, space.GetParMesh()->GetGlobalNE() / elements_of_chunk);
    ElementStiffness stiffness(material);
    const int count = space.GetNE();
    int element = 0;
    for (long long chunk = 1; chunk <= chunks; ++chunk) {
        const double start = MPI_Wtime();
        for (const auto end = static_cast<int>(count * chunk / chunks); element < end; ++element)
            visit(element, stiffness.of(*space.GetFE(element), *space.GetElementTransformation(element)));
        monitor(static_cast<double>(chunk) / static_cast<double>(chunks), MPI_Wtime() - start);
    }
}

}  // namespace contactd::fem
