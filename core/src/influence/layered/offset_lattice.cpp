#include "influence/layered/offset_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace contactd {
namespace {

std::vector<double> lines(double first, double size, int offsets, bool is_bilinear) {
    std::vector<double> result;
    for (int i = 0; i < offsets + (is_bilinear ? 2 : 1); ++i)
        result.push_back(first + (i - (is_bilinear ? 1 : 0.5)) * size);
    return result;
}

double nearest(const std::vector<double>& lines) {
    double result = std::numeric_limits<double>::infinity();
    for (const double line : lines) result = std::min(result, std::abs(line));
    return result;
}

double farthest(const std::vector<double>& lines) {
    return std::max(std::abs(lines.front()), std::abs(lines.back()));
}

}  // namespace

EdgeLines::EdgeLines(const OffsetLattice& offsets, LoadShape load_shape)
    : x(lines(offsets.first_x, offsets.dx, offsets.nx, load_shape == LoadShape::bilinear)),
      y(lines(offsets.first_y, offsets.dy, offsets.ny, load_shape == LoadShape::bilinear)),
      least(std::max(std::min(nearest(x), nearest(y)), 1e-11 * std::min(offsets.dx, offsets.dy))),
      largest(std::hypot(farthest(x), farthest(y)) * (1 + 1e-9)) {}

}  // namespace contactd
