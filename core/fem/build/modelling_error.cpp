#include "modelling_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "contactd/half_space.hpp"
#include "tensor/block_correction.hpp"

namespace contactd::fem {
namespace {

constexpr BlockLevel level{4, 5};
/// Elements between corner and middle may differ more: by a factor of at most 1.033 in 44 random blocks, with all loads
/// of each.
constexpr double beside_corner = 1.1;

/// The position is relative to the middle of a row of elements.
std::vector<double> centres(int count, double step) {
    std::vector<double> result;
    for (int i = 0; i < count; ++i) result.push_back((i - (count - 1) / 2.0) * step);
    return result;
}

std::vector<double> seen_from(double origin, std::vector<double> points) {
    for (double& point : points) point -= origin;
    return points;
}

double half_space(const IcSpec& spec, Axis i, double x, double y) {
    return spec.load_shape == LoadShape::bilinear
               ? half_space_bilinear_coefficient(i, i, x, y, spec.dx, spec.dy, spec.material)
               : half_space_coefficient(i, i, x, y, spec.dx, spec.dy, spec.material);
}

/// Returns the largest difference between the half-space corrections of a load in the corner and one in the middle,
/// component (i, j), shape [ys, xs], at the offsets xs, ys, in the measures of IcSpec::accuracy.
double largest(const IcSpec& spec, Axis i, Axis j, const Eigen::MatrixXd& corner, const Eigen::MatrixXd& middle,
               const std::vector<double>& xs, const std::vector<double>& ys) {
    double result = 0;
    for (std::size_t l = 0; l < ys.size(); ++l)
        for (std::size_t k = 0; k < xs.size(); ++k) {
            const auto row = static_cast<Eigen::Index>(l), column = static_cast<Eigen::Index>(k);
            const double difference = std::abs(corner(row, column) - middle(row, column));
            double unit = spec.dx * spec.dy / (2 * std::numbers::pi * spec.material.G * std::hypot(xs[k], ys[l]));
            if (i == j) {
                const double exact = half_space(spec, i, xs[k], ys[l]);
                unit = std::max(std::abs(exact + middle(row, column)), block_error_floor * exact);
            }
            result = std::max(result, difference / unit);
        }
    return result;
}

}  // namespace

double modelling_error(const IcSpec& spec, const ProgressPart& progress) {
    IcSpec plain = spec;
    plain.fem.tolerance = FemSpec{}.tolerance;
    plain.fem.max_iterations = FemSpec{}.max_iterations;
    const BlockCorrection correction(plain, level);
    const std::vector<double> xs = centres(spec.nx, spec.dx), ys = centres(spec.ny, spec.dy);
    const LoadPlace corner{xs.back(), ys.back()};
    const std::vector<double> offsets_x = seen_from(corner.x, xs), offsets_y = seen_from(corner.y, ys);
    constexpr std::array loads{Axis::z, Axis::x, Axis::y};
    constexpr double share = 1.0 / loads.size(), centre_share = 0.2;
    double result = 0, done = 0;
    for (const Axis load : loads) {
        const auto solve = [&](const LoadPlace& place, const ProgressPart& part) {
            auto solution =
                correction.solve(load, place, [&](double fraction, int iteration, double residual, double seconds) {
                    part.report("modelling_error", fraction, iteration, residual, seconds);
                });
            require_converged(solution.result(), load, plain.fem);
            return solution;
        };
        const ProgressPart part = progress.part(done, share);
        const auto centre = solve({}, part.part(0, centre_share));
        const auto off_centre = solve(corner, part.part(centre_share, 1 - centre_share));
        for (const Axis i : {Axis::x, Axis::y, Axis::z})
            result = std::max(result, largest(spec, i, load, off_centre.at(i, xs, ys),
                                              centre.at(i, offsets_x, offsets_y), offsets_x, offsets_y));
        done += share;
    }
    return beside_corner * result;
}

}  // namespace contactd::fem
