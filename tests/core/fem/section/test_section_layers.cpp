// Compares a slab by finite elements with the exact coefficients of a bonded layer.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>
#include <optional>

#include "contactd/error.hpp"
#include "contactd/half_space.hpp"
#include "influence/layered/layered_table.hpp"
#include "section/spectrum/spectrum_build.hpp"
#include "section_cases.hpp"

using namespace contactd;
using namespace contactd::fem;

namespace {

constexpr int strips = 8, offsets = 12;

/// Returns the largest difference between coefficients of elements `dx` long and those of the layer, over the smaller
/// of zz of the half-space and of the layer under such an element.
double difference_to_layer(const StripSpectrum& spectrum, double thickness, double nu, double dx) {
    const Layers layer{{{thickness, 1, nu}}, Material::rigid()};
    const StripTable slab = strip_table(spectrum, dx, offsets),
                     exact = strip_table_of(layered_table(layer, LoadShape::constant, offsets, strips, dx, 1));
    double largest = 0;
    REQUIRE(slab.values.size() == exact.values.size());
    for (std::size_t i = 0; i < slab.values.size(); ++i)
        largest = std::max(largest, std::abs(slab.values[i] - exact.values[i]));
    const double half_space = half_space_coefficient(Axis::z, Axis::z, 0, 0, dx, 1, {.G = 1, .nu = nu});
    return largest / std::min(half_space, exact(Axis::z, Axis::z, 0, 0, 0));
}

/// An accuracy below 5e-4 is reached or refused.
std::optional<SpectrumBuild> build_unless_refused(const SectionOutline& outline, double nu, double accuracy) {
    Observer observer;
    try {
        return build_spectrum(MPI_COMM_SELF, outline, nu, accuracy, observer);
    } catch (const NotConverged&) {
        if (accuracy >= 5e-4) throw;
        return {};
    }
}

void check_slabs(double accuracy) {
    const double nu = GENERATE(0.28, 0.40, 0.49, 0.499), thickness = GENERATE(1.0, 5.0);
    const auto found = build_unless_refused(slab(100, thickness, strips), nu, accuracy);
    if (!found) return;
    const SpectrumBuild& build = *found;
    CAPTURE(accuracy, nu, thickness, build.order, build.errors.mesh, build.errors.wavenumbers, build.errors.end);
    CHECK(build.errors.total() <= accuracy);
    for (const double dx : {0.5, 0.6, 1.0, 2.0, 8.0}) {
        CAPTURE(dx);
        CHECK(difference_to_layer(build.spectrum, thickness, nu, dx) <= build.errors.total());
    }
    // Elements of order 4 and higher do not lock; near incompressibility they need at most one order more.
    if (accuracy == 1e-3) CHECK(build.order <= (nu > 0.49 ? 6 : 5));
}

}  // namespace

TEST_CASE("Slabs of any Poisson's ratio up to 0.499 are exact layers within their stated error", "[section]") {
    check_slabs(1e-2);
}

// Slow: it uses fine meshes of thin slabs at all wavenumbers.
TEST_CASE("A slab that is thin beside its strips errs by no more of its own compliance", "[section][slow]") {
    const double thickness = GENERATE(0.05, 0.2), nu = 0.28;
    Observer observer;
    const SpectrumBuild build = build_spectrum(MPI_COMM_SELF, slab(100, thickness, strips), nu, 1e-2, observer);
    CHECK(build.errors.total() <= 1e-2);
    for (const double dx : {0.5, 1.0, 8.0})
        CHECK(difference_to_layer(build.spectrum, thickness, nu, dx) <= build.errors.total());
}

// Slow: it uses fine meshes at all wavenumbers.
TEST_CASE("So are slabs to a thousandth", "[section][slow]") {
    check_slabs(1e-3);
}

// Long: finer ones.
TEST_CASE("So are slabs to a ten-thousandth", "[section][long]") {
    check_slabs(1e-4);
}
