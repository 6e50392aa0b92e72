#include <algorithm>
#include <cstdlib>
#include <string>

#include "contactd/error.hpp"
#include "lane_makers.hpp"

namespace contactd {

#ifdef CONTACTD_FFTW

std::vector<std::size_t> possible_lanes() {
    return {4};
}

std::unique_ptr<const LaneFft> LaneFft::make(int padded_nx, int padded_ny, std::size_t) {
    return make_fftw_lanes(static_cast<std::size_t>(padded_nx), static_cast<std::size_t>(padded_ny));
}

#else

std::vector<std::size_t> possible_lanes() {
#ifdef CONTACTD_FOUR_LANES
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return {2, 4};
#endif
    return {2};
}

std::unique_ptr<const LaneFft> LaneFft::make(int padded_nx, int padded_ny, [[maybe_unused]] std::size_t lanes) {
    const auto nx = static_cast<std::size_t>(padded_nx), ny = static_cast<std::size_t>(padded_ny);
#ifdef CONTACTD_FOUR_LANES
    if (lanes == 4) return make_four_lanes(nx, ny);
#endif
    return make_two_lanes(nx, ny);
}

std::pair<const char*, const char*> fft_library() {
    return {"ducc0", CONTACTD_DUCC0_VERSION};
}

#endif

std::size_t lanes_by_name(const char* asked) {
    const std::vector<std::size_t> possible = possible_lanes();
    if (asked == nullptr || *asked == '\0') return possible.back();
    std::string names;
    for (const std::size_t lanes : possible) {
        const std::string name = std::to_string(lanes);
        if (asked == name) return lanes;
        names += (names.empty() ? "" : " or ") + name;
    }
    throw InvalidArgument("CONTACTD_LANES", "in the environment is '" + std::string(asked) +
                                                "'; on this processor it must be " + names + ", or unset");
}

std::size_t default_lanes() {
    static const std::size_t lanes = lanes_by_name(std::getenv("CONTACTD_LANES"));
    return lanes;
}

}  // namespace contactd
