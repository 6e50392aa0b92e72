#include "condensed_assembly.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "element_stiffness.hpp"

namespace contactd::fem {
namespace {

/// Holds displacements of `outer` nodes, component by component, as indices into the element's matrix of `n` nodes.
std::vector<int> displacements(int first, int last, int n) {
    std::vector<int> result;
    for (int i = 0; i < 3; ++i)
        for (int node = first; node < last; ++node) result.push_back(i * n + node);
    return result;
}

/// Returns the matrix of the first `outer` of n nodes if the others carry no load: Koo - Koi Kii^-1 Kio.
Eigen::MatrixXd condensed(const Eigen::MatrixXd& K, int outer) {
    const auto n = static_cast<int>(K.rows() / 3);
    if (outer == n) return K;
    const std::vector<int> o = displacements(0, outer, n), i = displacements(outer, n, n);
    const Eigen::MatrixXd inside = K(i, i);
    Eigen::MatrixXd coupling = K(i, o);
    const Eigen::LLT<Eigen::MatrixXd> factor(inside);
    factor.matrixL().solveInPlace(coupling);
    Eigen::MatrixXd result = K(o, o);
    result.selfadjointView<Eigen::Lower>().rankUpdate(coupling.transpose(), -1);
    return result;
}

}  // namespace

CondensedAssembly::CondensedAssembly(mfem::ParFiniteElementSpace& space)
    : space_(space), number_(static_cast<std::size_t>(space.GetNDofs()), 0) {
    for (int element = 0; element < space.GetNE(); ++element) {
        mfem::Array<int> inside;
        space.GetElementInteriorDofs(element, inside);
        for (const int node : inside) number_[static_cast<std::size_t>(node)] = -1;
    }
    for (int& number : number_)
        if (number == 0) number = count_++;
    find_neighbours();
}

std::vector<int> CondensedAssembly::outer_nodes(int element) const {
    mfem::Array<int> nodes;
    space_.GetElementDofs(element, nodes);
    std::vector<int> result;
    for (const int node : nodes)
        if (const int number = number_[static_cast<std::size_t>(node)]; number >= 0) result.push_back(number);
    return result;
}

void CondensedAssembly::find_neighbours() {
    below_.resize(static_cast<std::size_t>(count_));
    for (int element = 0; element < space_.GetNE(); ++element) {
        const std::vector<int> nodes = outer_nodes(element);
        for (const int a : nodes)
            for (const int b : nodes)
                if (b >= a) below_[static_cast<std::size_t>(a)].push_back(b);
    }
    for (std::vector<int>& list : below_) {
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
        list.shrink_to_fit();
    }
}

Eigen::SparseMatrix<double> CondensedAssembly::empty_matrix() const {
    const Eigen::Index size = 3LL * count_;
    Eigen::SparseMatrix<double> result(size, size);
    Eigen::Index entries = 0;
    for (const std::vector<int>& list : below_) entries += 9 * static_cast<Eigen::Index>(list.size()) - 3;
    result.resizeNonZeros(entries);
    int at = 0;
    for (int node = 0; node < count_; ++node)
        for (int i = 0; i < 3; ++i) {
            result.outerIndexPtr()[3 * node + i] = at;
            for (const int neighbour : below_[static_cast<std::size_t>(node)])
                for (int j = neighbour == node ? i : 0; j < 3; ++j) result.innerIndexPtr()[at++] = 3 * neighbour + j;
        }
    result.outerIndexPtr()[size] = at;
    std::fill_n(result.valuePtr(), at, 0.0);
    return result;
}

void CondensedAssembly::add(const std::vector<int>& nodes, const Eigen::MatrixXd& stiffness,
                            Eigen::SparseMatrix<double>& lower) const {
    const auto n = static_cast<int>(nodes.size());
    for (int a = 0; a < n; ++a) {
        const int node = nodes[static_cast<std::size_t>(a)];
        const std::vector<int>& list = below_[static_cast<std::size_t>(node)];
        for (int b = 0; b < n; ++b) {
            const int neighbour = nodes[static_cast<std::size_t>(b)];
            if (neighbour < node) continue;
            const auto rank = static_cast<int>(std::lower_bound(list.begin(), list.end(), neighbour) - list.begin());
            for (int i = 0; i < 3; ++i) {
                // Column 3 node + i starts with its own node's rows from i on.
                double* column = lower.valuePtr() + lower.outerIndexPtr()[3 * node + i] + 3 * rank - i;
                for (int j = neighbour == node ? i : 0; j < 3; ++j) {
                    // Only the lower half of the condensed matrix is computed.
                    const int row = j * n + b, at = i * n + a;
                    column[j] += stiffness(std::max(row, at), std::min(row, at));
                }
            }
        }
    }
}

Eigen::SparseMatrix<double> CondensedAssembly::assemble(const Material& material, const AssemblyMonitor& monitor) {
    Eigen::SparseMatrix<double> lower = empty_matrix();
    const auto visit = [&](int element, const Eigen::MatrixXd& stiffness) {
        const std::vector<int> nodes = outer_nodes(element);
        add(nodes, condensed(stiffness, static_cast<int>(nodes.size())), lower);
    };
    for_each_stiffness(space_, material, visit, monitor);
    below_.clear();
    return lower;
}

}  // namespace contactd::fem
