#include "influence/strips/wavenumber_rule.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "contactd/count_of.hpp"
#include "influence/layered/gauss_legendre.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

using Matrix = Eigen::MatrixXd;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using std::numbers::pi;

/// Returns second derivatives of the splines of the unit vectors on knots 0, 1, 2, ...
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

/// Describes a point of a quadrature over wavenumbers, behind a knot.
struct Point {
    double xi, weight;
    double share;  ///< fraction of the way to the next knot; behind the last one, fraction of its value that remains
};

/// At this multiple of the last knot, functions that decay as 1/xi^2 are small.
constexpr double end_of_tail = 12;

/// Returns the points behind each knot.
std::vector<std::vector<Point>> quadrature(const std::vector<double>& nodes, double xi0, double longest) {
    // Few points per wave are sufficient: this number integrates five waves per panel to rounding errors, while eight
    // points integrate half a wave.
    static const auto rule = gauss_legendre(24);
    constexpr double waves = 5;
    const auto panels_of = [&](double width) {
        return 1 + count_of(width * longest / (2 * pi * waves),
                            {"grid", "extends over " + short_text(longest) + " strip widths along x",
                             "panels of a quadrature", "use shorter or fewer elements along x", 100'000});
    };
    const double step = std::asinh(nodes[1] / xi0);
    std::vector<std::vector<Point>> points(nodes.size());
    for (std::size_t knot = 0; knot + 1 < nodes.size(); ++knot) {
        const double width = nodes[knot + 1] - nodes[knot];
        const int panels = panels_of(width);
        for (int panel = 0; panel < panels; ++panel)
            for (const auto& [node, weight] : rule) {
                const double xi = nodes[knot] + width * (panel + node) / panels;
                points[knot].push_back(
                    {xi, weight * width / panels, std::asinh(xi / xi0) / step - static_cast<double>(knot)});
            }
    }
    constexpr int smooth = 3;  // additional panels for 1/xi^2
    const double last = nodes.back();
    const int panels = smooth + panels_of((end_of_tail - 1) * last);
    for (int panel = 0; panel < panels; ++panel)
        for (const auto& [node, weight] : rule) {
            // Panels are even in xi, like the waves.
            const double width = (end_of_tail - 1) * last / panels, xi = last + width * (panel + node);
            points.back().push_back({xi, weight * width, last * last / (xi * xi)});
        }
    return points;
}

/// Computes cos and sin of xi (k dx + shift) at some points by rotation from offset to offset, because direct cosines
/// would take most of the time of a table.
struct Waves {
    Matrix cosines, sines;  ///< [point, k]

    Waves(std::span<const Point> points, double dx, int nx, double shift)
        : cosines(static_cast<Eigen::Index>(points.size()), nx), sines(cosines.rows(), nx) {
        Eigen::ArrayXd turn_cosine(cosines.rows()), turn_sine(cosines.rows());
        for (Eigen::Index q = 0; q < cosines.rows(); ++q) {
            const double xi = points[static_cast<std::size_t>(q)].xi;
            turn_cosine[q] = std::cos(xi * dx);
            turn_sine[q] = std::sin(xi * dx);
            cosines(q, 0) = std::cos(xi * shift);
            sines(q, 0) = std::sin(xi * shift);
        }
        for (Eigen::Index k = 0; k + 1 < nx; ++k) {
            const auto cosine = cosines.col(k).array(), sine = sines.col(k).array();
            cosines.col(k + 1) = cosine * turn_cosine - sine * turn_sine;
            sines.col(k + 1) = sine * turn_cosine + cosine * turn_sine;
        }
    }
};

/// These are weights of the spline of a value at a knot: those of the knot, the next one, and the curvatures at both.
using Shares = Eigen::Matrix<double, 4, Eigen::Dynamic>;

Shares shares(std::span<const Point> points, double dx, bool beyond) {
    Shares result(4, static_cast<Eigen::Index>(points.size()));
    for (Eigen::Index q = 0; q < result.cols(); ++q) {
        const auto& [xi, weight, share] = points[static_cast<std::size_t>(q)];
        const double half = xi * dx / 2, element = half < 1e-8 ? dx : 2 * std::sin(half) / xi;
        const double a = 1 - share, b = share;
        if (beyond)
            result.col(q) << share, 0, 0, 0;
        else
            result.col(q) << a, b, (a * a * a - a) / 6, (b * b * b - b) / 6;
        result.col(q) *= weight * element / pi;
    }
    return result;
}

}  // namespace

std::vector<double> wavenumber_nodes(double xi0, double last, int count) {
    const double end = std::asinh(last / xi0);
    std::vector<double> nodes;
    for (int i = 0; i < count; ++i) nodes.push_back(xi0 * std::sinh(end * i / (count - 1)));
    return nodes;
}

WavenumberRule wavenumber_rule(const std::vector<double>& nodes, double xi0, double dx, int nx, double shift,
                               const Observer& observer) {
    const auto count = static_cast<Eigen::Index>(nodes.size());
    // There are weights of values and of curvatures.
    RowMajor even = RowMajor::Zero(count, nx), even_bent = even, odd = even, odd_bent = even;
    const auto points = quadrature(nodes, xi0, nx * dx + std::abs(shift));
    for (Eigen::Index knot = 0; knot < count; ++knot) {
        constexpr std::size_t block = 64;  // number of waves that stay in the nearest caches
        std::span<const Point> left = points[static_cast<std::size_t>(knot)];
        while (!left.empty()) {
            observer.throw_if_cancelled();
            const auto now = left.first(std::min(block, left.size()));
            left = left.subspan(now.size());
            const Waves waves(now, dx, nx, shift);
            const Shares weights = shares(now, dx, knot + 1 == count);
            if (knot + 1 == count) {
                even.row(knot).noalias() += weights.row(0) * waves.cosines;
                odd.row(knot).noalias() += weights.row(0) * waves.sines;
                continue;
            }
            even.middleRows(knot, 2).noalias() += weights.topRows(2) * waves.cosines;
            odd.middleRows(knot, 2).noalias() += weights.topRows(2) * waves.sines;
            even_bent.middleRows(knot, 2).noalias() += weights.bottomRows(2) * waves.cosines;
            odd_bent.middleRows(knot, 2).noalias() += weights.bottomRows(2) * waves.sines;
        }
    }
    even += curvatures(count, true).transpose() * even_bent;
    odd += curvatures(count, false).transpose() * odd_bent;
    odd.row(0).setZero();
    const auto values = [&](const RowMajor& all) { return std::vector<double>(all.data(), all.data() + count * nx); };
    return {values(even), values(odd)};
}

}  // namespace contactd
