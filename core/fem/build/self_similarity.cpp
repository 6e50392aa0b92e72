#include "self_similarity.hpp"

#include <Eigen/Dense>
#include <array>
#include <cstdlib>

#include "contactd/error.hpp"

namespace contactd::fem {
namespace {

constexpr int near = self_similar_extent / 2;  // The largest required offset is 2 (near - 1) + 1.
constexpr int unknowns = near * near;

void replace_near(IcTable& table, Axis i, Axis j) {
    const Parity sign = parity(i, j);
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(unknowns, unknowns);
    Eigen::VectorXd known = Eigen::VectorXd::Zero(unknowns);
    constexpr std::array<double, 3> c{0.5, 1, 0.5};
    for (int l = 0; l < near; ++l)
        for (int k = 0; k < near; ++k)
            for (int q = -1; q <= 1; ++q)
                for (int p = -1; p <= 1; ++p) {
                    const int x = 2 * k - p, y = 2 * l - q;
                    const double weight = 0.5 * c[static_cast<std::size_t>(p + 1)] * c[static_cast<std::size_t>(q + 1)];
                    const int row = l * near + k, X = std::abs(x), Y = std::abs(y);
                    if (X < near && Y < near)
                        matrix(row, Y * near + X) -= weight * (x < 0 ? sign.along_x : 1) * (y < 0 ? sign.along_y : 1);
                    else
                        known[row] += weight * table.at(i, j, x, y);
                }
    const Eigen::VectorXd values = matrix.partialPivLu().solve(known);
    for (int l = 0; l < near; ++l)
        for (int k = 0; k < near; ++k) {
            const bool zero = (sign.along_x < 0 && k == 0) || (sign.along_y < 0 && l == 0);
            table(i, j, k, l) = zero ? 0 : values[l * near + k];
        }
}

}  // namespace

IcTable near_load_from_far(const IcTable& table) {
    if (table.nx < self_similar_extent || table.ny < self_similar_extent)
        throw InvalidArgument("table",
                              "is smaller than the 10 x 10 offsets that determine its values next to the load");
    IcTable result = table;
    for (const Axis i : {Axis::x, Axis::y, Axis::z})
        for (const Axis j : {Axis::x, Axis::y, Axis::z}) replace_near(result, i, j);
    return result;
}

}  // namespace contactd::fem
