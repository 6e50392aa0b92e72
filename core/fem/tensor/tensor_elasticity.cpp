#include "tensor_elasticity.hpp"

#include <cmath>

namespace contactd::fem {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

constexpr PerAxis<int> components{0, 1, 2};
constexpr std::size_t x = 0, y = 1, z = 2;
constexpr int rounds = 4;  // of conjugate gradients

std::size_t place(int axis) {
    return static_cast<std::size_t>(axis);
}

AxisModes modes_along(const AxisElements& elements, std::size_t axis, bool odd) {
    if (axis == z) return modes_of(elements, AxisEnd::given, AxisEnd::free);
    return modes_of(elements, odd ? AxisEnd::given : AxisEnd::free, AxisEnd::given);
}

}  // namespace

/// Room for products.
struct TensorElasticity::Work {
    PerAxis<TensorField> u;                 ///< the components
    TensorField along_x, along_y, along_z;  ///< all have the size of u_z
    TensorField result;
};

TensorElasticity::TensorElasticity(const PerAxis<AxisElements>& elements, const Material& material,
                                   const PlaneSymmetry& symmetry)
    : elements_(elements), lambda_(2 * material.G * material.nu / (1 - 2 * material.nu)), mu_(material.G) {
    const PerAxis<bool> odd{symmetry.x_is_odd, symmetry.y_is_odd, false};
    for (const std::size_t axis : {x, y, z}) {
        own_[axis] = modes_along(elements_[axis], axis, odd[axis]);
        other_[axis] = modes_along(elements_[axis], axis, !odd[axis]);
    }
    for (const std::size_t axis : {x, y})
        own_slope_[axis] = own_[axis].vectors.transpose() * elements_[axis].slope().transpose() * other_[axis].vectors;
    const Matrix slope = own_[z].vectors.transpose() * elements_[z].slope() * own_[z].vectors;
    shear_ = lambda_ * slope - mu_ * slope.transpose();

    Eigen::Index count = 0;
    for (const int i : components) {
        for (const int axis : components) size_[place(i)][place(axis)] = modes(i, axis).stiffness.size();
        begin_[place(i)] = count;
        count += count_of(size_[place(i)]);
    }
    diagonal_.resize(count);
    Eigen::Index at = 0;
    for (const int i : components) {
        const PerAxis<double> factor{i == 0 ? lambda_ + 2 * mu_ : mu_, i == 1 ? lambda_ + 2 * mu_ : mu_,
                                     i == 2 ? lambda_ + 2 * mu_ : mu_};
        for (const double c : modes(i, 2).stiffness)
            for (const double b : modes(i, 1).stiffness)
                for (const double a : modes(i, 0).stiffness)
                    diagonal_[at++] = factor[x] * a + factor[y] * b + factor[z] * c;
    }
}

const AxisModes& TensorElasticity::modes(int component, int axis) const {
    return component == axis ? own_[place(axis)] : other_[place(axis)];
}

// For two functions along x of which one is odd, and which both vanish at L, the integrals of p' q and p q' have
// opposite signs. D_x, D_y are those of own and other modes, and S is that of modes along z. Applied along each axis in
// turn, they form K_xy = (lambda + mu) D_x D_y', K_xz = D_x (lambda S - mu S'), K_yz = D_y (lambda S - mu S').
void TensorElasticity::multiply(const Vector& w, Vector& result, Work& work) const {
    for (const int i : components) {
        TensorField& u = work.u[place(i)];
        u.size = size_[place(i)];
        u.values = w.segment(begin_[place(i)], count_of(u.size));
    }
    apply_along(0, own_slope_[x].transpose(), work.u[x], work.along_x);
    apply_along(1, own_slope_[y].transpose(), work.u[y], work.along_y);
    apply_along(2, shear_, work.u[z], work.along_z);
    result = diagonal_.cwiseProduct(w);
    const auto add = [&](std::size_t i, int axis, const Matrix& matrix, const TensorField& field) {
        apply_along(axis, matrix, field, work.result);
        result.segment(begin_[i], work.result.values.size()) += work.result.values;
    };
    TensorField& sum = work.u[z];
    sum.values = work.along_x.values + work.along_y.values;
    add(z, 2, shear_.transpose(), sum);
    work.along_x.values = (lambda_ + mu_) * work.along_x.values + work.along_z.values;
    work.along_y.values = (lambda_ + mu_) * work.along_y.values + work.along_z.values;
    add(x, 0, own_slope_[x], work.along_y);
    add(y, 1, own_slope_[y], work.along_x);
}

Vector TensorElasticity::forces_of(const PerAxis<TensorField>& given) const {
    Vector result = Vector::Zero(diagonal_.size());
    for (const int i : components)
        for (const int j : components) {
            // Adds lambda d_i v_i d_j u_j + mu d_j v_i d_i u_j, and mu d_a v_i d_a u_i for each axis a.
            const auto add = [&](double factor, int test_slope, int trial_slope) {
                PerAxis<Matrix> matrices;
                for (const int axis : components) {
                    const AxisElements& of = elements_[place(axis)];
                    const bool test = axis == test_slope, trial = axis == trial_slope;
                    const Matrix& matrix = test && trial ? of.stiffness() : test || trial ? of.slope() : of.mass();
                    const Matrix& shapes = modes(i, axis).vectors;
                    matrices[place(axis)] = test && !trial ? Matrix(shapes.transpose() * matrix.transpose())
                                                           : Matrix(shapes.transpose() * matrix);
                }
                result.segment(begin_[place(i)], count_of(size_[place(i)])) +=
                    factor * apply_along_all(matrices, given[place(j)]).values;
            };
            add(lambda_, i, j);
            add(mu_, j, i);
            if (i == j)
                for (const int axis : components) add(mu_, axis, axis);
        }
    return result;
}

SolveResult TensorElasticity::solve(
    const Vector& b, Vector& w, double tolerance, int max_iterations,
    const std::function<void(int iteration, double residual, double seconds)>& monitor) const {
    const auto norm = [this](const Vector& r) { return std::sqrt(r.cwiseAbs2().cwiseQuotient(diagonal_).sum()); };
    const double start = MPI_Wtime(), norm_b = norm(b);
    SolveResult result;
    Work work;
    Vector r = b, preconditioned, d, q;
    w.setZero(b.size());
    if (norm_b == 0) {
        result.converged = true;
        return result;
    }
    double seconds = 0;
    // The recurrence's residual drifts from the true one; if they disagree, iterations restart from the latter.
    for (int round = 0; round < rounds; ++round) {
        double rz = 0;
        result.residual = norm(r) / norm_b;
        while (result.residual > tolerance && result.iterations < max_iterations) {
            const double begin = MPI_Wtime();
            monitor(result.iterations, result.residual, seconds);
            preconditioned = r.cwiseQuotient(diagonal_);
            const double rz_new = r.dot(preconditioned);
            d = rz == 0 ? preconditioned : Vector(preconditioned + (rz_new / rz) * d);
            rz = rz_new;
            multiply(d, q, work);
            const double curvature = d.dot(q);
            if (!(curvature > 0 && rz > 0)) break;  // lost to rounding, or not a number
            w += (rz / curvature) * d;
            r -= (rz / curvature) * q;
            result.residual = norm(r) / norm_b;
            ++result.iterations;
            seconds = seconds_since(begin);
        }
        multiply(w, q, work);
        r = b - q;
        result.residual = norm(r) / norm_b;
        if (!(result.residual > tolerance) || result.iterations == max_iterations) break;
    }
    result.converged = result.residual <= tolerance;
    result.solve_seconds = seconds_since(start);
    return result;
}

Matrix TensorElasticity::on_surface(const Vector& w, Axis component, const std::vector<double>& xs,
                                    const std::vector<double>& ys) const {
    const auto i = static_cast<int>(component);
    TensorField field{size_[place(i)], w.segment(begin_[place(i)], count_of(size_[place(i)]))};
    const Matrix top = elements_[z].values_at({elements_[z].positions()[elements_[z].nodes() - 1]});
    field = apply_along_all({elements_[x].values_at(xs) * modes(i, 0).vectors,
                             elements_[y].values_at(ys) * modes(i, 1).vectors, top * modes(i, 2).vectors},
                            field);
    return Eigen::Map<const Matrix>(field.values.data(), field.size[0], field.size[1]).transpose();
}

}  // namespace contactd::fem
