// Tests layered bodies: their compliance under waves, their coefficients, and limits.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/generators/catch_generators_range.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "contactd/half_space.hpp"
#include "influence/layered/layered_table.hpp"
#include "influence/layered/wave_compliance.hpp"
#include "layers_reference.hpp"

using namespace contactd;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using enum Axis;

namespace {

// Returns the scale of errors; A_zz(0,0) itself is tiny of a thin incompressible layer on a rigid base.
double error_scale(const Layers& body, const IcTable& table) {
    const Layer& top = body.layers.front();
    return std::max(table(z, z, 0, 0), 1e-3 * top.thickness / top.G);
}

double largest_difference(const IcTable& one, const IcTable& other) {
    double largest = 0;
    for (std::size_t i = 0; i < one.values.size(); ++i)
        largest = std::max(largest, std::abs(one.values[i] - other.values[i]));
    return largest;
}

IcTable half_space(const Material& material, LoadShape load_shape, int nx, int ny, double dx, double dy) {
    IcSpec spec;
    spec.material = material;
    spec.load_shape = load_shape;
    spec.nx = nx;
    spec.ny = ny;
    spec.dx = dx;
    spec.dy = dy;
    return half_space_table(spec);
}

// Lists offsets of both signs.
double sum_over_plane(const IcTable& table, Axis i) {
    double sum = 0;
    for (int l = 0; l < table.ny; ++l)
        for (int k = 0; k < table.nx; ++k) sum += (k == 0 ? 1 : 2) * (l == 0 ? 1 : 2) * table(i, i, k, l);
    return sum;
}

}  // namespace

TEST_CASE("the compliance of layers under waves is that of the reference values") {
    for (const auto& reference : reference_layers::cases()) {
        INFO(reference.name);
        const LayeredWaves waves(reference.body);
        for (const auto& [k, a, b, c, d] : reference.waves) {
            const WaveCompliance found = waves.at(k);
            CHECK_THAT(found.a, WithinRel(a, 2e-12));
            CHECK_THAT(found.b, WithinAbs(b, 2e-12 * a));
            CHECK_THAT(found.c, WithinRel(c, 2e-12));
            CHECK_THAT(found.d, WithinRel(d, 2e-12));
        }
    }
}

TEST_CASE("coefficients of layers are the reference values") {
    for (const auto& reference : reference_layers::cases()) {
        INFO(reference.name);
        const IcTable table = layered_table(reference.body, LoadShape::constant, 25, 18, reference.dx, reference.dy);
        const double allowed = 1e-10 * error_scale(reference.body, table);
        for (const auto& [k, l, xx, xy, xz, yy, yz, zz] : reference.offsets) {
            INFO("offset " << k << ", " << l);
            const auto check = [&](Axis i, Axis j, double expected) {
                CHECK_THAT(table.at(i, j, k, l), WithinAbs(expected, allowed));
            };
            check(x, x, xx);
            check(y, y, yy);
            check(z, z, zz);
            check(x, y, xy);
            check(y, x, xy);
            check(x, z, xz);
            check(z, x, -xz);
            check(y, z, yz);
            check(z, y, -yz);
        }
    }
}

TEST_CASE("layers of the base's own material are the half-space") {
    const Material material{82000, GENERATE(0.0, 0.28, 0.5)};
    const auto shape = GENERATE(LoadShape::constant, LoadShape::bilinear);
    const double dy = GENERATE(0.5, 0.17, 3.0);
    const double thickness = GENERATE(0.01, 0.7, 30.0);
    const Layers body{{{thickness, material.G, material.nu}, {2 * thickness, material.G, material.nu}}, material};
    const IcTable layered = layered_table(body, shape, 40, 30, 0.5, dy);
    const IcTable exact = half_space(material, shape, 40, 30, 0.5, dy);
    CHECK(largest_difference(layered, exact) < 1e-10 * exact(z, z, 0, 0));
}

TEST_CASE("coefficients on a rigid base add up to the layers' uniform compression and shear") {
    const Layers body = GENERATE(Layers{{{1, 1, 0.3}}, Material::rigid()}, Layers{{{0.6, 2, 0.5}}, Material::rigid()},
                                 Layers{{{0.3, 3, 0.2}, {0.5, 0.5, 0.5}}, Material::rigid()});
    const auto shape = GENERATE(LoadShape::constant, LoadShape::bilinear);
    const IcTable table = layered_table(body, shape, 75, 48, 0.8, 1.25);
    double compression = 0, shear = 0;
    for (const Layer& layer : body.layers) {
        compression += layer.thickness * (1 - 2 * layer.nu) / (2 * layer.G * (1 - layer.nu));
        shear += layer.thickness / layer.G;
    }
    const double allowed = 1e-10 * error_scale(body, table);
    CHECK_THAT(sum_over_plane(table, z), WithinAbs(compression, 10 * allowed));
    CHECK_THAT(sum_over_plane(table, x), WithinAbs(shear, 10 * allowed));
    CHECK_THAT(sum_over_plane(table, y), WithinAbs(shear, 10 * allowed));
}

TEST_CASE("a thin layer on a rigid base is a Winkler foundation") {
    // The deviation decreases exponentially with dx/(2h); it was measured with two other methods, see reference_layers.
    const auto [thickness, deviation] =
        GENERATE(std::pair{0.2, 1.5e-2}, std::pair{0.1, 1.5e-3}, std::pair{0.05, 1.6e-5}, std::pair{0.02, 2e-11});
    const auto shape = GENERATE(LoadShape::constant, LoadShape::bilinear);
    const Layers body{{{thickness, 2, 0.3}}, Material::rigid()};
    const IcTable table = layered_table(body, shape, 3, 3, 1, 1);
    const double winkler = thickness * 0.4 / (2 * 2 * 0.7), shear = thickness / 2;
    if (shape == LoadShape::constant) {
        CHECK_THAT(table(z, z, 0, 0), WithinRel(winkler, deviation));
        CHECK_THAT(table(x, x, 0, 0), WithinRel(shear, 8 * deviation));
        CHECK_THAT(table(z, z, 1, 0), WithinAbs(0, deviation * winkler));
    } else {
        // The kink of the hat function is smoothed over the thickness.
        CHECK_THAT(table(z, z, 0, 0), WithinRel(winkler, 2 * thickness));
        CHECK(table(z, z, 0, 0) < winkler);
    }
}

TEST_CASE("a thin incompressible layer on a rigid base yields where the pressure curves") {
    // By lubrication theory, w = -h^3/(3G) times the Laplacian of the pressure, exact for long waves.
    const double thickness = GENERATE(0.02, 0.05);
    const LayeredWaves waves({{{thickness, 3, 0.5}}, Material::rigid()});
    const double k = 0.05;
    CHECK_THAT(waves.at(k).c, WithinRel(k * std::pow(k * thickness, 2) * thickness / 3, 2 * k * thickness));
    const IcTable table = layered_table({{{thickness, 3, 0.5}}, Material::rigid()}, LoadShape::bilinear, 6, 6, 1, 1);
    // The second derivative of a hat function is -2/dx at its apex and 1/dx at its feet, smoothed over the thickness:
    // the load displaces the layer sideways.
    CHECK(table(z, z, 0, 0) > 0);
    CHECK(table(z, z, 1, 0) < 0);
    CHECK_THAT(sum_over_plane(table, z), WithinAbs(0, 1e-10 * thickness));
}

TEST_CASE("small elements add up to large ones") {
    const Layers body = GENERATE(Layers{{{0.02, 1, 0.3}}, Material::rigid()}, Layers{{{0.1, 1, 0.49}}, {40, 0.28}},
                                 Layers{{{2, 100, 0.25}, {0.5, 0.3, 0.5}}, {1, 0.45}});
    const double dy = GENERATE(1.0, 0.1, 6.0);
    constexpr int times = 3;
    const IcTable large = layered_table(body, LoadShape::constant, 3, 3, times * 1.0, times * dy);
    const IcTable small = layered_table(body, LoadShape::constant, 8, 8, 1.0, dy);
    double difference = 0;
    for (const Axis i : {x, y, z})
        for (const Axis j : {x, y, z})
            for (int l = 0; l < 3; ++l)
                for (int k = 0; k < 3; ++k) {
                    double sum = 0;
                    for (int n = -1; n <= 1; ++n)
                        for (int m = -1; m <= 1; ++m) sum += small.at(i, j, times * k + m, times * l + n);
                    difference = std::max(difference, std::abs(sum - large(i, j, k, l)));
                }
    CHECK(difference < 1e-10 * error_scale(body, large));
}

TEST_CASE("small hat functions add up to large ones") {
    const Layers body = GENERATE(Layers{{{0.02, 1, 0.3}}, Material::rigid()}, Layers{{{0.1, 1, 0.49}}, {40, 0.28}},
                                 Layers{{{2, 100, 0.25}, {0.5, 0.3, 0.5}}, {1, 0.45}});
    const double dy = GENERATE(1.0, 0.1, 6.0);
    const IcTable large = layered_table(body, LoadShape::bilinear, 3, 3, 2.0, 2 * dy);
    const IcTable small = layered_table(body, LoadShape::bilinear, 6, 6, 1.0, dy);
    double difference = 0;
    for (const Axis i : {x, y, z})
        for (const Axis j : {x, y, z})
            for (int l = 0; l < 3; ++l)
                for (int k = 0; k < 3; ++k) {
                    double sum = 0;
                    for (int n = -1; n <= 1; ++n)
                        for (int m = -1; m <= 1; ++m)
                            sum += (m == 0 ? 1 : 0.5) * (n == 0 ? 1 : 0.5) * small.at(i, j, 2 * k + m, 2 * l + n);
                    difference = std::max(difference, std::abs(sum - large(i, j, k, l)));
                }
    CHECK(difference < 1e-10 * error_scale(body, large));
}

TEST_CASE("a hat function is the mean of constant loads around it") {
    // For elements a third as large, the mean over 3 x 3 of them equals the mean over an element, except for variations
    // in between.
    const Layers body = GENERATE(Layers{{{1, 1, 0.3}}, Material::rigid()}, Layers{{{0.4, 5, 0.5}}, {1, 0.3}});
    const IcTable hats = layered_table(body, LoadShape::bilinear, 6, 6, 1, 1);
    constexpr int parts = 9;
    const IcTable small = layered_table(body, LoadShape::constant, 6 * parts, 6 * parts, 1.0 / parts, 1.0 / parts);
    for (const auto& [k, l] : {std::pair{3, 2}, std::pair{0, 4}, std::pair{5, 5}})
        for (const Axis i : {x, y, z})
            for (const Axis j : {x, y, z}) {
                double sum = 0;
                for (int n = 1 - parts; n < parts; ++n)
                    for (int m = 1 - parts; m < parts; ++m)
                        sum += (parts - std::abs(m)) * (parts - std::abs(n)) *
                               small.at(i, j, parts * k + m, parts * l + n);
                sum /= parts * parts;
                CHECK_THAT(sum, WithinAbs(hats(i, j, k, l), 2e-4 * hats(x, x, 0, 0)));
            }
}

TEST_CASE("the error that is stated of a table of layers is no less than the one it has") {
    const auto shape = GENERATE(LoadShape::constant, LoadShape::bilinear);
    const auto& reference = GENERATE(from_range(reference_layers::cases()));
    INFO(reference.name);
    const IcTable table = layered_table(reference.body, shape, 25, 18, reference.dx, reference.dy);
    const IcErrors errors = layered_errors(reference.body, shape, table, reference.dx, reference.dy);
    CHECK(errors.zz->largest < 1e-9);
    CHECK(errors.xx->largest < 1e-9);
    CHECK(errors.yy->largest < 1e-9);
    CHECK(errors.zz->largest > 0);
    if (shape == LoadShape::bilinear) return;
    const double rounding = 2e-12;  // rounding of the printed values
    for (const auto& offset : reference.offsets)
        CHECK(std::abs(table.at(z, z, offset.k, offset.l) - offset.zz) <
              (errors.zz->largest + rounding) * error_scale(reference.body, table));
}

TEST_CASE("a table of layers is not finished when its request is abandoned") {
    struct Impatient final : Observer {
        mutable int asked = 0;
        bool cancelled() const override { return ++asked > 5; }
    } observer;
    const auto shape = GENERATE(LoadShape::constant, LoadShape::bilinear);
    CHECK_THROWS_AS(layered_table({{{1, 1, 0.3}}, Material::rigid()}, shape, 30, 30, 1, 1, observer), Cancelled);
    CHECK(observer.asked == 6);
}
