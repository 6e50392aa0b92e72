#include "geometry/section/edge_lengths.hpp"

#include <algorithm>
#include <cmath>

namespace contactd::geometry {
namespace {

double distance(const SectionPoint& a, const SectionPoint& b) {
    return std::hypot(a.y - b.y, a.z - b.z);
}

double distance(const SectionPoint& point, const SectionPoint& a, const SectionPoint& b) {
    const double y = b.y - a.y, z = b.z - a.z;
    const double share = ((point.y - a.y) * y + (point.z - a.z) * z) / (y * y + z * z), t = std::clamp(share, 0.0, 1.0);
    return distance(point, {a.y + t * y, a.z + t * z});
}

}  // namespace

EdgeLengths::EdgeLengths(const SectionGeometry& section, const MeshSizes& sizes)
    : sizes_(sizes), ds_(section.ds()), largest_(sizes.largest * section.extent()) {
    for (int column = 0; column <= section.columns(); ++column)
        columns_.push_back(section.carrier().place(section.begin_of(column)).at);
    for (const ClosedCurve& curve : section.curves()) {
        const auto& pieces = curve.pieces();
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const bool end_of_held = pieces[i].held() != pieces[(i + pieces.size() - 1) % pieces.size()].held();
            if (end_of_held || curve.turn_before(i) < -least_corner) add_corner(pieces[i].place(0).at);
        }
    }
}

void EdgeLengths::add_corner(const SectionPoint& at) {
    const double far = distance_from_columns(at);
    corners_.push_back({at, std::max(sizes_.corner_edge * ds_, sizes_.corner_share * far)});
}

double EdgeLengths::distance_from_columns(const SectionPoint& point) const {
    double nearest = INFINITY;
    for (std::size_t i = 0; i + 1 < columns_.size(); ++i)
        nearest = std::min(nearest, distance(point, columns_[i], columns_[i + 1]));
    return nearest;
}

double EdgeLengths::at(const SectionPoint& point) const {
    double edge = ds_ / sizes_.edges_per_column + sizes_.growth * distance_from_columns(point);
    for (const Corner& corner : corners_)
        edge = std::min(edge, corner.edge + sizes_.corner_growth * distance(point, corner.at));
    return std::min(edge, largest_);
}

}  // namespace contactd::geometry
