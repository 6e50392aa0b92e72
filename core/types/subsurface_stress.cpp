#include "contactd/subsurface_stress.hpp"

namespace contactd {

std::vector<std::size_t> SubsurfaceRequest::shape() const {
    if (const auto* block = std::get_if<StressBlock>(&points))
        return {block->z.size(), block->y.size(), block->x.size()};
    return {std::get<StressPoints>(points).size()};
}

std::array<double, 3> SubsurfaceRequest::point(std::size_t index) const {
    const auto* block = std::get_if<StressBlock>(&points);
    if (!block) return std::get<StressPoints>(points).at(index);
    const std::size_t nx = block->x.size(), ny = block->y.size();
    return {block->x.at(index % nx), block->y.at(index / nx % ny), block->z.at(index / nx / ny)};
}

}  // namespace contactd
