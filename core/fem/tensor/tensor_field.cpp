#include "tensor_field.hpp"

#include <utility>

namespace contactd::fem {

void apply_along(int axis, const Eigen::Ref<const Eigen::MatrixXd>& matrix, const TensorField& in, TensorField& out) {
    using Matrix = Eigen::MatrixXd;
    out.size = in.size;
    out.size[static_cast<std::size_t>(axis)] = matrix.rows();
    out.values.resize(count_of(out.size));
    const auto [nx, ny, nz] = in.size;
    if (axis == 0) {
        Eigen::Map<Matrix>(out.values.data(), matrix.rows(), ny * nz).noalias() =
            matrix * Eigen::Map<const Matrix>(in.values.data(), nx, ny * nz);
    } else if (axis == 1) {
        for (Eigen::Index z = 0; z < nz; ++z)
            Eigen::Map<Matrix>(out.values.data() + z * nx * matrix.rows(), nx, matrix.rows()).noalias() =
                Eigen::Map<const Matrix>(in.values.data() + z * nx * ny, nx, ny) * matrix.transpose();
    } else {
        Eigen::Map<Matrix>(out.values.data(), nx * ny, matrix.rows()).noalias() =
            Eigen::Map<const Matrix>(in.values.data(), nx * ny, nz) * matrix.transpose();
    }
}

TensorField apply_along_all(const std::array<Eigen::MatrixXd, 3>& matrices, TensorField in) {
    TensorField out;
    for (int axis = 0; axis < 3; ++axis) {
        apply_along(axis, matrices[static_cast<std::size_t>(axis)], in, out);
        std::swap(in, out);
    }
    return in;
}

}  // namespace contactd::fem
