// Makes the rail 60E1 (EN 13674-1). Its head ends below in straight lines to the web; fillets of web and foot are
// omitted.
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/section/outline_piece.hpp"
#include "geometry/section/ready_made.hpp"

namespace contactd::geometry {
namespace {

// Describes one half from the crown outwards on the side of +y: arcs that touch each other, then straight lines.
struct HalfRail {
    static constexpr double crown_width = 10.2, shoulder_width = 26.05;  // y where R300 and R80 end (mm)
    static constexpr double side_length = 23, under_head = 20, under_slope = 1 / 2.75;
    static constexpr double half_web = 8.25, cut_depth = 60;
    static constexpr double half_foot = 75, foot_edge = 11.5, rail_height = 172;

    double crown_angle = std::asin(crown_width / 300);
    SectionPoint crown_end{crown_width, 300 * (std::cos(crown_angle) - 1)};
    double shoulder_angle = std::asin(std::sin(crown_angle) + (shoulder_width - crown_width) / 80);
    SectionPoint shoulder_end{shoulder_width, crown_end.z + 80 * (std::cos(shoulder_angle) - std::cos(crown_angle))};
    double side_angle = std::numbers::pi / 2 - std::atan(1.0 / 20);
    SectionPoint corner_end{shoulder_end.y + 13 * (std::sin(side_angle) - std::sin(shoulder_angle)),
                            shoulder_end.z + 13 * (std::cos(side_angle) - std::cos(shoulder_angle))};
    SectionPoint side_end{corner_end.y + side_length * std::cos(side_angle),
                          corner_end.z - side_length* std::sin(side_angle)};
    SectionPoint neck{side_end.y - under_head, side_end.z - under_head* under_slope};

    std::vector<OutlinePart> parts(RailSupport support) const {
        std::vector<OutlinePart> result{{ArcTo{shoulder_end, 80}},
                                        {ArcTo{corner_end, 13}},
                                        {LineTo{side_end}},
                                        {LineTo{neck}},
                                        {LineTo{{half_web, -cut_depth}}}};
        if (support == RailSupport::foot) {
            // Slopes of 1:2.75 at the web and 1:14 at the edge meet half-way.
            const double edge = foot_edge - rail_height, middle = half_foot / 2;
            const double bend = edge + (half_foot - middle) / 14;
            const double top = bend + (middle - half_web) * under_slope;
            for (const SectionPoint& to : {SectionPoint{half_web, top}, SectionPoint{middle, bend},
                                           SectionPoint{half_foot, edge}, SectionPoint{half_foot, -rail_height}})
                result.push_back({LineTo{to}});
        }
        return result;
    }
};

SectionPoint mirrored(const SectionPoint& point) {
    return {-point.y, point.z};
}

// Returns the part on the other side in the opposite direction: it ends where this one begins.
OutlinePart mirrored(const OutlinePart& part, const SectionPoint& begin) {
    if (const auto* arc = std::get_if<ArcTo>(&part.curve)) return {ArcTo{mirrored(begin), arc->radius}};
    return {LineTo{mirrored(begin)}};
}

}  // namespace

OutlineSection outline_of(const RailSection& rail, double) {
    const HalfRail half;
    const auto right = half.parts(rail.support);
    std::vector<SectionPoint> ends{half.crown_end};
    for (const OutlinePart& part : right) ends.push_back(end_of(part));
    Outline outline{mirrored(ends.back())};
    for (std::size_t i = right.size(); i-- > 0;) outline.parts.push_back(mirrored(right[i], ends[i]));
    const std::size_t crown = outline.parts.size();
    outline.parts.push_back({ArcTo{half.crown_end, 300}});
    outline.parts.insert(outline.parts.end(), right.begin(), right.end());
    outline.parts.push_back({LineTo{outline.start}, true});
    return {.outside = std::move(outline), .part = crown, .from = 300 * half.crown_angle + rail.from};
}

}  // namespace contactd::geometry
