#include "wave_matrices.hpp"

#include <Eigen/Dense>
#include <algorithm>

namespace contactd::fem {
namespace {

using Matrix = Eigen::MatrixXd;

/// Holds integrals of products of shape functions, N, and their derivatives along y and z.
struct ElementIntegrals {
    Matrix NN, Ny, Nz, yy, yz, zz;  ///< Ny(a, b): of N_a dN_b/dy; yz(a, b): of dN_a/dy dN_b/dz
};

class Integrator {
   public:
    explicit Integrator(const mfem::FiniteElementSpace& space)
        : space_(space),
          element_(*space.GetFE(0)),
          // Curved triangles need this in addition, because of their Jacobian.
          rule_(mfem::IntRules.Get(mfem::Geometry::TRIANGLE, 2 * element_.GetOrder() + 2)) {
        const int nodes = element_.GetDof(), points = rule_.GetNPoints();
        N_.resize(nodes, points);
        for (int q = 0; q < points; ++q) {
            mfem::Vector shape(N_.col(q).data(), nodes);
            element_.CalcShape(rule_.IntPoint(q), shape);
            derivatives_.emplace_back(nodes, 2);
            element_.CalcDShape(rule_.IntPoint(q), derivatives_.back());
        }
    }

    ElementIntegrals operator()(int number) {
        const auto points = N_.cols();
        Matrix gy(N_.rows(), points), gz(N_.rows(), points);
        Eigen::VectorXd weight(points);
        mfem::ElementTransformation& map = *space_.GetElementTransformation(number);
        for (int q = 0; q < points; ++q) {
            map.SetIntPoint(&rule_.IntPoint(q));
            weight[q] = rule_.IntPoint(q).weight * map.Weight();
            const mfem::DenseMatrix& inverse = map.InverseJacobian();
            const Eigen::Map<const Matrix> d(derivatives_[q].GetData(), N_.rows(), 2);
            gy.col(q) = d.col(0) * inverse(0, 0) + d.col(1) * inverse(1, 0);
            gz.col(q) = d.col(0) * inverse(0, 1) + d.col(1) * inverse(1, 1);
        }
        const Matrix wN = N_ * weight.asDiagonal(), wy = gy * weight.asDiagonal(), wz = gz * weight.asDiagonal();
        return {wN * N_.transpose(), wN * gy.transpose(), wN * gz.transpose(),
                wy * gy.transpose(), wy * gz.transpose(), wz * gz.transpose()};
    }

   private:
    const mfem::FiniteElementSpace& space_;
    const mfem::FiniteElement& element_;
    const mfem::IntegrationRule& rule_;
    Matrix N_;
    std::vector<mfem::DenseMatrix> derivatives_;
};

/// Returns the 3x3 blocks of K0, K1 and K2 for the nodes a and b of an element.
struct Blocks {
    Eigen::Matrix3d k0, k1, k2;

    Blocks(const ElementIntegrals& e, int a, int b, double lambda) {
        const double yz = e.yz(a, b), zy = e.yz(b, a), yy = e.yy(a, b), zz = e.zz(a, b);
        k0 << yy + zz, 0, 0,                              //
            0, (lambda + 2) * yy + zz, lambda * yz + zy,  //
            0, lambda * zy + yz, (lambda + 2) * zz + yy;
        k1 << 0, lambda * e.Ny(a, b) - e.Ny(b, a), lambda * e.Nz(a, b) - e.Nz(b, a),  //
            lambda * e.Ny(b, a) - e.Ny(a, b), 0, 0,                                   //
            lambda * e.Nz(b, a) - e.Nz(a, b), 0, 0;
        k2 = e.NN(a, b) * Eigen::Vector3d(lambda + 2, 1, 1).asDiagonal().toDenseMatrix();
    }
};

}  // namespace

WaveMatrices::WaveMatrices(const SectionMesh& mesh, int order, double nu)
    : collection_(order, 2), space_(std::make_unique<mfem::FiniteElementSpace>(mesh.mesh.get(), &collection_)) {
    number_nodes(mesh);
    make_pattern();
    assemble(nu);
}

void WaveMatrices::number_nodes(const SectionMesh& mesh) {
    number_.assign(static_cast<std::size_t>(space_->GetNDofs()), 0);
    mfem::Array<int> dofs;
    for (int edge = 0; edge < mesh.mesh->GetNBE(); ++edge) {
        if (mesh.mesh->GetBdrAttribute(edge) != 2) continue;
        space_->GetBdrElementDofs(edge, dofs);
        for (const int dof : dofs) number_[static_cast<std::size_t>(dof)] = -1;
    }
    for (int& number : number_)
        if (number == 0) number = free_nodes_++;
}

void WaveMatrices::make_pattern() {
    std::vector<std::vector<int>> below(static_cast<std::size_t>(free_nodes_));
    mfem::Array<int> dofs;
    for (int element = 0; element < space_->GetNE(); ++element) {
        space_->GetElementDofs(element, dofs);
        for (const int a : dofs)
            for (const int b : dofs) {
                const int row = number_[a], column = number_[b];
                if (column >= 0 && row >= column) below[static_cast<std::size_t>(column)].push_back(row);
            }
    }
    nodes_.begin = {0};
    for (auto& rows : below) {
        std::ranges::sort(rows);
        rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
        nodes_.row.insert(nodes_.row.end(), rows.begin(), rows.end());
        nodes_.begin.push_back(static_cast<int>(nodes_.row.size()));
    }
    pattern_.begin = {0};
    for (int node = 0; node < free_nodes_; ++node)
        for (int c = 0; c < 3; ++c) {
            for (int at = nodes_.begin[node]; at < nodes_.begin[node + 1]; ++at)
                for (int r = at == nodes_.begin[node] ? c : 0; r < 3; ++r)
                    pattern_.row.push_back(3 * nodes_.row[at] + r);
            pattern_.begin.push_back(static_cast<int>(pattern_.row.size()));
        }
}

std::size_t WaveMatrices::entry(int row, int column) const {
    const int node = column / 3, c = column % 3;
    const auto first = nodes_.row.begin() + nodes_.begin[node], last = nodes_.row.begin() + nodes_.begin[node + 1];
    const auto at = std::lower_bound(first, last, row / 3) - first;
    return static_cast<std::size_t>(pattern_.begin[column] + 3 * at + row % 3 - c);
}

void WaveMatrices::assemble(double nu) {
    const double lambda = 2 * nu / (1 - 2 * nu);
    k0_.assign(pattern_.row.size(), 0);
    k1_ = k2_ = k0_;
    Integrator integrate(*space_);
    mfem::Array<int> dofs;
    for (int element = 0; element < space_->GetNE(); ++element) {
        space_->GetElementDofs(element, dofs);
        const ElementIntegrals integrals = integrate(element);
        for (int a = 0; a < dofs.Size(); ++a)
            for (int b = 0; b < dofs.Size(); ++b) {
                const int row = number_[dofs[a]], column = number_[dofs[b]];
                if (column < 0 || row < column) continue;
                const Blocks blocks(integrals, a, b, lambda);
                for (int c = 0; c < 3; ++c) {
                    const int low = row == column ? c : 0;
                    const std::size_t at = entry(3 * row + low, 3 * column + c);
                    for (int r = low; r < 3; ++r) {
                        k0_[at + r - low] += blocks.k0(r, c);
                        k1_[at + r - low] += blocks.k1(r, c);
                        k2_[at + r - low] += blocks.k2(r, c);
                    }
                }
            }
    }
}

std::vector<double> WaveMatrices::at(double xi) const {
    std::vector<double> values(k0_.size());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = k0_[i] + xi * (k1_[i] + xi * k2_[i]);
    return values;
}

}  // namespace contactd::fem
