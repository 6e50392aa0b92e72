// Creates random contact problems of every kind, and checks all contact conditions on the answers independently of the
// solvers: dissimilar and rigid bodies, shifts and rolling, histories, forces, slip laws.
#pragma once

#include <cstdio>

#include "contact/tangential/friction_law.hpp"
#include "influence/layered/layered_table.hpp"
#include "influence/viscoelastic/rolling_table.hpp"
#include "random_problems.hpp"

namespace contactd::test {

inline MaterialPair random_bodies(Dice& dice) {
    const Material one = random_material(dice);
    if (dice.chance(0.4)) return {one, one};
    if (dice.chance(0.3)) return {Material::rigid(), one};
    Material other = random_material(dice);
    if (dice.chance(0.7)) other.G = one.G * dice.log_uniform(0.2, 5);
    return {one, other};
}

/// Returns the order of displacements and slips if most of the contact slips.
inline double slip_unit(const ContactProblem& problem, const ContactSolution& normal, double mu) {
    const double compliance = 1 / problem.bodies.upper.material.G + 1 / problem.bodies.lower.material.G;
    return mu * normal.pmax * compliance * std::sqrt(std::max(normal.area.contact, problem.grid.element_area())) * 0.5;
}

inline void prescribe_force(Dice& dice, double largest, Force& prescribed) {
    const double force = dice.uniform(0, 0.95) * largest, angle = dice.uniform(0, 6.3);
    if (dice.chance(0.7)) prescribed.Fx = force * std::cos(angle);
    if (!prescribed.Fx || dice.chance(0.7)) prescribed.Fy = force * std::sin(angle);
}

inline Motion random_motion(Dice& dice, const ContactProblem& problem, const ContactSolution& normal, double mu) {
    const double unit = slip_unit(problem, normal, mu), angle = dice.uniform(0, 6.3);
    const double length = std::sqrt(std::max(normal.area.contact, problem.grid.element_area()));
    const double size = unit * dice.log_uniform(0.01, 5), turn = dice.chance(0.5) ? unit / length : 0;
    const double largest = mu * normal.forces.Fn;
    const bool forces = dice.chance(0.3) && largest > 0;
    if (dice.chance(0.4)) {
        Shift shift{{size * std::cos(angle), size * std::sin(angle)}, turn * dice.uniform(-1, 1)};
        if (forces) prescribe_force(dice, largest, shift.force);
        return shift;
    }
    Rolling rolling;
    rolling.dq = problem.grid.dx * (dice.chance(0.6) ? 1 : dice.uniform(0.4, 2));
    rolling.chi = dice.chance(0.6) ? 0 : dice.uniform(-3.2, 3.2);
    rolling.xi = size / length * std::cos(angle);
    rolling.eta = size / length * std::sin(angle);
    rolling.phi = turn / length * dice.uniform(-1, 1);
    if (!dice.chance(0.6)) rolling.kind = RollingKind::transient;
    if (!rolling.steady()) rolling.steps = dice.chance(0.5) ? 1 : 3;
    if (forces) prescribe_force(dice, largest, rolling.force);
    rolling.spin_offset = dice.uniform(0, 1);
    return rolling;
}

inline ContactProblem random_contact(std::uint64_t seed, int largest_size) {
    Dice dice(seed + 77'000'000);
    ContactProblem problem;
    problem.grid = random_grid(dice, 3, largest_size);
    problem.bodies = Bodies::of(random_bodies(dice));
    const Values h = random_distance(dice, problem.grid);
    problem.gap = h;
    const auto [least, most] = std::minmax_element(h.begin(), h.end());
    problem.approach = *least + (dice.chance(0.05) ? -0.1 : dice.log_uniform(1e-3, 1)) * std::max(*most - *least, 1e-3);
    const ContactSolution normal = solve_half_spaces(problem);
    if (dice.chance(0.5)) {
        problem.Fn = normal.forces.Fn;
        problem.approach.reset();
    }
    if (dice.chance(0.1)) return problem;
    FrictionLaw friction;
    friction.mu = {dice.chance(0.05) ? 0 : dice.uniform(0, 1)};
    const double mu = friction.mu[0];
    problem.motion = random_motion(dice, problem, normal, mu);
    if (dice.chance(0.15)) {
        friction.mu = Values(h.size());
        for (double& value : friction.mu) value = mu * dice.uniform(0.97, 1.1);
    }
    const bool forces = std::visit([](const auto& motion) { return !motion.force.empty(); }, problem.motion);
    if (dice.chance(0.15) && !forces &&
        mu * normal.pmax > 0)  // falling friction may not carry a force that static friction carries
        friction.kinetic = KineticFriction{dice.chance(0.5) ? SlipLaw::linear : SlipLaw::exponential,
                                           0.9 * mu * dice.uniform(0.5, 1), slip_unit(problem, normal, mu) * 10};
    problem.friction = friction;
    const auto* rolling = std::get_if<Rolling>(&problem.motion);
    if (dice.chance(0.3) && !(rolling && rolling->steady())) {
        const ContactSolution before = solve_half_spaces(problem);
        problem.previous = {before.pressure, before.traction_x, before.traction_y};
    }
    return problem;
}

/// Returns displacements at points (x, y) from the element centres, by sums over closed forms.
struct Surface {
    Values x, y, z;
};

/// Returns coefficients of a body between elements, with offsets of either sign, at points at this distance from the
/// centres.
class BodyCoefficients {
   public:
    BodyCoefficients(const Grid& grid, const Body& body, double shift_x, double shift_y)
        : grid_(grid), body_(body), shift_x_(shift_x), shift_y_(shift_y) {
        lattice_ = {.first_x = (1 - grid.nx) * grid.dx + shift_x,
                    .first_y = (1 - grid.ny) * grid.dy + shift_y,
                    .nx = 2 * grid.nx - 1,
                    .ny = 2 * grid.ny - 1,
                    .dx = grid.dx,
                    .dy = grid.dy};
        if (const Layers* layers = body.layered())
            layers_ = layered_coefficients(*layers, body.computed()->load_shape, lattice_);
    }

    /// Coefficients of a viscoelastic body are one step ahead unless the points are the centres.
    BodyCoefficients(const ContactProblem& problem, const Body& body, double shift_x, double shift_y)
        : BodyCoefficients(problem.grid, body, shift_x, shift_y) {
        if (!body.viscoelastic || body.material.is_rigid()) return;
        const auto& rolling = std::get<Rolling>(problem.motion);
        const RollingHalfSpaces alone{{{Material::rigid()}, body}, rolling.velocity, std::cos(rolling.chi) > 0};
        if (shift_x == 0)
            rolls_ = rolling_table(alone, problem.grid);
        else
            ahead_ = rolling_table_ahead(alone, problem.grid, std::abs(shift_x));
    }

    /// 0 <= k < 2 nx - 1, 0 <= l < 2 ny - 1.
    double at(Axis i, Axis j, int k, int l) const {
        using enum Axis;
        if (body_.material.is_rigid()) return 0;
        if (rolls_.nx > 0) return rolls_(i, j, k - grid_.nx + 1, l - grid_.ny + 1);
        if (ahead_.nx > 0) return i == z ? 0 : ahead_(i, j, k - grid_.nx + 1, l - grid_.ny + 1);
        if (layers_.empty())
            return half_space_coefficient(i, j, (k - grid_.nx + 1) * grid_.dx + shift_x_,
                                          (l - grid_.ny + 1) * grid_.dy + shift_y_, grid_.dx, grid_.dy, body_.material);
        const SurfaceCoefficients& at = layers_[lattice_.index(k, l)];
        if (i == j) return i == x ? at.xx : i == y ? at.yy : at.zz;
        if (i != z && j != z) return at.xy;
        return j == z ? (i == x ? at.xz : at.yz) : (j == x ? -at.xz : -at.yz);
    }

   private:
    const Grid& grid_;
    const Body& body_;
    double shift_x_, shift_y_;
    OffsetLattice lattice_;
    std::vector<SurfaceCoefficients> layers_;
    RollingTable rolls_;
    ShiftedTable ahead_;
};

inline Surface displacements(const ContactProblem& problem, const Values& pz, const Values& px, const Values& py,
                             double shift_x, double shift_y) {
    const Grid& grid = problem.grid;
    const int mx = 2 * grid.nx - 1, my = 2 * grid.ny - 1;
    const Bodies bodies = without_instant_creep(problem.bodies);
    const BodyCoefficients upper(problem, bodies.upper, shift_x, shift_y);
    const BodyCoefficients lower(problem, bodies.lower, shift_x, shift_y);
    const auto coefficients = [&](Axis i, Axis j) {
        const bool couples = (i == Axis::z) != (j == Axis::z);
        Values table;
        for (int l = 0; l < my; ++l)
            for (int k = 0; k < mx; ++k) {
                // The lower body carries the opposite tractions, in a frame that is mirrored for coupled components.
                const double above = upper.at(i, j, k, l), below = lower.at(i, j, k, l);
                table.push_back(couples ? below - above : above + below);
            }
        return table;
    };
    Surface result{Values(pz.size()), Values(pz.size()), Values(pz.size())};
    for (const auto& [i, u] : {std::pair{Axis::x, &result.x}, {Axis::y, &result.y}, {Axis::z, &result.z}})
        for (const auto& [j, p] : {std::pair{Axis::x, &px}, {Axis::y, &py}, {Axis::z, &pz}}) {
            if (std::all_of(p->begin(), p->end(), [](double value) { return value == 0; })) continue;
            const Values table = coefficients(i, j);
            for (int from = 0; from < grid.nx * grid.ny; ++from) {
                const double value = (*p)[static_cast<std::size_t>(from)];
                if (value == 0) continue;
                const int fx = from % grid.nx, fy = from / grid.nx;
                for (int iy = 0; iy < grid.ny; ++iy)
                    for (int ix = 0; ix < grid.nx; ++ix)
                        (*u)[at(grid, ix, iy)] +=
                            value *
                            table[static_cast<std::size_t>((iy - fy + grid.ny - 1) * mx + ix - fx + grid.nx - 1)];
            }
        }
    return result;
}

/// Returns the entry position of a particle that has entered during a step longer than an element, and the fraction of
/// the step that it has spent in contact.
struct Entry {
    std::size_t from = 0;
    double part = 1;
};
inline std::optional<Entry> entry_of(const ContactProblem& problem, const Values& pressure, int ix, int iy) {
    const Grid& grid = problem.grid;
    const auto* rolling = std::get_if<Rolling>(&problem.motion);
    if (rolling == nullptr || rolling->steady() || !(pressure[at(grid, ix, iy)] > 0)) return {};
    const auto [step_x, step_y] = step_of(problem);
    const double length = std::max(std::abs(step_x) / grid.dx, std::abs(step_y) / grid.dy);  // in elements
    for (int k = 1; k < length - 1e-9; ++k) {
        const int x = ix + static_cast<int>(std::lround(k / length * step_x / grid.dx));
        const int y = iy + static_cast<int>(std::lround(k / length * step_y / grid.dy));
        const int near_x = std::clamp(x, 0, grid.nx - 1), near_y = std::clamp(y, 0, grid.ny - 1);
        if (x != near_x || y != near_y || !(pressure[at(grid, x, y)] > 0))
            return Entry{at(grid, near_x, near_y), k / length};
    }
    return {};
}

/// Returns the slip over the last step per element (mm), without the effect of the present tractions.
inline Surface given_slip(const ContactProblem& problem, const ContactSolution& solution, const SurfaceState& before) {
    const Grid& grid = problem.grid;
    const std::size_t n = grid.size();
    double x = 0, y = 0, turn = 0, unit = 1, ahead_x = 0, ahead_y = 0;
    const auto [shift_x, shift_y] = step_of(problem);
    bool steady = false;
    if (const auto* rolling = std::get_if<Rolling>(&*solution.motion)) {
        unit = step_length(*rolling, grid);
        x = rolling->xi;
        y = rolling->eta;
        turn = rolling->phi;
        ahead_x = rolling->spin_offset * shift_x;
        ahead_y = rolling->spin_offset * shift_y;
        steady = rolling->steady();
    } else {
        const auto& shift = std::get<Shift>(*solution.motion);
        x = shift.rigid_shift.x;
        y = shift.rigid_shift.y;
        turn = shift.rotation;
    }
    const auto full = [&](Values values) {
        values.resize(n);
        return values;
    };
    const Surface old =
        steady ? displacements(problem, solution.pressure, solution.traction_x, solution.traction_y, shift_x, shift_y)
               : displacements(problem, full(before.pressure), full(before.traction_x), full(before.traction_y),
                               shift_x, shift_y);
    const Surface there =
        steady ? Surface{}
               : displacements(problem, full(before.pressure), full(before.traction_x), full(before.traction_y), 0, 0);
    Surface slip{Values(n), Values(n), {}};
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix) {
            const std::size_t i = at(grid, ix, iy);
            if (const auto entry = entry_of(problem, solution.pressure, ix, iy)) {
                const double w = entry->part * unit;
                const bool more = !problem.rigid_slip.empty();
                slip.x[i] = w * (x - turn * (grid.y(iy) + ahead_y) + (more ? problem.rigid_slip.x[i] : 0)) -
                            there.x[entry->from];
                slip.y[i] = w * (y + turn * (grid.x(ix) + ahead_x) + (more ? problem.rigid_slip.y[i] : 0)) -
                            there.y[entry->from];
                continue;
            }
            slip.x[i] = unit * (x - turn * (grid.y(iy) + ahead_y)) - old.x[i];
            slip.y[i] = unit * (y + turn * (grid.x(ix) + ahead_x)) - old.y[i];
            if (problem.rigid_slip.empty()) continue;
            slip.x[i] += unit * problem.rigid_slip.x[i];
            slip.y[i] += unit * problem.rigid_slip.y[i];
        }
    return slip;
}

/// Returns violations of the contact conditions that exceed `accuracy`; empty if there are none. `before` is the state
/// at the start of the last step.
inline std::string contact_faults(const ContactProblem& problem, const ContactSolution& solution,
                                  const SurfaceState& before, double accuracy) {
    const Values h = undeformed_distance(problem);
    const Surface u = displacements(problem, solution.pressure, solution.traction_x, solution.traction_y, 0, 0);
    double depth = 0;
    for (std::size_t i = 0; i < h.size(); ++i) depth = std::max({depth, solution.approach - h[i], std::abs(u.z[i])});
    const auto where = [](std::size_t i, const char* what) { return "element " + std::to_string(i) + ": " + what; };
    for (std::size_t i = 0; i < h.size(); ++i) {
        const double gap = h[i] - solution.approach + u.z[i];
        if (!(solution.pressure[i] >= 0)) return where(i, "negative pressure");
        if (solution.pressure[i] > 0 && std::abs(gap) > accuracy * depth) return where(i, "contact with a gap");
        if (solution.pressure[i] == 0 && gap < -accuracy * depth) return where(i, "overlap");
    }
    if (problem.Fn && std::abs(solution.forces.Fn - *problem.Fn) > 1e-6 * *problem.Fn)
        return "the normal force is missed";
    if (!problem.friction) return {};
    const FrictionLaw& friction = *problem.friction;
    const Surface w = given_slip(problem, solution, before);
    const auto* rolling = std::get_if<Rolling>(&*solution.motion);
    const double seconds =
        rolling ? step_length(*rolling, problem.grid) / rolling->velocity : std::get<Shift>(*solution.motion).duration;
    double unit = 0;
    for (std::size_t i = 0; i < h.size(); ++i)
        if (solution.pressure[i] > 0) unit = std::max({unit, std::hypot(u.x[i], u.y[i]), std::hypot(w.x[i], w.y[i])});
    unit *= accuracy;
    for (std::size_t i = 0; i < h.size(); ++i) {
        const double sx = w.x[i] + u.x[i], sy = w.y[i] + u.y[i], s = std::hypot(sx, sy);
        const double px = solution.traction_x[i], py = solution.traction_y[i], p = std::hypot(px, py);
        const double v = solution.element_division[i] == ElementState::slip ? s / seconds : 0;
        const double mu =
            friction.kinetic ? friction_coefficient(*friction.kinetic, friction.mu_of(i), v) : friction.mu_of(i);
        const double g = mu * solution.pressure[i], slack = friction.kinetic ? 1e-3 : 1e-8;
        if (!(p <= g * (1 + slack) + 1e-300)) return where(i, "the traction exceeds its bound");
        if (solution.element_division[i] == ElementState::adhesion && s > unit) return where(i, "adhesion slips");
        if (solution.element_division[i] != ElementState::slip || g == 0) continue;
        if (!(p >= g * (1 - slack))) return where(i, "slip below the bound");
        if (std::abs(sx * py - sy * px) > p * unit) return where(i, "slip and traction are not aligned");
        if (sx * px + sy * py > p * unit) return where(i, "slip along the traction");
    }
    return {};
}

/// Returns the state before the last step of a transient with several steps, by solving them one by one.
inline SurfaceState state_before_last(const ContactProblem& problem,
                                      ContactSolution (*solve)(const ContactProblem&) = solve_half_spaces) {
    if (!problem.friction) return problem.previous;
    const auto* rolling = std::get_if<Rolling>(&problem.motion);
    if (rolling == nullptr || rolling->steady() || rolling->steps == 1) return problem.previous;
    ContactProblem shorter = problem;
    --std::get<Rolling>(shorter.motion).steps;
    const ContactSolution before = solve(shorter);
    return {before.pressure, before.traction_x, before.traction_y};
}

/// Prints the solvers that missed their tolerances.
inline void print_unconverged(const ContactSolution& solution) {
    std::printf("not converged:");
    const auto print = [](const char* name, const std::optional<SolverEvidence>& evidence) {
        if (evidence && !evidence->converged)
            std::printf(" %s %d %.1e", name, evidence->iterations, evidence->residual);
    };
    print("normal", solution.evidence.normal);
    print("tangential", solution.evidence.tangential);
    print("outer", solution.evidence.outer);
    print("force", solution.evidence.force);
    std::printf("\n");
}

}  // namespace contactd::test
