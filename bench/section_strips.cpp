// Computes plane-strain displacements of a cross-section's strips under normal tractions on these strips, on a given
// mesh:
//
//     section_strips --shape disc|plate_hole|slab [--radius 57.3] [--strips 168] [--edges 4] [--order 2]
//
// It prints one JSON object for `./dev paper sections`: normal displacements at the centre of each strip, lower half
// row by row, for G = 1 and nu = 0.28. Lengths are relative to the width of a strip. A slab is as deep as a plate is
// wide, fifty radii.
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

#include "contactd/error.hpp"
#include "contactd/fem/ic_builder.hpp"
#include "geometry/section/section_geometry.hpp"
#include "section/section_outline.hpp"
#include "section/spectrum/section_model.hpp"
#include "section/spectrum/spectrum_build.hpp"

namespace {

using namespace contactd;
using namespace contactd::fem;
using Options = std::map<std::string, std::string>;

constexpr double nu = 0.28, core = 0.005, outside = 50;  // relative to the radius

Section section_of(const std::string& shape, double radius) {
    if (shape == "disc") return {Disc{.radius = radius, .core = core * radius}};
    if (shape == "plate_hole") return {PlateHole{.radius = radius, .plate_radius = outside * radius}};
    if (shape == "slab") return {Slab{.thickness = outside * radius, .width = 2 * outside * radius}};
    throw InvalidArgument("--shape", "is '" + shape + "'; it must be disc, plate_hole or slab");
}

int run(const Options& options) {
    const auto number = [&](const char* name) { return std::atof(options.at(name).c_str()); };
    const int strips = static_cast<int>(number("--strips")), order = static_cast<int>(number("--order"));
    const Section section = section_of(options.at("--shape"), number("--radius"));
    const SectionOutline outline = outline_of(geometry::SectionGeometry(section, strips, 1, "section"));
    MeshDensity density;
    density.edges_a_strip = static_cast<int>(number("--edges"));
    const DividedOutline divided = divide(outline, density);
    const SectionMesh mesh = make_section_mesh(outline, divided, triangulate(divided, density), order);
    SectionModel model(outline, mesh, order, nu);
    const std::vector<double> values = model.at(0).values;
    std::printf("{\"unknowns\": %lld, \"angles\": [", model.unknowns());
    const char* comma = "";
    for (const StripFrame& frame : strip_frames(outline)) {
        std::printf("%s%.12g", comma, frame.angle);
        comma = ", ";
    }
    std::printf("], \"normal\": [");
    comma = "";
    for (int a = 0; a < strips; ++a)
        for (int b = 0; b <= a; ++b) {
            const std::size_t row = 3 * static_cast<std::size_t>(a) + 2, column = 3 * static_cast<std::size_t>(b) + 2;
            std::printf("%s%.12g", comma, values[row * (row + 1) / 2 + column]);
            comma = ", ";
        }
    std::printf("]}\n");
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    const Runtime runtime(argc, argv);
    Options options{{"--shape", "disc"}, {"--radius", "57.3"}, {"--strips", "168"}, {"--edges", "4"}, {"--order", "2"}};
    for (int i = 1; i < argc; i += 2) {
        const auto option = options.find(argv[i]);
        if (option == options.end() || i + 1 == argc) {
            std::fprintf(stderr, "section_strips: '%s' is not an option, or lacks its value\n", argv[i]);
            return 2;
        }
        option->second = argv[i + 1];
    }
    try {
        return run(options);
    } catch (const Error& error) {
        std::fprintf(stderr, "section_strips: %s\n", error.what());
        return 1;
    }
}
