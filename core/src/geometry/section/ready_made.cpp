#include "geometry/section/ready_made.hpp"

#include <cmath>
#include <type_traits>

namespace contactd::geometry {
namespace {

// Scales by a factor, then rotates about the origin.
class Transformation {
   public:
    Transformation(double size, double turn) : size_(size), c_(size * std::cos(turn)), s_(size * std::sin(turn)) {}

    void apply(OutlineSection& section) const {
        apply(section.outside);
        for (Outline& hole : section.holes) apply(hole);
        section.from *= size_;
    }

   private:
    void apply(SectionPoint& point) const { point = {c_ * point.y + s_ * point.z, c_ * point.z - s_ * point.y}; }
    void apply(LineTo& line) const { apply(line.to); }
    void apply(ArcTo& arc) const {
        apply(arc.to);
        arc.radius *= size_;
    }
    void apply(SplineTo& spline) const {
        for (SectionPoint& point : spline.through) apply(point);
    }
    void apply(Outline& outline) const {
        apply(outline.start);
        for (OutlinePart& part : outline.parts) std::visit([&](auto& curve) { apply(curve); }, part.curve);
    }

    double size_, c_, s_;
};

}  // namespace

OutlineSection outline_of(const Section& section, double width, const std::string& field) {
    double turn = section.turn;
    OutlineSection outline = std::visit(
        [&](const auto& shape) -> OutlineSection {
            using Shape = std::decay_t<decltype(shape)>;
            if constexpr (std::is_same_v<Shape, OutlineSection>)
                return shape;
            else if constexpr (std::is_same_v<Shape, ProfileSection> || std::is_same_v<Shape, WheelRimSection>)
                return outline_of(shape, width / section.size, field);
            else
                return outline_of(shape, width / section.size);
        },
        section.shape);
    if (const auto* rail = std::get_if<RailSection>(&section.shape)) turn -= std::atan(rail->inclination);
    if (turn != 0 || section.size != 1) Transformation(section.size, turn).apply(outline);
    return outline;
}

}  // namespace contactd::geometry
