#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "bodies/rotated_displacement_influence.hpp"
#include "contact/contact_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;

namespace {

using enum Axis;

struct Vector {
    double x = 0, s = 0, z = 0;
};

/// Uses dissimilar bodies, so that flat half-spaces are coupled.
ContactProblem rolling_problem(const Grid& grid, double dq) {
    ContactProblem problem;
    problem.grid = grid;
    problem.bodies = Bodies::of({{1, 0.1}, {3, 0.4}});
    Rolling rolling;
    rolling.dq = dq;
    problem.motion = rolling;
    problem.friction = FrictionLaw{};
    return problem;
}

Values angles_of(int ny) {
    Values angles;
    for (int row = 0; row < ny; ++row) angles.push_back(0.3 - 0.1 * row + 0.02 * row * row);
    return angles;
}

/// Displacements of the first element's box by each load in turn, rotated with the rotation between both rows.
std::vector<Vector> dense(const IcTable& flat, const Grid& grid, const Values& angles, const std::vector<Vector>& loads,
                          int ahead = 0) {
    std::vector<Vector> u(loads.size());
    for (int to = 0; to < static_cast<int>(u.size()); ++to)
        for (int from = 0; from < static_cast<int>(u.size()); ++from) {
            const int k = to % grid.nx - from % grid.nx + ahead, I = to / grid.nx, J = from / grid.nx;
            const Vector& p = loads[static_cast<std::size_t>(from)];
            const auto along = [&](Axis i) {
                return flat.at(i, x, k, I - J) * p.x + flat.at(i, y, k, I - J) * p.s + flat.at(i, z, k, I - J) * p.z;
            };
            const double turn = angles[static_cast<std::size_t>(I)] - angles[static_cast<std::size_t>(J)];
            Vector& sum = u[static_cast<std::size_t>(to)];
            sum.x += along(x);
            sum.s += std::cos(turn) * along(y) - std::sin(turn) * along(z);
            sum.z += std::sin(turn) * along(y) + std::cos(turn) * along(z);
        }
    return u;
}

IcTable flat_table(const Grid& grid) {
    return pair_of(body_table(grid, {1, 0.1}), body_table(grid, {3, 0.4}));
}

}  // namespace

TEST_CASE("Rotated displacements are those along the loaded row, in the axes of the observed one") {
    const Grid grid = Grid::of_elements(6, 5, 1, 0.7);
    const Values angles = angles_of(grid.ny);
    const std::size_t n = grid.size();
    const ContactInfluence influence = rotated_displacement_influence(rolling_problem(grid, 1), angles);
    const InfluenceOperator& rotated = *influence.current;
    REQUIRE(rotated.size() == n);
    CHECK_FALSE(rotated.is_symmetric());
    const Values px = random_values(n, 1), ps = random_values(n, 2), pz = random_values(n, 3);
    std::vector<Vector> tangential, normal;
    for (std::size_t e = 0; e < n; ++e) {
        tangential.push_back({px[e], ps[e], 0});
        normal.push_back({0, 0, pz[e]});
    }
    const IcTable flat = flat_table(grid);
    const std::vector<Vector> of_tangential = dense(flat, grid, angles, tangential),
                              of_normal = dense(flat, grid, angles, normal);
    Values ux(n), us(n), uz(n), cross_x(n), cross_s(n), cross_z(n);
    rotated.tangential(px, ps, ux, us);
    rotated.normal(pz, uz);
    rotated.tangential_of_normal(pz, cross_x, cross_s);
    rotated.normal_of_tangential(px, ps, cross_z);
    for (std::size_t e = 0; e < n; ++e) {
        CHECK_THAT(ux[e], WithinAbs(of_tangential[e].x, 1e-12));
        CHECK_THAT(us[e], WithinAbs(of_tangential[e].s, 1e-12));
        CHECK_THAT(uz[e], WithinAbs(of_normal[e].z, 1e-12));
        CHECK_THAT(cross_x[e], WithinAbs(of_normal[e].x, 1e-12));
        CHECK_THAT(cross_s[e], WithinAbs(of_normal[e].s, 1e-12));
        CHECK_THAT(cross_z[e], WithinAbs(of_tangential[e].z, 1e-12));
    }
}

TEST_CASE("What a step changes of rotated displacements is their difference to those an element ahead") {
    const Grid grid = Grid::of_elements(5, 4, 1, 0.7);
    const Values angles = angles_of(grid.ny);
    const std::size_t n = grid.size();
    const ContactInfluence influence = rotated_displacement_influence(rolling_problem(grid, 1), angles);
    REQUIRE(influence.increment);
    const Values px = random_values(n, 1), ps = random_values(n, 2), pz = random_values(n, 3);
    std::vector<Vector> all;
    for (std::size_t e = 0; e < n; ++e) all.push_back({px[e], ps[e], pz[e]});
    const IcTable flat = flat_table(Grid::of_elements(grid.nx + 1, grid.ny, 1, 0.7));
    const std::vector<Vector> here = dense(flat, grid, angles, all), ahead = dense(flat, grid, angles, all, 1);
    Values ux(n), us(n), more_x(n), more_s(n);
    influence.increment->tangential(px, ps, ux, us);
    influence.increment->tangential_of_normal(pz, more_x, more_s);
    for (std::size_t e = 0; e < n; ++e) {
        CHECK_THAT(ux[e] + more_x[e], WithinAbs(here[e].x - ahead[e].x, 1e-12));
        CHECK_THAT(us[e] + more_s[e], WithinAbs(here[e].s - ahead[e].s, 1e-12));
    }
}

TEST_CASE("Rotated displacements on a part of the rows are those of the whole") {
    const Grid grid = Grid::of_elements(6, 5, 1, 0.7);
    const ElementBox box{1, 2, 4, 3};
    const ContactInfluence influence = rotated_displacement_influence(rolling_problem(grid, 0.3), angles_of(grid.ny));
    const auto part = influence.current->boxes()->influence(box);
    const auto step = influence.increment->on(box);
    REQUIRE(step);
    const Values pz = random_values(box.size(), 3);
    Values whole(grid.size());
    const auto at = [&](std::size_t e) {
        const std::size_t nx = static_cast<std::size_t>(box.nx);
        return (e / nx + 2) * static_cast<std::size_t>(grid.nx) + e % nx + 1;
    };
    for (std::size_t e = 0; e < pz.size(); ++e) whole[at(e)] = pz[e];
    Values ux(grid.size()), us(grid.size()), uz(grid.size()), x(pz.size()), s(pz.size()), u(pz.size());
    influence.current->normal(whole, uz);
    part->normal(pz, u);
    for (std::size_t e = 0; e < pz.size(); ++e) CHECK_THAT(u[e], WithinAbs(uz[at(e)], 1e-12));
    influence.increment->tangential_of_normal(whole, ux, us);
    step->tangential_of_normal(pz, x, s);
    for (std::size_t e = 0; e < pz.size(); ++e) {
        CHECK_THAT(x[e], WithinAbs(ux[at(e)], 1e-12));
        CHECK_THAT(s[e], WithinAbs(us[at(e)], 1e-12));
    }
}
