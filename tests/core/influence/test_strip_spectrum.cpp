#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

#include "contactd/finite.hpp"
#include "contactd/half_space.hpp"
#include "contactd/strip_spectrum.hpp"
#include "influence/strips/screened_half_space.hpp"
#include "influence/strips/spectrum_errors.hpp"
#include "influence/strips/wavenumber_rule.hpp"

using namespace contactd;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double nu = 0.28, xi0 = 0.01;
constexpr std::array axes{Axis::x, Axis::y, Axis::z};

/// Creates flat strips whose transform is that of the screened half-space itself.
StripSpectrum flat_spectrum(int strips, int nodes) {
    StripSpectrum spectrum{strips, nu, xi0, wavenumber_nodes(xi0, 6, nodes), {}, {}};
    for (int strip = 0; strip < strips; ++strip) spectrum.frames.push_back({static_cast<double>(strip), 0, 0});
    const double pi = std::numbers::pi;
    for (const double xi : spectrum.nodes)
        for (int a = 0; a < 3 * strips; ++a)
            for (int b = 0; b <= a; ++b) {
                const int l = a / 3 - b / 3, i = a % 3, j = b % 3;
                const KernelIntegrals k = screened_transforms(xi, xi0, l);
                double value = 0;
                if (i == 0 && j == 0) value = (k.xx + (1 - nu) * k.yy) / (2 * pi);
                if (i == 1 && j == 1) value = (k.yy + (1 - nu) * k.xx) / (2 * pi);
                if (i == 2 && j == 2) value = (1 - nu) * (k.xx + k.yy) / (2 * pi);
                if (i + j == 1) value = (i == 0 ? 1 : -1) * nu * k.xy / (2 * pi);
                if (i + j == 2 && i != j) value = (1 - 2 * nu) * k.x / (4 * pi);
                if (i + j == 3) value = (i == 1 ? 1 : -1) * (1 - 2 * nu) * k.y / (4 * pi);
                spectrum.values.push_back(value);
            }
    return spectrum;
}

/// By many small steps.
double integral(const auto& function, double from, double to) {
    constexpr int steps = 200'000;
    double sum = 0;
    for (int i = 0; i < steps; ++i) sum += function(from + (to - from) * (i + 0.5) / steps);
    return sum * (to - from) / steps;
}

}  // namespace

TEST_CASE("Threads that share a table make the same one", "[strips]") {
    const StripSpectrum spectrum = flat_spectrum(5, 9);
    const StripTable alone = strip_table(spectrum, 0.7, 12, 0, 2);
    for (const int threads : {2, 3, 50}) CHECK(strip_table(spectrum, 0.7, 12, 0, 2, threads) == alone);
}

TEST_CASE("A table beyond a double's range is not made, whichever thread meets it", "[strips]") {
    const StripSpectrum spectrum = flat_spectrum(5, 9);
    for (const int threads : {1, 2}) {
        CHECK_NOTHROW(strip_table(spectrum, 0.7, 12, 0, 1e308, threads));
        CHECK_THROWS_AS(strip_table(spectrum, 100, 12, 0, 1.7e308, threads), NotFinite);  // the largest is 1.3 times
    }
}

TEST_CASE("The transform of the screened half-space becomes the screened half-space", "[strips]") {
    const int strips = 4, nx = 12;
    const double dx = 0.7;
    const StripTable table = strip_table(flat_spectrum(strips, 9), dx, nx);
    for (const Axis i : axes)
        for (const Axis j : axes)
            for (int I = 0; I < strips; ++I)
                for (int k = 0; k < nx; ++k) {
                    const KernelIntegrals change = screening(xi0, k * dx, I - 1, dx);
                    double expected = half_space_coefficient(i, j, k * dx, I - 1, dx, 1, {.G = 1, .nu = nu});
                    const double pi = std::numbers::pi;
                    const int row = static_cast<int>(i), strip = static_cast<int>(j);
                    if (row == 2 && strip == 2) expected += (1 - nu) * (change.xx + change.yy) / (2 * pi);
                    if (row == 0 && strip == 0) expected += (change.xx + (1 - nu) * change.yy) / (2 * pi);
                    if (row == 1 && strip == 1) expected += (change.yy + (1 - nu) * change.xx) / (2 * pi);
                    if (row + strip == 1) expected += nu * change.xy / (2 * pi);
                    if (row + strip == 2 && row != strip)
                        expected += (row == 0 ? 1 : -1) * (1 - 2 * nu) * change.x / (4 * pi);
                    if (row + strip == 3) expected += (row == 1 ? 1 : -1) * (1 - 2 * nu) * change.y / (4 * pi);
                    CAPTURE(row, strip, I, k);
                    CHECK_THAT(table(i, j, I, 1, k), WithinAbs(expected, 1e-12));
                }
}

TEST_CASE("Screened kernels in space are the transforms of those in wavenumbers", "[strips]") {
    // Far from the singularity an element is nearly a point, so cosine and sine integrals over the strip's transform
    // apply.
    const double x = 3.5, dx = 1e-3, last = 40;
    const int l = 2;
    const KernelIntegrals change = screening(xi0, x, l, dx);
    const double plain =
        half_space_coefficient(Axis::z, Axis::z, x, l, dx, 1, {.G = 1, .nu = 0}) * 2 * std::numbers::pi;  // xx + yy
    const double back = integral(
        [&](double xi) {
            const KernelIntegrals k = screened_transforms(xi, xi0, l);
            return (k.xx + k.yy) * std::cos(xi * x);
        },
        0, last / 10);
    CHECK_THAT(back * dx / std::numbers::pi, WithinRel(plain + change.xx + change.yy, 2e-3));
}

TEST_CASE("Weights of wavenumbers integrate what is even and what is odd", "[strips]") {
    const double dx = 0.5, last = 6, shift = 0.2;
    const auto nodes = wavenumber_nodes(0.05, last, 65);
    const WavenumberRule rule = wavenumber_rule(nodes, 0.05, dx, 5, shift);
    for (int k = 0; k < 5; ++k) {
        double even = 0, odd = 0;
        for (std::size_t node = 0; node < nodes.size(); ++node) {
            const double xi = nodes[node];
            even += rule.even[node * 5 + static_cast<std::size_t>(k)] * std::exp(-xi * xi);
            odd += rule.odd[node * 5 + static_cast<std::size_t>(k)] * xi * std::exp(-xi * xi);
        }
        const double x = k * dx + shift;
        const auto element = [&](double xi) { return 2 * std::sin(xi * dx / 2) / xi / std::numbers::pi; };
        CHECK_THAT(
            even,
            WithinAbs(integral([&](double xi) { return std::exp(-xi * xi) * element(xi) * std::cos(xi * x); }, 0, 20),
                      2e-6));
        CHECK_THAT(
            odd, WithinAbs(integral([&](double xi) { return xi * std::exp(-xi * xi) * element(xi) * std::sin(xi * x); },
                                    0, 20),
                           5e-6));
    }
}

TEST_CASE("A shift by a whole element is the next offset, and one back the parity's", "[strips]") {
    const StripSpectrum spectrum = flat_spectrum(3, 9);
    const StripTable table = strip_table(spectrum, 1, 6), ahead = strip_table(spectrum, 1, 5, 1),
                     back = strip_table(spectrum, 1, 5, -1);
    for (const Axis i : axes)
        for (const Axis j : axes) {
            CHECK_THAT(ahead(i, j, 2, 0, 3), WithinAbs(table(i, j, 2, 0, 4), 1e-10));
            CHECK_THAT(back(i, j, 2, 0, 0), WithinAbs(table.at(i, j, 2, 0, -1), 1e-10));
        }
}

TEST_CASE("A spectrum that is the reference has neither nested changes nor an end", "[strips]") {
    const StripSpectrum spectrum = flat_spectrum(3, 9);
    CHECK(nested_change(spectrum, 1, 10) < 1e-12);
    CHECK(beyond_the_end(spectrum, 0.5) < 1e-12);
}
