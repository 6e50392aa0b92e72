// Creates random contact problems, and checks solutions independently of the solvers, with separate sums of
// displacements, element by element. Numbers come from the generator's raw bits, so a seed gives the same problem on
// all systems.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "contact_cases.hpp"

namespace contactd::test {

class Dice {
   public:
    explicit Dice(std::uint64_t seed) : generator_(seed) {}
    double uniform(double low, double high) {
        return low + (high - low) * (static_cast<double>(generator_() >> 11) * 0x1p-53);
    }
    int integer(int low, int high) {  // both included
        return low + static_cast<int>(generator_() % static_cast<std::uint64_t>(high - low + 1));
    }
    bool chance(double probability) { return uniform(0, 1) < probability; }
    double log_uniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }

   private:
    std::mt19937_64 generator_;
};

inline Grid random_grid(Dice& dice, int smallest, int largest) {
    const auto size = [&] { return static_cast<int>(std::lround(dice.log_uniform(smallest, largest))); };
    const int nx = size(), ny = dice.chance(0.3) ? nx : size();
    const double dx = dice.log_uniform(0.01, 1), dy = dx * (dice.chance(0.3) ? 1 : dice.log_uniform(0.1, 10));
    Grid grid = Grid::of_elements(nx, ny, dx, dy);
    if (dice.chance(0.5)) grid.x0 += dice.uniform(-0.3, 0.3) * nx * dx;
    return grid;
}

inline Material random_material(Dice& dice) {
    return {dice.log_uniform(1, 1e5), dice.chance(0.1) ? 0.5 : dice.uniform(0, 0.5)};
}

/// Returns the undeformed distance, of the order of 1 or less over the grid (mm).
inline Values random_distance(Dice& dice, const Grid& grid) {
    enum { paraboloid, rough, patches, conformal, flat, ridge, kinds };
    const int kind = dice.integer(0, kinds - 1);
    const double half_x = 0.5 * grid.nx * grid.dx, half_y = 0.5 * grid.ny * grid.dy;
    const double bend_x = dice.log_uniform(0.1, 10), bend_y = dice.log_uniform(0.1, 10);
    const double roughness = kind == rough || dice.chance(0.2) ? dice.log_uniform(1e-3, 0.5) : 0;
    std::array<std::array<double, 3>, 5> bumps;
    for (auto& bump : bumps) bump = {dice.uniform(-1, 1), dice.uniform(-1, 1), dice.uniform(0, 0.3)};
    Values distance;
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix) {
            const double x = grid.x(ix) / half_x, y = grid.y(iy) / half_y;
            double h = 0;
            if (kind == paraboloid) h = bend_x * x * x + bend_y * y * y;
            if (kind == conformal) h = 0.01 * (bend_x * std::pow(x, 4) + y * y);
            if (kind == ridge) h = bend_x * std::abs(x) + 0.1 * y;
            if (kind == patches) {
                h = 10;
                for (const auto& [at_x, at_y, height] : bumps)
                    h = std::min(h, height + 4 * ((x - at_x) * (x - at_x) + (y - at_y) * (y - at_y)));
            }
            distance.push_back(h + roughness * dice.uniform(-1, 1));
        }
    return distance;
}

/// Creates normal contacts with prescribed approach or force.
struct RandomNormal {
    Grid grid;
    Material material;
    IcTable table;  // of the pair
    Values distance;
    std::optional<double> pressure_sum;  // or
    double approach = 0;
};

inline RandomNormal random_normal(std::uint64_t seed, int largest_size) {
    Dice dice(seed);
    RandomNormal problem;
    problem.grid = random_grid(dice, 1, largest_size);
    problem.material = random_material(dice);
    problem.table = half_space_pair(problem.grid, problem.material);
    problem.distance = random_distance(dice, problem.grid);
    const auto [least, most] = std::minmax_element(problem.distance.begin(), problem.distance.end());
    const double range = std::max(*most - *least, 1e-3);
    const double depth = dice.chance(0.1) ? -0.1 : dice.log_uniform(1e-3, 2);  // some do not touch
    if (dice.chance(0.5)) {
        problem.approach = *least + depth * range;
    } else {
        // Is roughly the force for the same depth over the whole grid.
        double row = 0;
        for (int l = 0; l < problem.grid.ny; ++l)
            for (int k = 0; k < problem.grid.nx; ++k) row += problem.table(Axis::z, Axis::z, k, l);
        problem.pressure_sum =
            std::max(depth, 0.0) * range / row * dice.log_uniform(0.01, 1) * static_cast<double>(problem.grid.size());
    }
    return problem;
}

/// Returns violations of section 4.1's conditions by the pressures and the computed approach; empty if there are none.
inline std::string normal_faults(const RandomNormal& problem, const Values& p, double approach, double tolerance) {
    const Values u = dense_product(problem.table, Axis::z, Axis::z, problem.grid.nx, problem.grid.ny, p);
    double defect = 0, reference = 0, sum = 0, deepest = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double h = problem.distance[i] - approach, gap = u[i] + h;
        if (!(p[i] >= 0) || !std::isfinite(p[i])) return "a pressure is " + std::to_string(p[i]);
        sum += p[i];
        if (p[i] > 0) {
            defect += gap * gap;
            reference += h * h;
        } else {
            deepest = std::max(deepest, -gap / (std::abs(u[i]) + std::abs(h) + std::abs(approach)));
        }
    }
    if (deepest > 1e-12) return "an element outside contact overlaps by " + std::to_string(deepest * 1e12) + "e-12";
    if (defect > 1.001 * tolerance * tolerance * reference)
        return "the residual is " + std::to_string(std::sqrt(defect / reference) * 1e6) + "e-6";
    if (problem.pressure_sum && std::abs(sum - *problem.pressure_sum) > 1e-10 * *problem.pressure_sum)
        return "the sum of pressures is " + std::to_string(sum) + ", not " + std::to_string(*problem.pressure_sum);
    return {};
}

}  // namespace contactd::test
