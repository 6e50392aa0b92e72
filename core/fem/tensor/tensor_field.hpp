// Holds values on a grid of products, and applies matrices along one of its axes.
#pragma once

#include <array>

#include <Eigen/Core>

namespace contactd::fem {

using TensorSize = std::array<Eigen::Index, 3>;

inline Eigen::Index count_of(const TensorSize& size) {
    return size[0] * size[1] * size[2];
}

/// Values at (x, y, z), x fastest.
struct TensorField {
    TensorSize size{};
    Eigen::VectorXd values;
};

/// Applies a matrix, or its transpose, along `axis`: out(.., i, ..) = sum over j of matrix(i, j) in(.., j, ..). `out`
/// reuses its memory if it has the same size.
void apply_along(int axis, const Eigen::Ref<const Eigen::MatrixXd>& matrix, const TensorField& in, TensorField& out);

/// Applies a matrix to `in` along each axis.
TensorField apply_along_all(const std::array<Eigen::MatrixXd, 3>& matrices, TensorField in);

}  // namespace contactd::fem
