#include <algorithm>
#include <array>
#include <utility>

#include "influence/layered/load_integrals.hpp"

namespace contactd {
namespace {

using Kernel = RadialFunction::Kernel;

constexpr std::array<RadialFunction, 5> functions{
    RadialFunction{[](const WaveCompliance& wave) { return wave.c; }, 1, Kernel::J1},                       // D
    RadialFunction{[](const WaveCompliance& wave) { return wave.d; }, 1, Kernel::J1},                       // F
    RadialFunction{[](const WaveCompliance& wave) { return wave.a - wave.d; }, 2, Kernel::J0_regularised},  // Psi
    RadialFunction{[](const WaveCompliance& wave) { return wave.a - wave.d; }, 3, Kernel::J1_regularised},  // Q
    RadialFunction{[](const WaveCompliance& wave) { return wave.b; }, 2, Kernel::J1_regularised}};          // R

/// Holds integrals over a cell of a kernel times 1, x, y and xy.
struct CellMoments {
    double one, x, y, xy;

    /// Returns the integral with the hat functions that rise (or fall) along x and y from the cell's lower to its upper
    /// lines.
    double hats(bool rise_x, bool rise_y, double x0, double y0, double dx, double dy) const {
        const double ax = rise_x ? -x0 : x0 + dx, ay = rise_y ? -y0 : y0 + dy;  // hat = (a +- s)/size
        const double sx = rise_x ? 1 : -1, sy = rise_y ? 1 : -1;
        return (ax * ay * one + sx * ay * x + sy * ax * y + sx * sy * xy) / (dx * dy);
    }
};

}  // namespace

/// Holds sums along an edge, with n the axis across it and s the one along it. "first" are moments with s.
struct BilinearLoad::EdgeSums {
    double D = 0, F = 0, Q = 0, R = 0;        ///< times n/rho
    double rho_D = 0, rho_F = 0, rho_R = 0;   ///< times rho
    double first_rho_D = 0, first_rho_F = 0;  ///< times s rho
    double Psi_rising = 0, Psi_falling = 0;   ///< times weights from 0 to 1, and from 1 to 0
};

struct BilinearLoad::Cell {
    CellMoments c, d;  ///< moments of the kernels of zz, and of both xx and yy
    double Psi = 0;    ///< integral
    double Phi = 0, Phi_x = 0, Phi_y = 0;
};

BilinearLoad::BilinearLoad(const Layers& body, double least, double largest)
    : least_(least), radial_(body, functions, least, largest), rule_(least) {}

BilinearLoad::EdgeSums BilinearLoad::sums(double across, double from, double to) const {
    EdgeSums edge;
    rule_.along(across, from, to, [&](double t, double rho, double weight) {
        const auto [D, F, Psi, Q, R] = radial_.at(rho);
        const double normal = weight * across / std::max(rho, least_), moment = weight * rho;
        edge.D += normal * D;
        edge.F += normal * F;
        edge.Q += normal * Q;
        edge.R += normal * R;
        edge.rho_D += moment * D;
        edge.rho_F += moment * F;
        edge.rho_R += moment * R;
        edge.first_rho_D += moment * t * D;
        edge.first_rho_F += moment * t * F;
        edge.Psi_rising += weight * Psi * (t - from) / (to - from);
        edge.Psi_falling += weight * Psi * (to - t) / (to - from);
    });
    return edge;
}

BilinearLoad::Edges BilinearLoad::row_line(const EdgeLines& lines, std::size_t j) const {
    Edges edges;
    for (std::size_t i = 0; i + 1 < lines.x.size(); ++i) edges.push_back(sums(lines.y[j], lines.x[i], lines.x[i + 1]));
    return edges;
}

BilinearLoad::Edges BilinearLoad::row_edges(const EdgeLines& lines, std::size_t j) const {
    Edges edges;
    for (const double x : lines.x) edges.push_back(sums(x, lines.y[j], lines.y[j + 1]));
    return edges;
}

BilinearLoad::Cells BilinearLoad::row_cells(const Edges& below, const Edges& between, const Edges& above) {
    Cells cells(below.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const EdgeSums &left = between[i], &right = between[i + 1], &low = below[i], &high = above[i];
        const auto out = [&](double EdgeSums::* sum) { return (right.*sum - left.*sum) + (high.*sum - low.*sum); };
        Cell& cell = cells[i];
        cell.c = {out(&EdgeSums::D), right.rho_D - left.rho_D, high.rho_D - low.rho_D,
                  right.first_rho_D - left.first_rho_D};
        cell.d = {out(&EdgeSums::F), right.rho_F - left.rho_F, high.rho_F - low.rho_F,
                  right.first_rho_F - left.first_rho_F};
        cell.Psi = out(&EdgeSums::Q);
        cell.Phi = out(&EdgeSums::R);
        cell.Phi_x = right.rho_R - left.rho_R;
        cell.Phi_y = high.rho_R - low.rho_R;
    }
    return cells;
}

std::vector<SurfaceCoefficients> BilinearLoad::at(const OffsetLattice& offsets, const Observer& observer) const {
    const EdgeLines lines(offsets, LoadShape::bilinear);
    const double dx = offsets.dx, dy = offsets.dy;
    std::vector<SurfaceCoefficients> result(offsets.index(0, offsets.ny));
    // A row of points lies on the middle one of three lines, with cells below and above it.
    std::array<Edges, 3> along_x{Edges{}, row_line(lines, 0), row_line(lines, 1)};
    std::array<Edges, 2> along_y{Edges{}, row_edges(lines, 0)};
    std::array<Cells, 2> cells{Cells{}, row_cells(along_x[1], along_y[1], along_x[2])};
    for (int l = 0; l < offsets.ny; ++l) {
        observer.throw_if_cancelled();
        const auto j = static_cast<std::size_t>(l);
        along_x = {std::move(along_x[1]), std::move(along_x[2]), row_line(lines, j + 2)};
        along_y = {std::move(along_y[1]), row_edges(lines, j + 1)};
        cells = {std::move(cells[1]), row_cells(along_x[1], along_y[1], along_x[2])};
        for (int k = 0; k < offsets.nx; ++k) {
            const auto i = static_cast<std::size_t>(k);
            SurfaceCoefficients& sum = result[offsets.index(k, l)];
            for (const bool low_y : {true, false})
                for (const bool low_x : {true, false}) {  // Cells below the point along an axis have rising hats.
                    const std::size_t column = i + (low_x ? 0 : 1);
                    const Cell& cell = cells[low_y ? 0 : 1][column];
                    const double x0 = lines.x[column], y0 = lines.y[j + (low_y ? 0 : 1)];
                    const double slope_x = (low_x ? 1 : -1) / dx, slope_y = (low_y ? 1 : -1) / dy;
                    sum.zz += cell.c.hats(low_x, low_y, x0, y0, dx, dy);
                    const double both = cell.d.hats(low_x, low_y, x0, y0, dx, dy);
                    sum.xx += both;
                    sum.yy += both;
                    sum.xy -= slope_x * slope_y * cell.Psi;
                    const double hat_x = low_x ? cell.Phi_x - x0 * cell.Phi : (x0 + dx) * cell.Phi - cell.Phi_x;
                    const double hat_y = low_y ? cell.Phi_y - y0 * cell.Phi : (y0 + dy) * cell.Phi - cell.Phi_y;
                    sum.xz += slope_x * hat_y / dy;
                    sum.yz += slope_y * hat_x / dx;
                }
            for (const std::size_t line : {0, 1, 2}) {  // These are second differences of Psi under the hat function.
                const double factor = line == 1 ? 2 : -1;
                sum.xx += factor / dx * (along_y[0][i + line].Psi_rising + along_y[1][i + line].Psi_falling);
                sum.yy += factor / dy * (along_x[line][i].Psi_rising + along_x[line][i + 1].Psi_falling);
            }
        }
    }
    return result;
}

}  // namespace contactd
