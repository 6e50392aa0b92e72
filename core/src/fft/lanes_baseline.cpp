// Defines transforms in the two lanes that every processor supports.
#define CONTACTD_LANES 2
#define DUCC0_NAMESPACE contactd_two_lanes

#include "lane_headers.hpp"

#include "ducc_passes.hpp"
#include "lane_makers.hpp"
#include "lane_transforms.hpp"

namespace contactd {

std::unique_ptr<const LaneFft> make_two_lanes(std::size_t nx, std::size_t ny) {
    return std::make_unique<const Transforms>(nx, ny);
}

}  // namespace contactd
