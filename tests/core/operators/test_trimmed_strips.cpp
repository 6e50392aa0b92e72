#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>
#include <numeric>

#include "contact/contact_cases.hpp"
#include "operators/convolution.hpp"
#include "operators/strips/strip_operator.hpp"

using namespace contactd;
using namespace contactd::test;

namespace {

using enum Axis;

/// Creates an operator of a flat surface, with elements as long as the grid, and the change that products may have.
struct Trimmed {
    StripTable table;
    std::shared_ptr<const StripParts> parts;
    StripOperator influence;

    Trimmed(int nx, int strips, double left_out)
        : table(strip_table_of(half_space_pair(Grid::of_elements(nx + 1, strips, 1, 0.7), {1, 0.3}))),
          parts(std::make_shared<const StripParts>(table, nx, OffsetParity::natural, left_out)),
          influence(parts, parts->extent(),
                    std::make_shared<const ConvolutionOperator>(
                        half_space_pair(Grid::of_elements(nx, strips, 1, 0.7), {1, 0.3}), nx, strips)) {}
};

double product(const Values& a, const Values& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

}  // namespace

TEST_CASE("no coefficient of a strip operator changes by more than it may", "[strips]") {
    const int nx = GENERATE(2, 9, 40), strips = GENERATE(1, 12);
    const double left_out = GENERATE(1e-4, 1e-6, 1e-9);
    CAPTURE(nx, strips, left_out);
    const Trimmed trimmed(nx, strips, left_out);
    const InfluenceOperator& influence = trimmed.influence;
    const std::size_t n = influence.size();
    const int J = strips / 2;
    Values load(n), none(n), u(n), v(n), w(n);
    load[static_cast<std::size_t>(J * nx)] = 1;
    const auto error = [&](const Values& computed, Axis i, Axis j) {
        constexpr double rounding = 1e-15;
        double most = 0;
        for (int I = 0; I < strips; ++I)
            for (int k = 0; k < nx; ++k)
                most = std::max(
                    most, std::abs(computed[static_cast<std::size_t>(I * nx + k)] - trimmed.table.at(i, j, I, J, k)));
        return std::max(0.0, most - rounding);
    };
    influence.normal(load, u);
    CHECK(error(u, z, z) <= left_out);
    influence.tangential(load, none, u, v);
    CHECK(error(u, x, x) <= left_out);
    CHECK(error(v, y, x) <= left_out);
    influence.tangential(none, load, u, v);
    CHECK(error(u, x, y) <= left_out);
    CHECK(error(v, y, y) <= left_out);
    influence.tangential_of_normal(load, u, v);
    CHECK(error(u, x, z) <= left_out);
    CHECK(error(v, y, z) <= left_out);
    influence.normal_of_tangential(load, none, w);
    CHECK(error(w, z, x) <= left_out);
    influence.normal_of_tangential(none, load, w);
    CHECK(error(w, z, y) <= left_out);
}

TEST_CASE("a strip operator that leaves something out is symmetric and positive", "[strips]") {
    const Trimmed trimmed(30, 17, 1e-4);
    const InfluenceOperator& influence = trimmed.influence;
    const std::size_t n = influence.size();
    const Values px = random_values(n, 1), py = random_values(n, 2), qx = random_values(n, 3), qy = random_values(n, 4);
    Values ux(n), uy(n), vx(n), vy(n);
    influence.tangential(px, py, ux, uy);
    influence.tangential(qx, qy, vx, vy);
    const double forth = product(qx, ux) + product(qy, uy), back = product(px, vx) + product(py, vy);
    const double energy = product(px, ux) + product(py, uy);
    CHECK(energy > 0);
    CHECK(std::abs(forth - back) < 1e-13 * energy);
}
