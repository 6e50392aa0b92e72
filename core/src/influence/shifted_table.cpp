#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>

#include "contactd/error.hpp"
#include "cubic_weights.hpp"
#include "half_space_model.hpp"
#include "shifted_half_space.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

using enum Axis;

struct Component {
    Axis i, j;
};
constexpr std::array<Component, 6> components = {{{x, x}, {y, y}, {x, y}, {y, x}, {x, z}, {y, z}}};

// Describes a shift in elements along one axis.
struct Steps {
    int whole;
    double fraction;  // 0 <= fraction < 1

    Steps(double shift, double size) {
        constexpr double rounding = 1e-9;
        const double steps = shift / size, nearest = std::round(steps);
        const double down = std::abs(steps - nearest) <= rounding ? nearest : std::floor(steps);
        fraction = down == nearest && std::abs(steps - nearest) <= rounding ? 0 : steps - down;
        whole = static_cast<int>(down);
    }
    double total() const { return whole + fraction; }
};

void check_shift(double shift, double size, const char* field) {
    // Larger offsets are not exact integers.
    if (!(std::abs(shift / size) < 1e6))
        throw InvalidArgument(
            field, "is " + number_text(shift) + "; it must be less than a million elements of " + number_text(size));
}

void check_extent(int table_nx, int table_ny, int nx, int ny) {
    if (table_nx < nx || table_ny < ny)
        throw InvalidArgument("grid", "needs offsets up to " + std::to_string(nx) + " x " + std::to_string(ny) +
                                          "; the table contains " + std::to_string(table_nx) + " x " +
                                          std::to_string(table_ny));
}

// Sets offsets by parity along an axis without shift: half of them follow from the others.
void mirror(ShiftedTable& table, bool along_x, bool along_y) {
    for (const auto& [i, j] : components) {
        const auto [of_x, of_y] = parity(i, j);
        if (along_x)
            for (int l = along_y ? 0 : 1 - table.ny; l < table.ny; ++l)
                for (int k = 1; k < table.nx; ++k) table(i, j, -k, l) = of_x * table(i, j, k, l);
        if (along_y)
            for (int l = 1; l < table.ny; ++l)
                for (int k = 1 - table.nx; k < table.nx; ++k) table(i, j, k, -l) = of_y * table(i, j, k, l);
    }
}

ShiftedTable closed_form(const HalfSpaceModel& model, const Grid& grid, const Steps& along_x, const Steps& along_y,
                         const Observer& observer) {
    ShiftedTable table(grid.nx, grid.ny);
    const bool even_x = along_x.total() == 0, even_y = along_y.total() == 0;
    const Lattice lattice{grid.dx,     grid.dy,         even_x ? 0 : 1 - grid.nx, grid.nx - 1, even_y ? 0 : 1 - grid.ny,
                          grid.ny - 1, along_x.total(), along_y.total()};
    for_lattice(model, lattice, observer, [&](int k, int l, const KernelIntegrals& integrals) {
        for (const auto& [i, j] : components) table(i, j, k, l) = model.coefficient(i, j, integrals);
    });
    mirror(table, even_x, even_y);
    return table;
}

// Computes the table minus the closed form at any whole offset, by parity where offsets are negative, and extrapolated
// where they are beyond the table.
class Difference {
   public:
    Difference(const IcTable& pair, const HalfSpaceModel& model, const Grid& grid)
        : pair_(pair), model_(model), dx_(grid.dx), dy_(grid.dy) {}

    /// Computes the values at all offsets of the table.
    void compute_all(const Observer& observer) {
        values_ = pair_;
        const Lattice lattice{dx_, dy_, 0, pair_.nx - 1, 0, pair_.ny - 1, 0, 0};
        for_lattice(model_, lattice, observer, [&](int k, int l, const KernelIntegrals& integrals) {
            for (const auto& [i, j] : components) values_(i, j, k, l) -= model_.coefficient(i, j, integrals);
        });
    }

    double operator()(const Component& component, int k, int l) const {
        const auto [of_x, of_y] = parity(component.i, component.j);
        return (k < 0 ? of_x : 1) * (l < 0 ? of_y : 1) * quarter(component, std::abs(k), std::abs(l));
    }

   private:
    double quarter(const Component& component, int k, int l) const {
        if (k < pair_.nx && l < pair_.ny) return known(component, k, l);
        if (l < pair_.ny) {
            const int end = pair_.nx - 1;
            const double last = known(component, end, l);
            if (end == 0) return last;
            return last + (last - known(component, end - 1, l)) * ratio(k, end, dx_, l * dy_);
        }
        const int end = pair_.ny - 1;
        const double last = quarter(component, k, end);
        if (end == 0) return last;
        return last + (last - quarter(component, k, end - 1)) * ratio(l, end, dy_, k * dx_);
    }
    double known(const Component& component, int k, int l) const {
        const auto [i, j] = component;
        if (!values_.values.empty()) return values_(i, j, k, l);
        return pair_(i, j, k, l) - model_.coefficient(i, j, model_.integrals(k * dx_, l * dy_, dx_, dy_));
    }
    // Returns (t - t1)/(t1 - t2) of t = 1/rho at the offset n and at the last two of the table, along a line that
    // passes the origin at the distance `beside`. Far beyond the end, extrapolation is unreliable, so the result is
    // bounded.
    static double ratio(int n, int end, double size, double beside) {
        constexpr double most = 8;
        const auto rho = [&](int offset) { return std::hypot(offset * size, beside); };
        const double rho0 = rho(n), rho1 = rho(end), rho2 = rho(end - 1), n2 = static_cast<double>(n) * n;
        const double squares = (n2 - static_cast<double>(end) * end) / (2.0 * end - 1);
        return std::min(squares * rho2 * (rho1 + rho2) / (rho0 * (rho0 + rho1)), most);
    }

    const IcTable& pair_;
    const HalfSpaceModel model_;
    const double dx_, dy_;
    IcTable values_;
};

// Adds the difference, interpolated at (k + along_x, l + along_y): first along x on all required lines, then along y.
void add_interpolated(const Difference& difference, const Component& component, const Steps& along_x,
                      const Steps& along_y, ShiftedTable& table) {
    const auto weights_x = cubic_weights(along_x.fraction), weights_y = cubic_weights(along_y.fraction);
    const int columns = 2 * table.nx - 1, lines = 2 * table.ny + 2;
    std::vector<double> nodes(static_cast<std::size_t>(columns) + 3);
    std::vector<std::vector<double>> line(static_cast<std::size_t>(lines), std::vector<double>(nodes.size() - 3));
    for (int at = 0; at < lines; ++at) {
        const int l = at - table.ny + along_y.whole;
        for (std::size_t k = 0; k < nodes.size(); ++k)
            nodes[k] = difference(component, static_cast<int>(k) - table.nx + along_x.whole, l);
        auto& values = line[static_cast<std::size_t>(at)];
        for (std::size_t k = 0; k < values.size(); ++k)
            for (std::size_t node = 0; node < 4; ++node) values[k] += weights_x[node] * nodes[k + node];
    }
    for (int l = 1 - table.ny; l < table.ny; ++l)
        for (int k = 1 - table.nx; k < table.nx; ++k) {
            double sum = 0;
            for (int node = 0; node < 4; ++node)
                sum +=
                    weights_y[static_cast<std::size_t>(node)] *
                    line[static_cast<std::size_t>(l + table.ny - 1 + node)][static_cast<std::size_t>(k + table.nx - 1)];
            table(component.i, component.j, k, l) += sum;
        }
}

// Uses the table's own numbers as far as available.
ShiftedTable shifted_by_elements(const IcTable& pair, const HalfSpaceModel& model, const Grid& grid,
                                 const Steps& along_x, const Steps& along_y, const Observer& observer) {
    ShiftedTable table(grid.nx, grid.ny);
    const Difference difference(pair, model, grid);
    for (int l = 1 - grid.ny; l < grid.ny; ++l) {
        observer.throw_if_cancelled();
        for (int k = 1 - grid.nx; k < grid.nx; ++k) {
            const int K = k + along_x.whole, L = l + along_y.whole;
            const bool inside = std::abs(K) < pair.nx && std::abs(L) < pair.ny;
            KernelIntegrals integrals;
            if (!inside) integrals = model.integrals(K * grid.dx, L * grid.dy, grid.dx, grid.dy);
            for (const Component& component : components) {
                const auto [i, j] = component;
                table(i, j, k, l) =
                    inside ? pair.at(i, j, K, L) : model.coefficient(i, j, integrals) + difference(component, K, L);
            }
        }
    }
    return table;
}

}  // namespace

ShiftedTable cropped(const ShiftedTable& table, int nx, int ny) {
    check_extent(table.nx, table.ny, nx, ny);
    ShiftedTable result(nx, ny);
    for (const auto& [i, j] : components)
        for (int l = 1 - ny; l < ny; ++l)
            std::copy_n(&table.values[table.index(i, j, 1 - nx, l)], 2 * nx - 1,
                        &result.values[result.index(i, j, 1 - nx, l)]);
    return result;
}

ShiftedTable shifted_half_spaces(const HalfSpaces& half_spaces, const Grid& grid, double shift_x, double shift_y,
                                 const Observer& observer) {
    validate(grid, "grid");
    check_shift(shift_x, grid.dx, "shift_x");
    check_shift(shift_y, grid.dy, "shift_y");
    return closed_form(HalfSpaceModel(half_spaces), grid, Steps(shift_x, grid.dx), Steps(shift_y, grid.dy), observer);
}

ShiftedTable shifted_table(const IcTable& pair, const std::optional<HalfSpaces>& nearest, const Grid& grid,
                           double shift_x, double shift_y, const Observer& observer) {
    validate(grid, "grid");
    check_shift(shift_x, grid.dx, "shift_x");
    check_shift(shift_y, grid.dy, "shift_y");
    check_extent(pair.nx, pair.ny, grid.nx, grid.ny);
    const Steps along_x(shift_x, grid.dx), along_y(shift_y, grid.dy);
    const HalfSpaceModel model = nearest ? HalfSpaceModel(*nearest) : nearest_half_spaces(pair, grid.dx, grid.dy);
    if (along_x.fraction == 0 && along_y.fraction == 0)
        return shifted_by_elements(pair, model, grid, along_x, along_y, observer);
    ShiftedTable table = closed_form(model, grid, along_x, along_y, observer);
    Difference difference(pair, model, grid);
    difference.compute_all(observer);
    for (const Component& component : components) {
        observer.throw_if_cancelled();
        add_interpolated(difference, component, along_x, along_y, table);
    }
    return table;
}

ShiftedTable change_over_step(const IcTable& pair, const ShiftedTable& ahead) {
    if (pair.nx < ahead.nx || pair.ny < ahead.ny)
        throw InvalidArgument("grid", "needs offsets up to " + std::to_string(ahead.nx) + " x " +
                                          std::to_string(ahead.ny) + "; the table contains " + std::to_string(pair.nx) +
                                          " x " + std::to_string(pair.ny));
    using enum Axis;
    ShiftedTable change = ahead;
    for (const Axis i : {x, y})
        for (const Axis j : {x, y, z})
            for (int l = 1 - ahead.ny; l < ahead.ny; ++l)
                for (int k = 1 - ahead.nx; k < ahead.nx; ++k) {
                    double& value = change(i, j, k, l);
                    value = pair.at(i, j, k, l) - value;
                }
    return change;
}

}  // namespace contactd
