#include "section_outline.hpp"

#include <algorithm>
#include <memory>

namespace contactd::fem {
namespace {

OutlinePiece piece_of(const geometry::OutlinePiece& original) {
    const auto piece = std::make_shared<const geometry::OutlinePiece>(original);
    const double length = piece->length();
    return {length, piece->clamped(),
            [=](double s) {
                const SectionPoint at = piece->place(std::clamp(s, 0.0, length)).at;
                return PlanePoint{at.y, at.z};
            },
            [=](double s) {
                const SectionPoint normal = piece->place(std::clamp(s, 0.0, length)).normal();
                return PlanePoint{normal.y, normal.z};
            }};
}

}  // namespace

SectionOutline outline_of(const geometry::SectionGeometry& section) {
    SectionOutline outline;
    for (const geometry::ClosedCurve& curve : section.curves()) {
        OutlineLoop& loop = outline.loops.emplace_back();
        for (const geometry::OutlinePiece& piece : curve.pieces()) loop.push_back(piece_of(piece));
    }
    outline.carrier = section.carrier_index();
    outline.first_strip = section.begin_of(0);
    outline.strips = section.strips();
    return outline;
}

}  // namespace contactd::fem
