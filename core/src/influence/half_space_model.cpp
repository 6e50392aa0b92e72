#include "half_space_model.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace contactd {
namespace {

using enum Axis;
using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

constexpr int fitted = 4;  // offsets 0..3 along both axes

// Represents k^of_k l^of_l.
struct Monomial {
    int of_k, of_l;
    double at(int k, int l) const { return std::pow(k, of_k) * std::pow(l, of_l); }
};

// Returns monomials up to the fourth degree, with the parity of the component, if there are enough offsets to
// distinguish them from the singularity.
std::vector<Monomial> monomials(Parity parity, int nx, int ny) {
    const auto highest = [](int n) { return n < 3 ? 0 : n < 4 ? 2 : 4; };
    std::vector<Monomial> result;
    if (nx * ny < 4) return result;
    for (int of_k = parity.along_x < 0 ? 1 : 0; of_k <= highest(nx); of_k += 2)
        for (int of_l = parity.along_y < 0 ? 1 : 0; of_l <= highest(ny) && of_k + of_l <= 4; of_l += 2)
            result.push_back({of_k, of_l});
    return result;
}

struct Fit {
    Vector unknowns;
    double residual;
};

// Columns are scaled, because they differ by orders of magnitude, and tables of one row leave some of them
// undetermined.
Fit least_squares(Matrix matrix, const Vector& values) {
    Vector scale = matrix.colwise().norm().cwiseMax(1e-300);
    matrix = matrix * scale.cwiseInverse().asDiagonal();
    Eigen::CompleteOrthogonalDecomposition<Matrix> solver(matrix);
    solver.setThreshold(1e-10);
    const Vector unknowns = solver.solve(values);
    return {unknowns.cwiseQuotient(scale), (matrix * unknowns - values).norm()};
}

struct Component {
    Axis i, j;
};

// The unknowns are the parameters of the model, and a polynomial for each component.
template <std::size_t parameters, std::size_t n>
Fit fit(const IcTable& pair, double dx, double dy, const std::array<HalfSpaceModel, parameters>& models,
        const std::array<Component, n>& components) {
    const int nx = std::min(pair.nx, fitted), ny = std::min(pair.ny, fitted);
    std::array<std::vector<Monomial>, n> polynomials;
    Eigen::Index unknowns = parameters;
    for (std::size_t c = 0; c < n; ++c) {
        polynomials[c] = monomials(parity(components[c].i, components[c].j), nx, ny);
        unknowns += static_cast<Eigen::Index>(polynomials[c].size());
    }
    Matrix matrix = Matrix::Zero(static_cast<Eigen::Index>(n) * nx * ny, unknowns);
    Vector values(matrix.rows());
    Eigen::Index row = 0;
    for (int l = 0; l < ny; ++l)
        for (int k = 0; k < nx; ++k) {
            const KernelIntegrals integrals = models[0].integrals(k * dx, l * dy, dx, dy);
            Eigen::Index column = parameters;
            for (std::size_t c = 0; c < n; ++c, ++row) {
                const auto [i, j] = components[c];
                for (std::size_t m = 0; m < parameters; ++m)
                    matrix(row, static_cast<Eigen::Index>(m)) = models[m].coefficient(i, j, integrals);
                for (const Monomial& monomial : polynomials[c]) matrix(row, column++) = monomial.at(k, l);
                values(row) = pair(i, j, k, l);
                // The polynomial is accurate near the origin.
                const double weight = 1 / std::pow(1 + k * k + l * l, 2);
                matrix.row(row) *= weight;
                values(row) *= weight;
            }
        }
    return least_squares(matrix, values);
}

Fit fit_in_plane(const IcTable& pair, double dx, double dy, LoadShape load_shape) {
    HalfSpaceModel of_a(load_shape), of_b(load_shape);
    of_a.a = of_b.b = 1;
    return fit(pair, dx, dy, std::array{of_a, of_b}, std::array<Component, 3>{{{x, x}, {y, y}, {x, y}}});
}

Fit fit_coupling(const IcTable& pair, double dx, double dy, LoadShape load_shape) {
    HalfSpaceModel of_c(load_shape);
    of_c.c = 1;
    return fit(pair, dx, dy, std::array{of_c}, std::array<Component, 2>{{{x, z}, {y, z}}});
}

}  // namespace

HalfSpaceModel::HalfSpaceModel(const HalfSpaces& half_spaces)
    : load_shape(half_spaces.load_shape), line_contact(half_spaces.line_contact) {
    const auto& [upper, lower] = half_spaces.bodies;
    a = (1 - upper.nu) / upper.G + (1 - lower.nu) / lower.G;
    b = upper.nu / upper.G + lower.nu / lower.G;
    // Rounding errors must not couple quasi-identical bodies.
    if (!half_spaces.bodies.quasi_identical()) c = (1 - 2 * lower.nu) / lower.G - (1 - 2 * upper.nu) / upper.G;
}

HalfSpaceModel nearest_half_spaces(const IcTable& pair, double dx, double dy) {
    const Fit constant = fit_in_plane(pair, dx, dy, LoadShape::constant);
    const Fit bilinear = fit_in_plane(pair, dx, dy, LoadShape::bilinear);
    const bool is_bilinear = bilinear.residual < constant.residual;
    HalfSpaceModel model(is_bilinear ? LoadShape::bilinear : LoadShape::constant);
    const Vector& in_plane = (is_bilinear ? bilinear : constant).unknowns;
    model.a = in_plane(0);
    model.b = in_plane(1);
    const auto xz = [&](Axis i) {
        const double* first = &pair.values[pair.index(i, z, 0, 0)];
        return std::any_of(first, first + pair.component_size(), [](double value) { return value != 0; });
    };
    if (xz(x) || xz(y)) model.c = fit_coupling(pair, dx, dy, model.load_shape).unknowns(0);
    return model;
}

}  // namespace contactd
