#include "triangulation.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "contactd/error.hpp"
#include "mesher.hpp"

namespace contactd::fem {
namespace {

namespace fs = std::filesystem;

/// The module lies beside the program where it was built, and in the folder of libraries where it is installed.
fs::path module_file() {
    constexpr const char* name = "contactd-gmsh.so";
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error).parent_path(),
                   installed = (program / CONTACTD_MODULES / name).lexically_normal();
    for (const fs::path& file : {program / name, installed})
        if (fs::exists(file, error)) return file;
    throw Error(
        "The module " + installed.string() +
        ", which meshes sections, is missing. Install contactd completely, or put the module beside the program.");
}

/// Stays open until the program ends, because gmsh does not support unloading.
FillOutline* open_module() {
    const fs::path file = module_file();
    void* module = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    void* function = module == nullptr ? nullptr : ::dlsym(module, "contactd_fill_outline");
    if (function == nullptr) {
        const char* problem = ::dlerror();
        throw Error("The module that meshes sections cannot be used: " +
                    std::string(problem == nullptr ? file.c_str() : problem));
    }
    return reinterpret_cast<FillOutline*>(function);
}

double side(const PlanePoint& a, const PlanePoint& b, const PlanePoint& point) {
    return (b.y - a.y) * (point.z - a.z) - (b.z - a.z) * (point.y - a.y);
}

/// Holds an edge of the outline as a chord.
struct Chord {
    int first, second;
    PlanePoint a, b;

    double left() const { return std::min(a.y, b.y); }
    double right() const { return std::max(a.y, b.y); }
    bool meets(const Chord& other) const {
        if (first == other.second || second == other.first) return false;  // neighbours
        if (std::min(a.z, b.z) > std::max(other.a.z, other.b.z) || std::max(a.z, b.z) < std::min(other.a.z, other.b.z))
            return false;
        return side(a, b, other.a) * side(a, b, other.b) <= 0 &&
               side(other.a, other.b, a) * side(other.a, other.b, b) <= 0;
    }
};

/// Curves that come close to each other may not meet, and their chords do: gmsh can look for a mesh of these for ever.
void require_simple(const DividedOutline& outline) {
    std::vector<Chord> chords;
    for (const BoundaryEdge& edge : outline.edges)
        chords.push_back({edge.first, edge.second, outline.vertices[edge.first], outline.vertices[edge.second]});
    std::ranges::sort(chords, {}, &Chord::left);
    for (auto one = chords.begin(); one != chords.end(); ++one)
        for (auto other = one + 1; other != chords.end() && other->left() <= one->right(); ++other)
            if (one->meets(*other)) {
                std::array<char, 200> text{};
                std::snprintf(text.data(), text.size(),
                              "has parts closer to each other than the length of its elements at (y, z) = (%.6g, %.6g) "
                              "dy; move them apart there, or use narrower strips",
                              one->a.y, one->a.z);
                throw InvalidArgument("ics.section", text.data());
            }
}

}  // namespace

Triangulation triangulate(const DividedOutline& outline, const MeshDensity& density) {
    require_simple(outline);
    static FillOutline* const fill = open_module();
    Triangulation result;
    std::string problem;
    const SizeField size(outline, density);
    if (!fill(outline, [&](const PlanePoint& at) { return size(at); }, result, problem))
        throw InvalidArgument(
            "ics.section",
            "could not be divided into triangles: " + problem +
                "; move parts of the outline that are close to each other apart, or use narrower strips");
    if (result.triangles.empty()) throw InvalidArgument("ics.section", "could not be divided into triangles");
    return result;
}

}  // namespace contactd::fem
