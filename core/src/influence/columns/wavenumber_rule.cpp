#include "influence/columns/wavenumber_rule.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "influence/layered/gauss_legendre.hpp"

namespace contactd {
namespace {

using Matrix = Eigen::MatrixXd;
using std::numbers::pi;

/// Second derivatives of the splines of the unit vectors on knots 0, 1, 2, ...
Matrix curvatures(Eigen::Index count, bool even) {
    Matrix system = Matrix::Zero(count, count), right = Matrix::Zero(count, count);
    for (Eigen::Index i = 1; i + 1 < count; ++i) {
        system(i, i - 1) = system(i, i + 1) = 1.0 / 6;
        system(i, i) = 4.0 / 6;
        right(i, i - 1) = right(i, i + 1) = 1;
        right(i, i) = -2;
    }
    if (even) {  // zero slope at 0
        system(0, 0) = 1.0 / 3;
        system(0, 1) = 1.0 / 6;
        right(0, 0) = -1;
        right(0, 1) = 1;
    } else {
        system(0, 0) = 1;
    }
    system(count - 1, count - 1) = 1;
    return system.partialPivLu().solve(right);
}

/// A point of a quadrature over wavenumbers, between the knots `knot` and `knot + 1`, or beyond the last one.
struct Point {
    double xi, weight;
    Eigen::Index knot;
    double share;  ///< of the way to the next knot; of the last one, what is left of its value
};

/// Where what falls as 1/xi^2 has become small, over the last knot.
constexpr double end_of_tail = 12;

std::vector<Point> quadrature(const std::vector<double>& nodes, double xi0, double longest) {
    static const auto rule = gauss_legendre(8);
    constexpr int least_panels = 2;
    const double step = std::asinh(nodes[1] / xi0);
    std::vector<Point> points;
    for (std::size_t knot = 0; knot + 1 < nodes.size(); ++knot) {
        const double width = nodes[knot + 1] - nodes[knot];
        // Half a wave a panel.
        const int panels = least_panels + static_cast<int>(width * longest / pi);
        for (int panel = 0; panel < panels; ++panel)
            for (const auto& [node, weight] : rule) {
                const double xi = nodes[knot] + width * (panel + node) / panels;
                points.push_back({xi, weight * width / panels, static_cast<Eigen::Index>(knot),
                                  std::asinh(xi / xi0) / step - static_cast<double>(knot)});
            }
    }
    const double last = nodes.back();
    const int panels = 8 + static_cast<int>((end_of_tail - 1) * last * longest / pi);
    for (int panel = 0; panel < panels; ++panel)
        for (const auto& [node, weight] : rule) {
            // Panels even in xi: the waves are.
            const double width = (end_of_tail - 1) * last / panels, xi = last + width * (panel + node);
            points.push_back(
                {xi, weight * width, static_cast<Eigen::Index>(nodes.size()) - 1, last * last / (xi * xi)});
        }
    return points;
}

}  // namespace

std::vector<double> wavenumber_nodes(double xi0, double last, int count) {
    const double end = std::asinh(last / xi0);
    std::vector<double> nodes;
    for (int i = 0; i < count; ++i) nodes.push_back(xi0 * std::sinh(end * i / (count - 1)));
    return nodes;
}

WavenumberRule wavenumber_rule(const std::vector<double>& nodes, double xi0, double dx, int nx, double shift) {
    const auto count = static_cast<Eigen::Index>(nodes.size());
    const Matrix even_curvatures = curvatures(count, true), odd_curvatures = curvatures(count, false);
    const std::vector<Point> points = quadrature(nodes, xi0, nx * dx + std::abs(shift));
    // Weights of the wave at each point of the quadrature are gathered in blocks, which are multiplied as matrices.
    constexpr Eigen::Index block = 256;
    Matrix even = Matrix::Zero(count, nx), odd = even;
    Matrix even_values(count, block), odd_values(count, block), cosines(block, nx), sines(block, nx);
    for (std::size_t begin = 0; begin < points.size(); begin += block) {
        const auto used = std::min<Eigen::Index>(block, static_cast<Eigen::Index>(points.size() - begin));
        for (Eigen::Index q = 0; q < used; ++q) {
            const auto& [xi, weight, knot, share] = points[begin + static_cast<std::size_t>(q)];
            const double half = xi * dx / 2, element = half < 1e-8 ? dx : 2 * std::sin(half) / xi;
            const double a = 1 - share, b = share, c = (a * a * a - a) / 6, d = (b * b * b - b) / 6;
            const auto spline = [&](const Matrix& second) {
                if (knot + 1 == count)
                    return Eigen::VectorXd(share * weight * element / pi * Eigen::VectorXd::Unit(count, knot));
                Eigen::VectorXd values = c * second.row(knot) + d * second.row(knot + 1);
                values[knot] += a;
                values[knot + 1] += b;
                return Eigen::VectorXd(values * (weight * element / pi));
            };
            even_values.col(q) = spline(even_curvatures);
            odd_values.col(q) = spline(odd_curvatures);
            // The wave is turned on from offset to offset: cosines of all would take most of the time of a table.
            const double turn_cosine = std::cos(xi * dx), turn_sine = std::sin(xi * dx);
            double cosine = std::cos(xi * shift), sine = std::sin(xi * shift);
            for (int k = 0; k < nx; ++k) {
                cosines(q, k) = cosine;
                sines(q, k) = sine;
                const double next = cosine * turn_cosine - sine * turn_sine;
                sine = sine * turn_cosine + cosine * turn_sine;
                cosine = next;
            }
        }
        even.noalias() += even_values.leftCols(used) * cosines.topRows(used);
        odd.noalias() += odd_values.leftCols(used) * sines.topRows(used);
    }
    odd.row(0).setZero();
    WavenumberRule rule;
    rule.even.resize(static_cast<std::size_t>(count * nx));
    rule.odd.resize(rule.even.size());
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    Eigen::Map<RowMajor>(rule.even.data(), count, nx) = even;
    Eigen::Map<RowMajor>(rule.odd.data(), count, nx) = odd;
    return rule;
}

}  // namespace contactd
