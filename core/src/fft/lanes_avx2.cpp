// Defines transforms in four lanes, for processors with AVX2 and FMA.
#include "lane_makers.hpp"

#ifdef CONTACTD_FOUR_LANES
#define CONTACTD_LANES 4
#define DUCC0_NAMESPACE contactd_four_lanes

#include "lane_headers.hpp"

// Only code after this line is compiled for these processors. Functions of the standard library are before it, because
// a program keeps one copy of them for all processors.
#pragma GCC target("avx2,fma")

#include "ducc_passes.hpp"
#include "lane_transforms.hpp"

namespace contactd {

std::unique_ptr<const LaneFft> make_four_lanes(std::size_t nx, std::size_t ny) {
    return std::unique_ptr<const LaneFft>(new Transforms(nx, ny));
}

}  // namespace contactd
#endif
