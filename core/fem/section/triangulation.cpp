#include "triangulation.hpp"

#include <dlfcn.h>

#include <array>
#include <filesystem>
#include <string>
#include <system_error>

#include "contactd/error.hpp"
#include "mesher.hpp"

namespace contactd::fem {
namespace {

namespace fs = std::filesystem;

/// Beside the program where it was built, in the folder of libraries where it is installed.
fs::path module_file() {
    constexpr const char* name = "contactd-gmsh.so";
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error).parent_path(),
                   installed = (program / CONTACTD_MODULES / name).lexically_normal();
    for (const fs::path& file : {program / name, installed})
        if (fs::exists(file, error)) return file;
    throw Error("Sections are meshed by the module " + installed.string() +
                ", which is missing: install contactd whole, or put the module beside the program.");
}

/// Open until the program ends: gmsh does not bear being unloaded.
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

}  // namespace

Triangulation triangulate(const DividedOutline& outline, const MeshDensity& density) {
    static FillOutline* const fill = open_module();
    Triangulation result;
    std::string problem;
    const SizeField size(outline, density);
    if (!fill(outline, [&](const PlanePoint& at) { return size(at); }, result, problem))
        throw InvalidArgument("ics.section", "could not be divided into triangles: " + problem +
                                                 "; where parts of an outline come close to each other, keep them "
                                                 "further apart, or take narrower columns");
    if (result.triangles.empty()) throw InvalidArgument("ics.section", "could not be divided into triangles");
    return result;
}

}  // namespace contactd::fem
