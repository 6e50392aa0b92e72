// Compares operators of half-spaces that rotate from row to row with tables recomputed for the rows.
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numeric>

#include "bodies/rotated_influence.hpp"
#include "contact/contact_cases.hpp"
#include "influence/rotated/rotated_half_space.hpp"
#include "influence/rotated/strip_values.hpp"
#include "wheel_rail/patches/half_space_cache.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;

namespace {

using enum Axis;

ContactProblem rolling_problem(const MaterialPair& bodies, const Grid& grid, double elements_per_step) {
    ContactProblem problem;
    problem.grid = grid;
    problem.bodies = {{bodies.upper}, {bodies.lower}};
    if (elements_per_step == 0) return problem;
    problem.friction = FrictionLaw{};
    problem.motion =
        Rolling{.chi = elements_per_step < 0 ? std::acos(-1.0) : 0.0, .dq = std::abs(elements_per_step) * grid.dx};
    return problem;
}

/// Rows whose curvature changes.
std::vector<StripFrame> bent_rows(int ny) {
    std::vector<StripFrame> frames;
    for (int row = 0; row < ny; ++row) frames.push_back({0, 0, 0.4 - 0.09 * row + 0.004 * row * row});
    return frames;
}

ContactInfluence influence_of(const ContactProblem& problem, const std::vector<StripFrame>& frames) {
    const MidwayInfluence midway = midway_influence(problem, make_influence(problem, pair_table(problem)));
    return rotated_influence(problem, midway, frames);
}

/// Returns the table of the pair at the offsets k dx + shift, from one coefficient to the next.
StripTable made_anew(const ContactProblem& problem, std::vector<StripFrame> frames, double shift = 0) {
    const Grid& grid = problem.grid;
    const auto table_of = [&](const Material& material) {
        if (material.is_rigid()) return StripTable(grid.nx, grid.ny);
        return rotated_half_space({frames, grid.dy, 0, grid.dx, grid.nx}, material, LoadShape::constant, shift);
    };
    const auto [upper, lower] = problem.bodies.materials();
    StripTable below = table_of(lower);
    std::reverse(frames.begin(), frames.end());
    return pair_of(table_of(upper), std::move(below));
}

/// Holds TablesAnew at offsets of both signs, minus those one step ahead if a step is given.
class TablesAnew {
   public:
    TablesAnew(const ContactProblem& problem, const std::vector<StripFrame>& frames)
        : here_(made_anew(problem, frames)), before_(here_), ahead_(here_) {}
    TablesAnew(const ContactProblem& problem, const std::vector<StripFrame>& frames, double step)
        : here_(made_anew(problem, frames)),
          before_(made_anew(problem, frames, -step)),
          ahead_(made_anew(problem, frames, step)),
          changes_(true) {}

    double operator()(Axis i, Axis j, int I, int J, int k) const {
        const double sign = parity(i, j).along_x;
        if (!changes_) return here_.at(i, j, I, J, k);
        // In the mirror image, an element ahead at a negative offset lies before a positive one.
        return here_.at(i, j, I, J, k) - (k >= 0 ? ahead_(i, j, I, J, k) : sign * before_(i, j, I, J, -k));
    }

   private:
    const StripTable here_, before_, ahead_;
    const bool changes_ = false;
};

/// Sums displacements along i at some elements of a box for tractions along j on all of it.
struct Sampled {
    const TablesAnew& coefficients;
    ElementBox box;

    double at(std::size_t element, Axis i, Axis j, const Values& p) const {
        double u = 0;
        const int nx = box.nx, to = static_cast<int>(element);
        for (int from = 0; from < static_cast<int>(box.size()); ++from)
            u += coefficients(i, j, box.first_y + to / nx, box.first_y + from / nx, to % nx - from % nx) *
                 p[static_cast<std::size_t>(from)];
        return u;
    }
    void check(const Values& u, const std::vector<std::pair<Axis, const Values*>>& loads, Axis i) const {
        const std::size_t apart = std::max<std::size_t>(1, u.size() / 150);
        for (std::size_t element = 0; element < u.size(); element += apart) {
            double sum = 0;
            for (const auto& [j, p] : loads) sum += at(element, i, j, *p);
            CHECK_THAT(u[element], WithinAbs(sum, 1e-11 * largest(u)));
        }
    }
};

void check_products(const InfluenceOperator& influence, const TablesAnew& coefficients, const ElementBox& box) {
    const std::size_t n = box.size();
    REQUIRE(influence.size() == n);
    REQUIRE(influence.coupled());
    const Values px = random_values(n, 1), py = random_values(n, 2), pz = random_values(n, 3);
    Values ux(n), uy(n), uz(n);
    const Sampled sums{coefficients, box};
    influence.normal(pz, uz);
    sums.check(uz, {{z, &pz}}, z);
    influence.tangential(px, py, ux, uy);
    sums.check(ux, {{x, &px}, {y, &py}}, x);
    sums.check(uy, {{x, &px}, {y, &py}}, y);
    influence.normal_of_tangential(px, py, uz);
    sums.check(uz, {{x, &px}, {y, &py}}, z);
    influence.tangential_of_normal(pz, ux, uy);
    sums.check(ux, {{z, &pz}}, x);
    sums.check(uy, {{z, &pz}}, y);
}

void check_steps(const StepOperator& step, const TablesAnew& coefficients, const ElementBox& box) {
    const std::size_t n = box.size();
    const Values px = random_values(n, 1), py = random_values(n, 2), pz = random_values(n, 3);
    Values ux(n), uy(n);
    const Sampled sums{coefficients, box};
    step.tangential(px, py, ux, uy);
    sums.check(ux, {{x, &px}, {y, &py}}, x);
    sums.check(uy, {{x, &px}, {y, &py}}, y);
    step.tangential_of_normal(pz, ux, uy);
    sums.check(ux, {{z, &pz}}, x);
    sums.check(uy, {{z, &pz}}, y);
}

const Material soft{300, 0.3}, softer{100, 0.45};

}  // namespace

TEST_CASE("Rows that turn have the coefficients of tables that are made anew for them", "[rotated]") {
    const MaterialPair bodies =
        GENERATE(MaterialPair{soft, soft}, MaterialPair{soft, softer}, MaterialPair{Material::rigid(), softer},
                 MaterialPair{soft, Material::rigid()});
    const auto [nx, ny] = GENERATE(std::pair{9, 6}, std::pair{4, 7}, std::pair{1, 5}, std::pair{20, 2});
    CAPTURE(bodies.upper.nu, bodies.lower.nu, nx, ny);
    const ContactProblem problem = rolling_problem(bodies, Grid::of_elements(nx, ny, 0.5, 0.4), 0);
    const auto frames = bent_rows(ny);
    const ContactInfluence influence = influence_of(problem, frames);
    CHECK(!influence.increment);
    const TablesAnew coefficients(problem, frames);
    check_products(*influence.current, coefficients, {0, 0, nx, ny});
    for (const Axis i : {x, y, z})
        CHECK_THAT(influence.current->diagonal(i).back(),
                   WithinAbs(coefficients(i, i, ny - 1, ny - 1, 0), 1e-12 * coefficients(z, z, 0, 0, 0)));
}

TEST_CASE("Boxes of rows that turn have the coefficients of these rows", "[rotated]") {
    const ContactProblem problem = rolling_problem({soft, softer}, Grid::of_elements(20, 26, 0.5, 0.4), 1);
    const auto frames = bent_rows(26);
    const ContactInfluence influence = influence_of(problem, frames);
    REQUIRE(influence.current->boxes() != nullptr);
    const ElementBox box{3, 7, 9, 5};
    check_products(*influence.current->boxes()->influence(box), TablesAnew(problem, frames), box);
    const auto step = influence.increment->on(box);
    REQUIRE(step);
    check_steps(*step, TablesAnew(problem, frames, problem.grid.dx), box);
}

TEST_CASE("Steps of rolling change the coefficients of rows that turn as tables a step ahead say", "[rotated]") {
    const double elements = GENERATE(1.0, -1.0, 2.0, 0.4, -1.3);
    const MaterialPair bodies = GENERATE(MaterialPair{soft, soft}, MaterialPair{soft, softer});
    CAPTURE(elements, bodies.lower.nu);
    const ContactProblem problem = rolling_problem(bodies, Grid::of_elements(8, 7, 0.5, 0.4), elements);
    const auto frames = bent_rows(7);
    const ContactInfluence influence = influence_of(problem, frames);
    REQUIRE(influence.increment);
    check_steps(*influence.increment, TablesAnew(problem, frames, elements * problem.grid.dx), {0, 0, 8, 7});
}

TEST_CASE("A large patch whose rows turn has the coefficients of small ones", "[rotated]") {
    const int nx = 200, ny = 100;
    const ContactProblem problem = rolling_problem({soft, soft}, Grid::of_elements(nx, ny, 0.5, 0.4), 1);
    std::vector<StripFrame> frames;
    for (int row = 0; row < ny; ++row) frames.push_back({0, 0, 0.6 * std::sin(0.02 * row)});
    const ContactInfluence influence = influence_of(problem, frames);
    // Applies loads on a small part of it, in two distant rows.
    const int rows[] = {3, 90}, columns = 4;
    const std::size_t n = problem.grid.size();
    Values px(n), py(n), pz(n), ux(n), uy(n), uz(n), vx(n), vy(n);
    for (const int row : rows)
        for (int k = 0; k < columns; ++k) {
            const std::size_t here = at(problem.grid, 50 + k, row);
            px[here] = 1 + k;
            py[here] = 2 - row;
            pz[here] = k * k;
        }
    influence.current->tangential(px, py, ux, uy);
    influence.current->tangential_of_normal(pz, vx, vy);
    influence.current->normal(pz, uz);
    const double zz = influence.current->diagonal(z)[0];
    double sum_of_loads = 0;
    for (const Values* loads : {&px, &py, &pz})
        for (const double load : *loads) sum_of_loads += std::abs(load);
    for (const int I : rows)
        for (int k = 0; k < columns; ++k) {
            double x_sum = 0, y_sum = 0, z_sum = 0, n_sum = 0;
            for (const int J : rows) {
                const StripView view{(I - J) * 0.4, frames[static_cast<std::size_t>(I)].angle -
                                                        frames[static_cast<std::size_t>(J)].angle};
                const StripAxes axes(view.turn);
                for (int l = 0; l < columns; ++l) {
                    const auto integrals = constant_load_integrals((k - l) * 0.5, view.s, 0.5, 0.4);
                    // Coupling of the half-spaces cancels between both bodies; the other components are added.
                    NineValues midway = nine_values(integrals, soft.nu);
                    for (const std::size_t coupled : {2, 5, 6, 7}) midway[coupled] = 0;
                    const NineValues value = axes(midway);
                    const double sx = 1 + l, sy = 2 - J, sz = l * l, factor = 2 / soft.G;
                    x_sum += factor * (value[0] * sx + value[1] * sy);
                    y_sum += factor * (value[3] * sx + value[4] * sy);
                    n_sum += factor * value[5] * sz;
                    z_sum += factor * value[8] * sz;
                }
            }
            const std::size_t here = at(problem.grid, 50 + k, I);
            const double change = largest_change * zz * sum_of_loads;
            CHECK_THAT(ux[here], WithinAbs(x_sum, change));
            CHECK_THAT(uy[here], WithinAbs(y_sum, change));
            CHECK_THAT(vy[here], WithinAbs(n_sum, change));
            CHECK_THAT(uz[here], WithinAbs(z_sum, change));
        }
}

TEST_CASE("No coefficient of a large patch whose rows turn is changed by more than is said", "[rotated]") {
    const int nx = 40, ny = 31;
    const double elements = GENERATE(1.0, 0.3);
    const MaterialPair bodies = GENERATE(MaterialPair{soft, soft}, MaterialPair{soft, softer});
    CAPTURE(elements, bodies.lower.nu);
    const ContactProblem problem = rolling_problem(bodies, Grid::of_elements(nx, ny, 0.5, 0.4), elements);
    std::vector<StripFrame> frames;
    for (int row = 0; row < ny; ++row) frames.push_back({0, 0, 0.6 * std::sin(0.08 * row)});
    const ContactInfluence influence = influence_of(problem, frames);
    const TablesAnew current(problem, frames), change(problem, frames, elements * problem.grid.dx);
    const std::size_t n = problem.grid.size();
    const Values none(n);
    Values ux(n), uy(n), uz(n);
    double largest_error = 0;
    const int J = GENERATE(0, 12);
    Values load(n);
    load[at(problem.grid, 3, J)] = 1;
    const auto compare = [&](const TablesAnew& exact, const Values& u, Axis i, Axis j) {
        for (int I = 0; I < ny; ++I)
            for (int k = 0; k < nx; ++k)
                largest_error = std::max(largest_error, std::abs(u[at(problem.grid, k, I)] - exact(i, j, I, J, k - 3)));
    };
    const auto both = [&](const TablesAnew& exact, const auto& products) {
        products.tangential(load, none, ux, uy);
        compare(exact, ux, x, x);
        compare(exact, uy, y, x);
        products.tangential(none, load, ux, uy);
        compare(exact, ux, x, y);
        compare(exact, uy, y, y);
        products.tangential_of_normal(load, ux, uy);
        compare(exact, ux, x, z);
        compare(exact, uy, y, z);
    };
    const double zz = current(z, z, 0, 0, 0);
    both(current, *influence.current);
    influence.current->normal(load, uz);
    compare(current, uz, z, z);
    influence.current->normal_of_tangential(load, none, uz);
    compare(current, uz, z, x);
    influence.current->normal_of_tangential(none, load, uz);
    compare(current, uz, z, y);
    CHECK(largest_error <= largest_change * zz);
    CHECK(largest_error > 1e-12 * zz);  // something is left out
    // A step is the difference between two places; a step by part of an element counts by its length.
    largest_error = 0;
    both(change, *influence.increment);
    CHECK(largest_error <= 2 * largest_change * zz);
}

TEST_CASE("Rows that turn are mirrored with their loads", "[rotated]") {
    const int nx = 7, ny = 6;
    const ContactProblem problem = rolling_problem({soft, softer}, Grid::of_elements(nx, ny, 0.5, 0.4), 1);
    const auto frames = bent_rows(ny);
    std::vector<StripFrame> mirrored(frames.rbegin(), frames.rend());
    for (StripFrame& frame : mirrored) frame.angle = -frame.angle;
    const ContactInfluence here = influence_of(problem, frames), there = influence_of(problem, mirrored);
    const std::size_t n = problem.grid.size();
    const auto in_mirror = [&](const Values& values, double sign) {
        Values result(n);
        for (int row = 0; row < ny; ++row)
            for (int k = 0; k < nx; ++k)
                result[at(problem.grid, k, ny - 1 - row)] = sign * values[at(problem.grid, k, row)];
        return result;
    };
    const Values px = random_values(n, 1), py = random_values(n, 2), pz = random_values(n, 3);
    Values ux(n), uy(n), uz(n), vx(n), vy(n), vz(n);
    const auto check = [&] {
        for (std::size_t i = 0; i < n; ++i) {
            CHECK_THAT(vx[i], WithinAbs(in_mirror(ux, 1)[i], 1e-13 * largest(ux)));
            CHECK_THAT(vy[i], WithinAbs(in_mirror(uy, -1)[i], 1e-13 * largest(ux)));
        }
    };
    here.current->tangential(px, py, ux, uy);
    there.current->tangential(in_mirror(px, 1), in_mirror(py, -1), vx, vy);
    check();
    here.increment->tangential_of_normal(pz, ux, uy);
    there.increment->tangential_of_normal(in_mirror(pz, 1), vx, vy);
    check();
    here.current->normal(pz, uz);
    there.current->normal(in_mirror(pz, 1), vz);
    for (std::size_t i = 0; i < n; ++i) CHECK_THAT(vz[i], WithinAbs(in_mirror(uz, 1)[i], 1e-13 * largest(uz)));
}

TEST_CASE("Rows that do not turn lie side by side, and equal bodies on them do not couple", "[rotated]") {
    const ContactProblem problem = rolling_problem({soft, soft}, Grid::of_elements(10, 8, 0.5, 0.4), 1);
    const std::vector<StripFrame> inclined(8, StripFrame{0, 0, 0.7});
    const ContactInfluence flat = make_influence(problem, pair_table(problem)), rows = influence_of(problem, inclined);
    CHECK(!rows.current->coupled());
    CHECK(!rows.increment->coupled());
    const std::size_t n = problem.grid.size();
    const Values p = random_values(n, 1), q = random_values(n, 2);
    Values ux(n), uy(n), vx(n), vy(n);
    const auto check = [&] {
        for (std::size_t i = 0; i < n; ++i) {
            CHECK_THAT(ux[i], WithinAbs(vx[i], 1e-13 * largest(vx)));
            CHECK_THAT(uy[i], WithinAbs(vy[i], 1e-13 * largest(vx)));
        }
    };
    flat.current->tangential(p, q, vx, vy);
    rows.current->tangential(p, q, ux, uy);
    check();
    flat.increment->tangential(p, q, vx, vy);
    rows.increment->tangential(p, q, ux, uy);
    check();
}

TEST_CASE("Rows have the same coefficients whatever a cache was asked for before", "[rotated]") {
    const ContactProblem problem = rolling_problem({soft, soft}, Grid::of_elements(10, 8, 0.5, 0.4), 1);
    HalfSpaceCache used(problem.bodies), fresh(problem.bodies);
    PatchStrips other, asked;
    other.frames = std::vector<StripFrame>(8, StripFrame{0, 0, 0.7});
    asked.frames = bent_rows(8);
    const ContactInfluence before = used.of(problem, other), last = used.of(problem, asked),
                           first = fresh.of(problem, asked);
    const std::size_t n = problem.grid.size();
    const Values p = random_values(n, 1), q = random_values(n, 2);
    Values ux(n), uy(n), vx(n), vy(n), wx(n), wy(n);
    before.current->tangential(p, q, wx, wy);
    last.current->tangential(p, q, ux, uy);
    first.current->tangential(p, q, vx, vy);
    CHECK(ux == vx);
    CHECK(uy == vy);
    CHECK(uy != wy);
}
