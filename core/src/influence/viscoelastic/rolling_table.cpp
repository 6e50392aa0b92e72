#include "influence/viscoelastic/rolling_table.hpp"

#include <algorithm>
#include <numbers>
#include <optional>
#include <utility>

#include "influence/half_space_model.hpp"
#include "influence/viscoelastic/delayed_integrals.hpp"

namespace contactd {
namespace {

using enum Axis;

constexpr double shortest_delay = 1e-15, longest_delay = 1e15;  // in elements

/// Returns any of the nine coefficients of one body, with the signs of the pair.
double coefficient(const HalfSpaceModel& model, Axis i, Axis j, const KernelIntegrals& k) {
    using std::numbers::pi;
    if (i != z) return model.coefficient(i, j, k);
    if (j == z) return model.a * (k.xx + k.yy) / (2 * pi);
    return -model.c * (j == x ? k.x : k.y) / (4 * pi);
}

KernelIntegrals plus(const KernelIntegrals& a, double factor, const KernelIntegrals& b) {
    return {a.xx + factor * b.xx, a.yy + factor * b.yy, a.xy + factor * b.xy, a.x + factor * b.x, a.y + factor * b.y};
}

/// Represents one body, as if the other one were rigid.
struct Half {
    HalfSpaceModel model;
    double f = 0;
    std::optional<DelayedIntegrals> delayed{};
};

Half half_of(const RollingHalfSpaces& pair, const Body& body, bool is_upper, const Grid& grid, double shift) {
    HalfSpaces alone{
        is_upper ? MaterialPair{body.material, Material::rigid()} : MaterialPair{Material::rigid(), body.material},
        LoadShape::constant, line_contact_of(pair.bodies)};
    for (const Body* each : {&pair.bodies.upper, &pair.bodies.lower})
        if (const Ics* ics = each->computed()) alone.load_shape = ics->load_shape;
    Half half{HalfSpaceModel(alone)};
    if (body.material.is_rigid() || !body.viscoelastic || body.viscoelastic->f == 0) return half;
    half.f = body.viscoelastic->f;
    // Beyond these, the results are equal to the limits within rounding errors.
    const double l =
        std::clamp(pair.velocity * body.viscoelastic->tau, shortest_delay * grid.dx, longest_delay * grid.dx);
    half.delayed.emplace(half.model, grid.dx, grid.dy, 1 - grid.nx, grid.nx - 1, shift, l);
    return half;
}

/// Fills a table at the lattice of its offsets, `step` ahead in the rolling direction. Tables are computed for rolling
/// along +x: the mirror image is rolling along -x.
template <class Table, std::size_t displacements>
void fill(const RollingHalfSpaces& pair, const Grid& grid, double step, const Axis (&along)[displacements],
          const Observer& observer, Table& table) {
    const double shift = step / grid.dx;
    Half halves[2] = {half_of(pair, pair.bodies.upper, true, grid, shift),
                      half_of(pair, pair.bodies.lower, false, grid, shift)};
    const bool same = halves[0].delayed && halves[1].delayed &&
                      pair.bodies.upper.viscoelastic->tau == pair.bodies.lower.viscoelastic->tau;
    const auto n = static_cast<std::size_t>(2 * grid.nx - 1);
    std::vector<KernelIntegrals> now(n), delayed[2];
    for (int l = 0; l < grid.ny; ++l) {
        observer.throw_if_cancelled();
        const double row = l * grid.dy;
        for (std::size_t at = 0; at < n; ++at)
            now[at] = halves[0].model.integrals((static_cast<int>(at) + 1 - grid.nx + shift) * grid.dx, row, grid.dx,
                                                grid.dy);
        for (std::size_t body = 0; body < 2; ++body)
            if (halves[body].delayed) delayed[body] = body == 1 && same ? delayed[0] : halves[body].delayed->row(row);
        for (std::size_t at = 0; at < n; ++at) {
            const int k = static_cast<int>(at) + 1 - grid.nx;
            for (const Axis i : along)
                for (const Axis j : {x, y, z}) {
                    double value = 0;
                    for (std::size_t body = 0; body < 2; ++body) {
                        const Half& half = halves[body];
                        value += coefficient(half.model, i, j,
                                             half.delayed ? plus(now[at], half.f, delayed[body][at]) : now[at]);
                    }
                    const auto [of_x, of_y] = parity(i, j);
                    if (!pair.is_forward) value *= of_x;
                    table(i, j, pair.is_forward ? k : -k, l) = value;
                    table(i, j, pair.is_forward ? k : -k, -l) = of_y * value;
                }
        }
    }
}

}  // namespace

RollingTable cropped(const RollingTable& table, int nx, int ny) {
    RollingTable result(nx, ny);
    for (const Axis i : {x, y, z})
        for (const Axis j : {x, y, z})
            for (int l = 1 - ny; l < ny; ++l)
                std::copy_n(&table.values[table.index(i, j, 1 - nx, l)], 2 * nx - 1,
                            &result.values[result.index(i, j, 1 - nx, l)]);
    return result;
}

RollingTable rolling_table(const RollingHalfSpaces& half_spaces, const Grid& grid, const Observer& observer) {
    RollingTable table(grid.nx, grid.ny);
    fill(half_spaces, grid, 0, {x, y, z}, observer, table);
    return table;
}

ShiftedTable rolling_table_ahead(const RollingHalfSpaces& half_spaces, const Grid& grid, double step,
                                 const Observer& observer) {
    ShiftedTable table(grid.nx, grid.ny);
    fill(half_spaces, grid, step, {x, y}, observer, table);
    return table;
}

ShiftedTable change_over_step(const RollingTable& now, const ShiftedTable& ahead) {
    ShiftedTable change = ahead;
    for (const Axis i : {x, y})
        for (const Axis j : {x, y, z})
            for (int l = 1 - ahead.ny; l < ahead.ny; ++l)
                for (int k = 1 - ahead.nx; k < ahead.nx; ++k) {
                    double& value = change(i, j, k, l);
                    value = now(i, j, k, l) - value;
                }
    return change;
}

}  // namespace contactd
