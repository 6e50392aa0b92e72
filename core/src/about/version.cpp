#include "contactd/version.hpp"

#include <hdf5.h>
#ifndef _WIN32
#include <sodium.h>
#endif

#include <Eigen/Core>

#include "fft/lane_fft.hpp"

namespace contactd {

std::string version() {
    return CONTACTD_VERSION;
}

std::string transform_library() {
    const auto [name, number] = fft_library();
    return std::string(name) + " " + number;
}

std::map<std::string, std::string> library_versions() {
    unsigned major = 0, minor = 0, release = 0;
    H5get_libversion(&major, &minor, &release);
    const auto dotted = [](auto a, auto b, auto c) {
        return std::to_string(a) + "." + std::to_string(b) + "." + std::to_string(c);
    };
    const auto [library, library_version] = fft_library();
    return {{"eigen", dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
            {library, library_version},
#ifndef _WIN32
            {"libsodium", sodium_version_string()},
#endif
            {"hdf5", dotted(major, minor, release)}};
}

}  // namespace contactd
