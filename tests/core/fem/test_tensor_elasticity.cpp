// Tests elasticity in the modes of a block's axes, and its applications.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>

#include "fem_specs.hpp"
#include "tensor/block_correction.hpp"

using namespace contactd;
using namespace contactd::fem;

namespace {

constexpr double L = 3;
using Displacement = std::array<double, 3> (*)(double x, double y, double z, double nu);

/// Stretches along x and y, without stress along z.
std::array<double, 3> stretched(double x, double y, double z, double nu) {
    return {0.3 * x, -0.2 * y, -nu / (1 - nu) * 0.1 * z};
}

std::array<double, 3> shifted(double, double, double, double) {
    return {1, 0, 0};
}

PerAxis<TensorField> at_far_nodes(const PerAxis<AxisElements>& axes, Displacement u, double nu) {
    PerAxis<TensorField> result;
    const TensorSize n{axes[0].nodes(), axes[1].nodes(), axes[2].nodes()};
    for (TensorField& field : result) field = {n, Eigen::VectorXd::Zero(count_of(n))};
    for (Eigen::Index c = 0; c < n[2]; ++c)
        for (Eigen::Index b = 0; b < n[1]; ++b)
            for (Eigen::Index a = 0; a < n[0]; ++a) {
                if (a < n[0] - 1 && b < n[1] - 1 && c > 0) continue;
                const auto value = u(axes[0].positions()[a], axes[1].positions()[b], axes[2].positions()[c], nu);
                for (std::size_t i = 0; i < 3; ++i) result[i].values[(c * n[1] + b) * n[0] + a] = value[i];
            }
    return result;
}

IcSpec block_spec(double nu, double L_over_h) {
    IcSpec spec = coarse_spec(4, 4, 1, 1);
    spec.material = {1, nu};
    spec.body = BodyShape::block;
    spec.fem = FemSpec{};
    spec.fem.L_over_h = L_over_h;
    return spec;
}

void ignore(double, int, double, double) {}

}  // namespace

TEST_CASE("Displacements that are linear are reproduced, whatever the planes", "[fem][tensor]") {
    const double nu = GENERATE(0.0, 0.28, 0.49);
    const bool shift = GENERATE(false, true);
    CAPTURE(nu, shift);
    const Displacement u = shift ? shifted : stretched;
    const PerAxis<AxisElements> axes{AxisElements({0, 0.4, 2.5, L}, 2), AxisElements({0, 1.7, L}, 3),
                                     AxisElements({-L, -2, -0.1, 0}, 2)};
    const TensorElasticity system(axes, {1, nu}, {.x_is_odd = !shift, .y_is_odd = true});
    Eigen::VectorXd w;
    const auto silent = [](int, double, double) {};
    const SolveResult result = system.solve(-system.forces_of(at_far_nodes(axes, u, nu)), w, 1e-12, 1000, silent);
    REQUIRE(result.converged);
    // Excludes the last intervals, where prescribed values matter.
    for (const Axis i : {Axis::x, Axis::y, Axis::z}) {
        const auto value = u(0.9, 1.1, 0, nu)[static_cast<std::size_t>(i)];
        CHECK(std::abs(system.on_surface(w, i, {0.9}, {1.1})(0, 0) - value) < 1e-9);
    }
}

TEST_CASE("Displacements at one position by a load at another are reciprocal", "[fem][tensor]") {
    const BlockCorrection correction(block_spec(0.3, 20), {4, 5});
    const LoadPlace here{6, 2}, there{1, 5};
    const auto at = [&](Axis i, Axis j, const LoadPlace& load, const LoadPlace& seen) {
        return correction.solve(j, load, ignore).at(i, {seen.x}, {seen.y})(0, 0);
    };
    const double unit = std::abs(at(Axis::z, Axis::z, here, there));
    for (const auto& [i, j] : {std::pair{Axis::z, Axis::z}, {Axis::x, Axis::z}, {Axis::x, Axis::y}, {Axis::y, Axis::y}})
        CHECK(std::abs(at(i, j, here, there) - at(j, i, there, here)) < 1e-2 * unit);
}

TEST_CASE("A load beside the middle has its mirror images", "[fem][tensor]") {
    const BlockCorrection correction(block_spec(0.3, 12), {3, 4});
    const auto along_x = correction.solve(Axis::x, {3, 1}, ignore), along_y = correction.solve(Axis::y, {1, 3}, ignore);
    CHECK(std::abs(along_x.at(Axis::x, {-4}, {2})(0, 0) - along_y.at(Axis::y, {2}, {-4})(0, 0)) < 1e-9);
    CHECK(std::abs(along_x.at(Axis::z, {-4}, {2})(0, 0) - along_y.at(Axis::z, {2}, {-4})(0, 0)) < 1e-9);
}
