// Tests the stated difference between a block's table and loads that are not in its middle, for every element.
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "build/modelling_error.hpp"
#include "build/solid_table.hpp"
#include "contact/random_problems.hpp"
#include "contactd/half_space.hpp"
#include "section/section_cases.hpp"
#include "tensor/block_correction.hpp"

using namespace contactd;
using namespace contactd::fem;
using contactd::test::Dice;

namespace {

constexpr std::array axes{Axis::x, Axis::y, Axis::z};

IcSpec block_spec(int nx, int ny, double dy, double nu, double L_over_h) {
    IcSpec spec;
    spec.source = IcSource::fem;
    spec.body = BodyShape::block;
    spec.accuracy = 1e-2;
    spec.material = {1, nu};
    spec.dx = 1;
    spec.dy = dy;
    spec.nx = nx;
    spec.ny = ny;
    spec.fem.L_over_h = L_over_h;
    return spec;
}

/// Lists blocks, from slim ones that just contain their elements to blocks that are much larger.
IcSpec random_block(Dice& dice) {
    const int nx = dice.integer(1, 24), ny = dice.integer(1, 24);
    const double dy = dice.chance(0.4) ? 1 : dice.log_uniform(0.2, 5);
    const double least = std::max((nx + 1) / 2.0, (ny + 1) / 2.0 * dy) / std::max(1.0, dy);
    IcSpec spec = block_spec(nx, ny, dy, dice.uniform(0, 0.49), least * dice.log_uniform(1.1, 100));
    if (dice.chance(0.2)) spec.load_shape = LoadShape::bilinear;
    return spec;
}

double stated(const IcSpec& spec) {
    Observer observer;
    CollectiveObserver collective(MPI_COMM_SELF, observer);
    return modelling_error(spec, {&collective});
}

std::vector<double> centres(int count, double step) {
    std::vector<double> result;
    for (int i = 0; i < count; ++i) result.push_back((i - (count - 1) / 2.0) * step);
    return result;
}

double half_space(const IcSpec& spec, Axis i, double x, double y) {
    return spec.load_shape == LoadShape::bilinear
               ? half_space_bilinear_coefficient(i, i, x, y, spec.dx, spec.dy, spec.material)
               : half_space_coefficient(i, i, x, y, spec.dx, spec.dy, spec.material);
}

/// Returns the largest error of the table's coefficients, as measured by IcSpec::accuracy, under a load on the element
/// (ix, iy), from its displacements on a finer mesh.
double found(const IcSpec& spec, const BlockCorrection& block, Axis load, int ix, int iy) {
    std::vector<double> xs = centres(spec.nx, spec.dx), ys = centres(spec.ny, spec.dy);
    // A load beside the middle is mirrored to the quarter of positive x and y, and so are the elements.
    const double sign_x = xs[static_cast<std::size_t>(ix)] < 0 ? -1 : 1,
                 sign_y = ys[static_cast<std::size_t>(iy)] < 0 ? -1 : 1;
    for (double& x : xs) x *= sign_x;
    for (double& y : ys) y *= sign_y;
    const LoadPlace place{xs[static_cast<std::size_t>(ix)], ys[static_cast<std::size_t>(iy)]};
    std::vector<double> from_x = xs, from_y = ys;
    for (double& x : from_x) x -= place.x;
    for (double& y : from_y) y -= place.y;
    const auto ignore = [](double, int, double, double) {};
    const auto there = block.solve(load, place, ignore), middle = block.solve(load, {}, ignore);
    double largest = 0;
    for (const Axis i : axes) {
        const Eigen::MatrixXd a = there.at(i, xs, ys), b = middle.at(i, from_x, from_y);
        for (Eigen::Index l = 0; l < a.rows(); ++l)
            for (Eigen::Index k = 0; k < a.cols(); ++k) {
                const double x = from_x[static_cast<std::size_t>(k)], y = from_y[static_cast<std::size_t>(l)];
                double unit = spec.dx * spec.dy / (2 * std::numbers::pi * std::hypot(x, y));
                if (i == load) {
                    const double exact = half_space(spec, i, x, y);
                    unit = std::max(std::abs(exact + b(l, k)), block_error_floor * exact);
                }
                largest = std::max(largest, std::abs(a(l, k) - b(l, k)) / unit);
            }
    }
    return largest;
}

void check_blocks(std::uint64_t first, std::uint64_t count) {
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        Dice dice(seed);
        const IcSpec spec = random_block(dice);
        const BlockCorrection block(spec, {5, 6});
        const double bound = stated(spec);
        CAPTURE(seed, spec.nx, spec.ny, spec.dy, spec.material.nu, spec.fem.L_over_h, bound);
        for (const Axis load : axes) {
            const int ix = dice.integer(0, spec.nx - 1), iy = dice.integer(0, spec.ny - 1);
            CAPTURE(load, ix, iy);
            // It has two digits.
            CHECK(found(spec, block, load, ix, iy) <= 1.03 * bound + 1e-5);
            CHECK(found(spec, block, load, 0, spec.ny - 1) <= 1.03 * bound + 1e-5);
        }
    }
}

}  // namespace

TEST_CASE("the modelling error of a block bounds what loads of all elements do", "[block]") {
    check_blocks(1, 4);
}

// Slow: ten blocks.
TEST_CASE("and that of more blocks", "[block][slow]") {
    check_blocks(5, 14);
}

// Long: 26 blocks.
TEST_CASE("and that of many blocks", "[block][long]") {
    check_blocks(15, 40);
}

TEST_CASE("a block of one element has no modelling error", "[block]") {
    CHECK(stated(block_spec(1, 1, 1, 0.28, 20)) < 1e-9);
}

// Slow: it uses factorisations in three dimensions.
TEST_CASE("a load beside the middle of a block does what finite elements of another make say", "[block][slow]") {
    constexpr double L = 12, nu = 0.28;
    constexpr int ny = 5;
    SolidSpec solid{.solver = Solver::direct, .order = 3};
    solid.density = {.edges_a_strip = 2, .growth = 0.5, .edges_a_body = 6, .corner_share = 0.2};
    solid.slices = {.growth = 1.5, .length = L};
    Observer observer;
    const StripTable table = build_solid_table(MPI_COMM_SELF, slab(L, L, ny), nu, solid, observer).table;
    const IcSpec spec = block_spec(1, ny, 1, nu, L);
    double largest = 0;
    for (const Axis i : axes)
        for (int I = 0; I < ny; ++I)
            for (int J = 0; J < ny; ++J) {
                const int middle = ny / 2, l = I - J;
                if (std::abs(l) > middle) continue;  // the middle strip has no element as far away
                largest = std::max(largest, std::abs(table(i, i, I, J, 0) / table(i, i, middle + l, middle, 0) - 1));
            }
    CHECK(largest <= stated(spec));
    CHECK(largest > 0.1 * stated(spec));
}
