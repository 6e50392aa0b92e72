#include "axis_elements.hpp"

#include <Eigen/Eigenvalues>
#include <utility>

#include <mfem.hpp>

#include "mesh/block_mesh.hpp"

namespace contactd::fem {
namespace {

mfem::Poly_1D::Basis& basis_of(int order) {
    return mfem::poly1d.GetBasis(order, mfem::BasisType::GaussLobatto);
}

Eigen::Map<const Eigen::VectorXd> as_vector(const mfem::Vector& vector) {
    return {vector.GetData(), vector.Size()};
}

}  // namespace

AxisElements::AxisElements(std::vector<double> planes, int order) : planes_(std::move(planes)), order_(order) {
    const auto intervals = static_cast<Eigen::Index>(planes_.size()) - 1, p = static_cast<Eigen::Index>(order);
    const Eigen::Index count = intervals * p + 1;
    const double* points = mfem::poly1d.ClosedPoints(order);
    const mfem::IntegrationRule& rule = mfem::IntRules.Get(mfem::Geometry::SEGMENT, 2 * order);
    positions_.resize(count);
    for (Eigen::MatrixXd* matrix : {&mass_, &stiffness_, &slope_}) matrix->setZero(count, count);
    mfem::Vector value(order + 1), slope(order + 1);
    for (Eigen::Index i = 0; i < intervals; ++i) {
        const double low = planes_[static_cast<std::size_t>(i)];
        const double length = planes_[static_cast<std::size_t>(i) + 1] - low;
        for (Eigen::Index a = 0; a <= p; ++a) positions_[i * p + a] = low + length * points[a];
        for (int q = 0; q < rule.GetNPoints(); ++q) {
            basis_of(order).Eval(rule.IntPoint(q).x, value, slope);
            const double weight = rule.IntPoint(q).weight;
            const auto N = as_vector(value), dN = as_vector(slope);
            const auto add = [&](Eigen::MatrixXd& matrix, const auto& product) {
                matrix.block(i * p, i * p, p + 1, p + 1) += product;
            };
            add(mass_, weight * length * N * N.transpose());
            add(stiffness_, weight / length * dN * dN.transpose());
            add(slope_, weight * N * dN.transpose());
        }
    }
    positions_[count - 1] = planes_.back();
}

Eigen::MatrixXd AxisElements::values_at(const std::vector<double>& points) const {
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(points.size()), nodes());
    mfem::Vector value(order_ + 1);
    Eigen::Index row = 0;
    for (const double point : points) {
        const auto [interval, local] = find_interval(planes_, point);
        basis_of(order_).Eval(local, value);
        result.row(row++).segment(interval * order_, order_ + 1) = as_vector(value).transpose();
    }
    return result;
}

AxisModes modes_of(const AxisElements& elements, AxisEnd first, AxisEnd last) {
    const Eigen::Index begin = first == AxisEnd::given ? 1 : 0;
    const Eigen::Index count = elements.nodes() - begin - (last == AxisEnd::given ? 1 : 0);
    // Solves the inverse problem: the lowest modes dominate the displacements, and they then have the accuracy of the
    // largest eigenvalues, even if some intervals are very fine.
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(
        elements.mass().block(begin, begin, count, count), elements.stiffness().block(begin, begin, count, count));
    const Eigen::VectorXd inverse = solver.eigenvalues();
    AxisModes result{Eigen::MatrixXd::Zero(elements.nodes(), count), inverse.cwiseInverse()};
    result.vectors.middleRows(begin, count) = solver.eigenvectors() * inverse.cwiseSqrt().cwiseInverse().asDiagonal();
    return result;
}

}  // namespace contactd::fem
