// Compares a few strips of a block with an edge in three dimensions with the transform along x:
//
//     section_solid [--order 2] [--factor 0] [--columns 3] [--offsets 9] [--edges 2] [--growth 1.5] [--length 300]
//                   [--many 80]
//
// It prints one JSON object for `./dev paper sections`: the difference and the cost of both, also for `many` strips.
// Lengths are relative to the width of a strip. seconds and transform_seconds are processor time, those of single
// stages wall-clock time.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <string>

#include "build/solid_table.hpp"
#include "contactd/fem/ic_builder.hpp"
#include "contactd/half_space.hpp"
#include "geometry/section/section_geometry.hpp"
#include "section/section_outline.hpp"
#include "section/spectrum/spectrum_build.hpp"

namespace {

using namespace contactd;
using namespace contactd::fem;

constexpr double nu = 0.28, accuracy = 1e-3, reference_accuracy = 1e-4;

SectionOutline edge_block(int columns) {
    const Section section{EdgeBlock{.width = 200, .height = 100, .edge_distance = 0.5}};
    return outline_of(geometry::SectionGeometry(section, columns, 1, "section"));
}

double processor_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Returns the largest difference over zz of the half-space under an element.
double largest_difference(const StripTable& one, const StripTable& other) {
    double largest = 0;
    for (std::size_t i = 0; i < one.values.size(); ++i)
        largest = std::max(largest, std::abs(one.values[i] - other.values[i]));
    return largest / half_space_coefficient(Axis::z, Axis::z, 0, 0, 1, 1, {.G = 1, .nu = nu});
}

struct Transform {
    SpectrumBuild build;
    double seconds = 0;
};
Transform transform(int columns, double to) {
    Observer observer;
    const double start = processor_seconds();
    Transform result{build_spectrum(MPI_COMM_SELF, edge_block(columns), nu, to, observer)};
    result.seconds = processor_seconds() - start;
    return result;
}

}  // namespace

int main(int argc, char** argv) {
    const Runtime runtime(argc, argv);
    std::map<std::string, double> options{{"--order", 2}, {"--factor", 0},   {"--columns", 3},  {"--offsets", 9},
                                          {"--edges", 2}, {"--growth", 1.5}, {"--length", 300}, {"--many", 80}};
    for (int i = 1; i + 1 < argc; i += 2) {
        const auto option = options.find(argv[i]);
        if (option == options.end()) {
            std::fprintf(stderr, "section_solid: '%s' is not an option\n", argv[i]);
            return 2;
        }
        option->second = std::atof(argv[i + 1]);
    }
    const auto whole = [&](const char* name) { return static_cast<int>(options.at(name)); };
    SolidSpec spec{.order = whole("--order"), .nx = whole("--offsets")};
    if (whole("--factor") != 0) spec.solver = Solver::direct;  // otherwise BoomerAMG and conjugate gradients
    spec.density.edges_a_strip = whole("--edges");
    spec.density.growth = options.at("--growth") - 1;
    spec.density.corner_share = 0.1;
    spec.slices = {options.at("--growth"), options.at("--length")};
    const int columns = whole("--columns"), many = whole("--many");
    Observer observer;
    const double start = processor_seconds();
    const SolidTable solid = build_solid_table(MPI_COMM_SELF, edge_block(columns), nu, spec, observer);
    const double solid_seconds = processor_seconds() - start;
    const SpectrumBuild exact = transform(columns, reference_accuracy).build;
    const StripTable table = strip_table(exact.spectrum, 1, spec.nx);
    const Transform of_many = transform(many, accuracy);
    std::printf(
        "{\"found\": %.4e, \"stated\": %.4e, \"elements\": %lld, \"dofs\": %lld, \"loads\": %d, "
        "\"iterations\": %d, \"seconds\": %.4g, \"assembly_seconds\": %.4g, \"setup_seconds\": %.4g, "
        "\"solve_seconds\": %.4g, \"many_dofs\": %lld, \"many_loads\": %d, \"transform_seconds\": %.4g, "
        "\"transform_error\": %.4e}\n",
        largest_difference(solid.table, table), exact.errors.total(), solid.elements, solid.dofs, solid.loads,
        solid.iterations, solid_seconds, solid.assembly_seconds, solid.setup_seconds, solid.solve_seconds,
        solid_dofs(edge_block(many), spec), 3 * many, of_many.seconds, of_many.build.errors.total());
    return 0;
}
