// Creates random shift problems, and checks Coulomb's law on their solutions independently of the solvers.
#pragma once

#include "contact/normal/normal.hpp"
#include "contact/tangential/prescribed_force.hpp"
#include "contact/tangential/tangential.hpp"
#include "random_problems.hpp"

namespace contactd::test {

struct Motion2d {
    double wx = 0, wy = 0, turn = 0;  // rigid shift (mm), rotation
    std::optional<double> Fx, Fy;     // prescribed forces, in units of the largest force
};

struct RandomFriction {
    Grid grid;
    IcTable table;
    Values bound;
    Values previous_x, previous_y;  // empty: no step before
    Motion2d motion;

    bool has_history() const { return !previous_x.empty(); }
    double largest_force() const {
        double sum = 0;
        for (const double g : bound) sum += g;
        return sum * grid.element_area();
    }
};

struct FrictionAnswer {
    TangentialSolution tangential;
    Values rigid_x, rigid_y;              // with the motion found
    std::optional<SolverEvidence> force;  // where forces are prescribed
    bool converged() const { return tangential.evidence.converged && (!force || force->converged); }
};

inline void add_motion(const Grid& grid, const Motion2d& motion, Values& rigid_x, Values& rigid_y) {
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix) {
            rigid_x[at(grid, ix, iy)] += motion.wx - motion.turn * grid.y(iy);
            rigid_y[at(grid, ix, iy)] += motion.wy + motion.turn * grid.x(ix);
        }
}

inline FrictionAnswer solve(const RandomFriction& problem) {
    const PairOperator influence(problem.table, problem.grid.nx, problem.grid.ny);
    const std::size_t n = problem.grid.size();
    Values history_x(n), history_y(n);
    if (problem.has_history()) {
        influence.tangential(problem.previous_x, problem.previous_y, history_x, history_y);
        for (Values* values : {&history_x, &history_y})
            for (double& value : *values) value = -value;
    }
    Observer observer;
    FrictionAnswer answer;
    Values start_x = problem.previous_x, start_y = problem.previous_y;
    Motion2d motion = problem.motion;
    const double area = problem.grid.element_area(), largest = problem.largest_force();
    const auto solve_for = [&](double wx, double wy, double tolerance) {
        motion.wx = wx;
        motion.wy = wy;
        answer.rigid_x = history_x;
        answer.rigid_y = history_y;
        add_motion(problem.grid, motion, answer.rigid_x, answer.rigid_y);
        answer.tangential = solve_tangential(influence, problem.bound, answer.rigid_x, answer.rigid_y,
                                             {tolerance, 1000}, start_x, start_y, observer);
        start_x = answer.tangential.traction_x;
        start_y = answer.tangential.traction_y;
        ForcesAtSlip forces{0, 0, answer.tangential.evidence.converged};
        for (std::size_t i = 0; i < n; ++i) {
            forces.Fx += start_x[i] * area;
            forces.Fy += start_y[i] * area;
        }
        return forces;
    };
    if (!motion.Fx && !motion.Fy) {
        solve_for(motion.wx, motion.wy, 1e-6);
        return answer;
    }
    PrescribedForces prescribed;
    if (motion.Fx) prescribed.Fx = *motion.Fx * largest;
    if (motion.Fy) prescribed.Fy = *motion.Fy * largest;
    prescribed.largest = largest;
    prescribed.wx = motion.Fx ? 0 : motion.wx;
    prescribed.wy = motion.Fy ? 0 : motion.wy;
    prescribed.scale = slip_scale(influence, problem.bound);
    answer.force = find_rigid_slip(prescribed, {1e-6, 100}, solve_for, observer).evidence;
    return answer;
}

inline Motion2d random_motion(Dice& dice, const Grid& grid, double scale) {
    Motion2d motion;
    const double angle = dice.uniform(0, 6.3), size = scale * dice.log_uniform(1e-3, 30);
    motion.wx = dice.chance(0.1) ? 0 : size * std::cos(angle);
    motion.wy = dice.chance(0.1) ? 0 : size * std::sin(angle);
    if (dice.chance(0.5)) motion.turn = scale * dice.log_uniform(1e-2, 30) / (grid.nx * grid.dx + grid.ny * grid.dy);
    if (dice.chance(0.6)) return motion;
    const double force = dice.chance(0.1)   ? 0
                         : dice.chance(0.2) ? 1 - dice.log_uniform(1e-5, 1e-2)  // closer than 1e-6 is refused
                                            : dice.uniform(0, 1);
    const int components = dice.integer(1, 3);
    if (components == 3) {
        motion.Fx = force * std::cos(angle);
        motion.Fy = force * std::sin(angle);
    } else {
        (components == 1 ? motion.Fx : motion.Fy) = dice.chance(0.5) ? force : -force;
    }
    return motion;
}

// Returns bounds from a normal contact, or without a pattern.
inline Values random_bound(Dice& dice, const RandomNormal& normal, const Values& pressure) {
    Values bound = pressure;
    const double mu = dice.chance(0.05) ? 0 : dice.uniform(0, 1);
    const bool differs = dice.chance(0.15);
    for (double& g : bound) g *= differs ? dice.uniform(0, 1) : mu;
    if (dice.chance(0.1))
        for (double& g : bound) g = dice.chance(0.3) ? 0 : dice.log_uniform(1e-3, 1) * normal.material.G * 1e-3;
    return bound;
}

inline RandomFriction random_friction(std::uint64_t seed, int largest_size) {
    const RandomNormal normal = random_normal(seed, largest_size);
    Dice dice(seed + 1'000'000'007);
    RandomFriction problem{normal.grid, normal.table, {}, {}, {}, {}};
    const PairOperator influence(normal.table, normal.grid.nx, normal.grid.ny);
    Observer observer;
    const auto pressure = [&](double factor) {
        if (normal.pressure_sum)
            return solve_normal_force(influence, normal.distance, factor * *normal.pressure_sum, {}, {}, observer)
                .pressure;
        Values gap = normal.distance;
        for (double& h : gap) h -= factor * normal.approach;
        return solve_normal(influence, gap, {}, {}, observer).pressure;
    };
    const Values now = pressure(1);
    if (dice.chance(0.4)) {
        RandomFriction before = problem;
        before.bound = random_bound(dice, normal, dice.chance(0.5) ? now : pressure(dice.uniform(0.7, 1.3)));
        before.motion = random_motion(dice, problem.grid, slip_scale(influence, before.bound));
        const TangentialSolution solution = solve(before).tangential;
        problem.previous_x = solution.traction_x;
        problem.previous_y = solution.traction_y;
    }
    problem.bound = random_bound(dice, normal, now);
    problem.motion = random_motion(dice, problem.grid, slip_scale(influence, problem.bound));
    return problem;
}

/// Returns violations of Coulomb's law by more than `accuracy` of the displacements, and deviations of the forces;
/// empty if there are none.
inline std::string friction_faults(const RandomFriction& problem, const FrictionAnswer& answer, double accuracy) {
    const int nx = problem.grid.nx, ny = problem.grid.ny;
    const auto &px = answer.tangential.traction_x, &py = answer.tangential.traction_y;
    const auto A = [&](Axis i, Axis j, const Values& p) { return dense_product(problem.table, i, j, nx, ny, p); };
    const Values ux = sum(A(Axis::x, Axis::x, px), A(Axis::x, Axis::y, py));
    const Values uy = sum(A(Axis::y, Axis::x, px), A(Axis::y, Axis::y, py));
    double unit = 0, Fx = 0, Fy = 0;
    for (std::size_t i = 0; i < px.size(); ++i) {
        if (!(problem.bound[i] > 0)) continue;
        unit = std::max({unit, std::hypot(ux[i], uy[i]), std::hypot(answer.rigid_x[i], answer.rigid_y[i])});
        Fx += px[i] * problem.grid.element_area();
        Fy += py[i] * problem.grid.element_area();
    }
    unit *= accuracy;
    for (std::size_t i = 0; i < px.size(); ++i) {
        const double p = std::hypot(px[i], py[i]), g = problem.bound[i];
        const double sx = ux[i] + answer.rigid_x[i], sy = uy[i] + answer.rigid_y[i];
        const std::string where = "element " + std::to_string(i) + ": ";
        if (!(p <= g * (1 + 1e-9))) return where + "the traction exceeds its bound";
        switch (answer.tangential.element_division[i]) {
            case ElementState::exterior:
                if (g > 0) return where + "exterior with a bound";
                break;
            case ElementState::adhesion:
                if (!(std::hypot(sx, sy) <= unit)) return where + "adhesion slips";
                break;
            case ElementState::flow:  // there is no layer
            case ElementState::slip:
                if (!(p >= g * (1 - 1e-9))) return where + "slip below the bound";
                if (!(std::abs(sx * py[i] - sy * px[i]) <= g * unit))
                    return where + "slip and traction are not aligned";
                if (!(sx * px[i] + sy * py[i] <= g * unit)) return where + "slip along the traction";
                break;
        }
    }
    const double largest = problem.largest_force(), most = 1.01e-6 * largest;
    const double off_x = problem.motion.Fx ? Fx - *problem.motion.Fx * largest : 0;
    const double off_y = problem.motion.Fy ? Fy - *problem.motion.Fy * largest : 0;
    if (!(std::hypot(off_x, off_y) <= most)) return "the force is off by " + std::to_string(std::hypot(off_x, off_y));
    return {};
}

}  // namespace contactd::test
