#include "spline_fit.hpp"

#include <algorithm>
#include <array>

namespace contactd::creep_table {
namespace {

// Fills the condition of one end in the order from this end, which is -1 for the last end.
void set_end(Eigen::MatrixXd& conditions, int row, int direction, SplineEnd end) {
    const int last = static_cast<int>(conditions.cols()) - 1;
    const auto set = [&](int index, double value) { conditions(row, direction > 0 ? index : last - index) = value; };
    switch (end) {
        case SplineEnd::not_a_knot:
            for (int i = 0; i < 5; ++i) set(i, std::array{1, -4, 6, -4, 1}[i]);
            return;
        case SplineEnd::slope:
        case SplineEnd::even:
            set(0, -0.5 * direction);
            set(2, 0.5 * direction);
            return;
        case SplineEnd::odd:
            for (int i = 0; i < 3; ++i) set(i, std::array{1, -2, 1}[i]);
            return;
        case SplineEnd::antiperiodic:
            set(0, 1);
            set(last - 2, 1);
    }
}

}  // namespace

Eigen::MatrixXd spline_fit(int cells, SplineEnd first, SplineEnd last) {
    const int size = cells + 3;
    Eigen::MatrixXd conditions = Eigen::MatrixXd::Zero(size, size);
    for (int node = 0; node <= cells; ++node)
        for (int i = 0; i < 3; ++i) conditions(node + 1, node + i) = i == 1 ? 2.0 / 3 : 1.0 / 6;
    set_end(conditions, 0, 1, first);
    set_end(conditions, size - 1, -1, last);
    return conditions.inverse();
}

std::vector<double> multiply_along(const Eigen::MatrixXd& matrix, const std::vector<double>& array, std::size_t after) {
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const auto columns = static_cast<Eigen::Index>(after);
    const std::size_t in = matrix.cols() * after, out = matrix.rows() * after, before = array.size() / in;
    std::vector<double> product(before * out);
    for (std::size_t i = 0; i < before; ++i)
        Eigen::Map<Rows>(product.data() + i * out, matrix.rows(), columns).noalias() =
            matrix * Eigen::Map<const Rows>(array.data() + i * in, matrix.cols(), columns);
    return product;
}

std::vector<double> with_zero_ends(const std::vector<double>& array, int nodes, std::size_t after) {
    const std::size_t in = nodes * after, out = in + 2 * after, before = array.size() / in;
    std::vector<double> longer(before * out);
    for (std::size_t i = 0; i < before; ++i) std::copy_n(array.begin() + i * in, in, longer.begin() + i * out + after);
    return longer;
}

}  // namespace contactd::creep_table
