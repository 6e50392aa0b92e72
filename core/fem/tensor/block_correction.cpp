#include "block_correction.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contactd/error.hpp"
#include "contactd/half_space.hpp"

namespace contactd::fem {
namespace {

constexpr double L_of(const IcSpec& spec) {
    return spec.fem.L_over_h * std::max(spec.dx, spec.dy);
}

/// Displacements are proportional to r^lambda at the distance r from an edge where a clamped face and the free surface
/// form a right angle. lambda is the root in (0.59, 1] of (3 - 4 nu) sin^2(lambda pi/2) = 4 (1-nu)^2 - lambda^2
/// (Williams, J. Appl. Mech. 19, 1952).
double edge_exponent(double nu) {
    double below = 0.5, above = 1;
    for (int halving = 0; halving < 50; ++halving) {
        const double lambda = (below + above) / 2, sine = std::sin(lambda * std::numbers::pi / 2);
        const bool is_below = (3 - 4 * nu) * sine * sine < 4 * (1 - nu) * (1 - nu) - lambda * lambda;
        (is_below ? below : above) = lambda;
    }
    return above;
}

/// The distances of the planes from the edge follow a power of their number, 1/lambda as usual for graded meshes. From
/// inside, 1.8 balances the intervals. The last one is divided once more, to resolve the singularity.
constexpr double grading_times_exponent = 1.8;
constexpr double last_cut = 1.0 / 8;

/// Goes from 0 to L, finer towards L, where the edges are.
std::vector<double> graded_planes(double L, const BlockLevel& level, double nu) {
    const double power = grading_times_exponent / edge_exponent(nu);
    const int equal_steps = level.intervals - 1;
    std::vector<double> planes;
    double distance = 1;
    for (int i = 0; i < equal_steps; ++i) {
        distance = std::pow(1 - static_cast<double>(i) / equal_steps, power);
        planes.push_back(L * (1 - distance));
    }
    planes.push_back(L * (1 - last_cut * distance));
    planes.push_back(L);
    return planes;
}

PerAxis<AxisElements> axes_of(const IcSpec& spec, const BlockLevel& level) {
    const AxisElements along(graded_planes(L_of(spec), level, spec.material.nu), level.order);
    // The edges are those of the surface, z = 0.
    std::vector<double> heights = graded_planes(L_of(spec), level, spec.material.nu);
    for (double& height : heights) height -= L_of(spec);
    return {along, along, AxisElements(heights, level.order)};
}

/// Returns the parity of component i for a load along j in the middle, across the plane normal to `axis`.
double parity_of(Axis i, Axis j, Axis axis) {
    return (i == axis) == (j == axis) ? 1 : -1;
}

}  // namespace

BlockCorrection::BlockCorrection(const IcSpec& spec, const BlockLevel& level)
    : spec_(spec),
      elements_(static_cast<long long>(level.intervals) * level.intervals * level.intervals),
      axes_(axes_of(spec, level)) {}

long long BlockCorrection::dofs() const {
    const long long nodes = axes_[0].nodes();
    return 3 * nodes * nodes * nodes;
}

PerAxis<TensorField> BlockCorrection::far_displacements(Axis load, const LoadPlace& place,
                                                        const PerAxis<double>& sign_x,
                                                        const PerAxis<double>& sign_y) const {
    const Eigen::Index n = axes_[0].nodes();
    PerAxis<TensorField> result;
    for (TensorField& field : result) field = {{n, n, n}, Eigen::VectorXd::Zero(n * n * n)};
    // Computes the part of the load's displacements with this symmetry: the mean over its images.
    const std::vector<double> xs = place.x == 0 ? std::vector{1.0} : std::vector{1.0, -1.0};
    const std::vector<double> ys = place.y == 0 ? std::vector{1.0} : std::vector{1.0, -1.0};
    const double share = 1.0 / static_cast<double>(xs.size() * ys.size());
    for (Eigen::Index c = 0; c < n; ++c)
        for (Eigen::Index b = 0; b < n; ++b)
            for (Eigen::Index a = 0; a < n; ++a) {
                if (a < n - 1 && b < n - 1 && c > 0) continue;
                for (const double image_x : xs)
                    for (const double image_y : ys) {
                        const auto u = half_space_displacement(
                            spec_, load,
                            {image_x * axes_[0].positions()[a] - place.x, image_y * axes_[1].positions()[b] - place.y,
                             axes_[2].positions()[c]});
                        for (std::size_t i = 0; i < 3; ++i)
                            result[i].values[(c * n + b) * n + a] +=
                                share * (image_x < 0 ? sign_x[i] : 1) * (image_y < 0 ? sign_y[i] : 1) * u[i];
                    }
            }
    // Odd functions vanish on the plane; this removes rounding errors.
    for (Eigen::Index c = 0; c < n; ++c)
        for (Eigen::Index at = 0; at < n; ++at)
            for (std::size_t i = 0; i < 3; ++i) {
                if (sign_x[i] < 0) result[i].values[(c * n + at) * n] = 0;
                if (sign_y[i] < 0) result[i].values[c * n * n + at] = 0;
            }
    return result;
}

BlockCorrection::Solution BlockCorrection::solve(Axis load, const LoadPlace& place, const Monitor& monitor) const {
    const double start = MPI_Wtime();
    Solution result;
    result.of_ = this;
    result.result_.converged = true;
    const std::vector<double> xs = place.x == 0 ? std::vector{1.0} : std::vector{1.0, -1.0};
    const std::vector<double> ys = place.y == 0 ? std::vector{1.0} : std::vector{1.0, -1.0};
    const double share = 1.0 / static_cast<double>(xs.size() * ys.size());
    const double tolerance = spec_.fem.tolerance;
    for (const double along_x : xs)
        for (const double along_y : ys) {
            Solution::Part part;
            for (const Axis i : {Axis::x, Axis::y, Axis::z}) {
                part.sign_x[static_cast<std::size_t>(i)] = along_x * parity_of(i, load, Axis::x);
                part.sign_y[static_cast<std::size_t>(i)] = along_y * parity_of(i, load, Axis::y);
            }
            part.system = std::make_shared<const TensorElasticity>(
                axes_, spec_.material, PlaneSymmetry{part.sign_x[0] < 0, part.sign_y[1] < 0});
            const PerAxis<TensorField> far = far_displacements(load, place, part.sign_x, part.sign_y);
            const Eigen::VectorXd b = part.system->forces_of(far);
            const Eigen::Index n = axes_[0].nodes();
            for (std::size_t i = 0; i < 3; ++i)
                part.given[i] =
                    -Eigen::Map<const Eigen::MatrixXd>(far[i].values.data() + (n - 1) * n * n, n, n).transpose();
            const double done = static_cast<double>(result.parts_.size()) * share;
            const auto iteration = [&](int number, double residual, double seconds) {
                const double way = std::clamp(std::log(residual) / std::log(tolerance), 0.0, 1.0);
                monitor(done + share * way, number, residual, seconds);
            };
            const SolveResult one = part.system->solve(b, part.modes, tolerance, spec_.fem.max_iterations, iteration);
            result.result_.iterations += one.iterations;
            result.result_.residual = std::max(result.result_.residual, one.residual);
            result.result_.converged = result.result_.converged && one.converged;
            result.parts_.push_back(std::move(part));
        }
    result.result_.solve_seconds = seconds_since(start);
    return result;
}

Eigen::MatrixXd BlockCorrection::Solution::at(Axis i, const std::vector<double>& xs,
                                              const std::vector<double>& ys) const {
    const auto sizes = [](std::vector<double> points) {
        for (double& point : points) point = std::abs(point);
        return points;
    };
    const auto signs = [](const std::vector<double>& points, double sign) {
        Eigen::VectorXd result(static_cast<Eigen::Index>(points.size()));
        Eigen::Index at = 0;
        for (const double point : points) result[at++] = point < 0 ? sign : 1;
        return result;
    };
    Eigen::MatrixXd result =
        Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(ys.size()), static_cast<Eigen::Index>(xs.size()));
    const auto component = static_cast<std::size_t>(i);
    const Eigen::MatrixXd along_x = of_->axes_[0].values_at(sizes(xs));
    const Eigen::MatrixXd along_y = of_->axes_[1].values_at(sizes(ys));
    for (const Part& part : parts_) {
        const Eigen::MatrixXd quarter = part.system->on_surface(part.modes, i, sizes(xs), sizes(ys)) +
                                        along_y * part.given[component] * along_x.transpose();
        result +=
            signs(ys, part.sign_y[component]).asDiagonal() * quarter * signs(xs, part.sign_x[component]).asDiagonal();
    }
    return result;
}

}  // namespace contactd::fem
