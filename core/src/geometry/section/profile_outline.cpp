// Makes sections below the profile of a rail or above that of a wheel.
#include <algorithm>
#include <vector>

#include "contactd/below.hpp"
#include "contactd/error.hpp"
#include "contactd/make_profile.hpp"
#include "geometry/section/place_text.hpp"
#include "geometry/section/ready_made.hpp"
#include "types/number_text.hpp"

namespace contactd::geometry {
namespace {

// Describes the profile's curve between its kinks, in the order of travel: a rail's as it is, a wheel's from its other
// end.
struct Surface {
    SectionPoint start;
    std::vector<OutlinePart> parts;
    std::size_t part_at_origin = 0;
    double from_origin = 0;         // distance of the point with y = 0 from the beginning of its part
    double before = 0, behind = 0;  // lengths of the whole curve before and behind y = 0

    Surface(const ProfileCurve& curve, bool reversed) {
        const auto& points = curve.points();
        const std::size_t last = points.size() - 1;
        const auto point = [&](std::size_t i) {
            const ProfilePoint& p = points[reversed ? last - i : i];
            return SectionPoint{p.y, -p.z};
        };
        std::vector<std::size_t> ends;
        for (const std::size_t kink : curve.kinks()) ends.push_back(reversed ? last - kink : kink);
        if (reversed) std::reverse(ends.begin(), ends.end());
        ends.push_back(last);
        const auto arc_length = [&](double s) {
            return reversed ? curve.arc_length(curve.end()) - curve.arc_length(s) : curve.arc_length(s);
        };
        const double origin = arc_length(curve.s_at_y(0));
        before = origin;
        behind = curve.arc_length(curve.end()) - origin;
        start = point(0);
        std::size_t from = 0;
        for (const std::size_t to : ends) {
            const double begin = arc_length(curve.knots()[reversed ? last - from : from]);
            if (begin <= origin) {
                part_at_origin = parts.size();
                from_origin = origin - begin;
            }
            SplineTo spline;
            for (std::size_t i = from + 1; i <= to; ++i) spline.through.push_back(point(i));
            parts.push_back({std::move(spline)});
            from = to;
        }
    }
};

Profile profile_of(const ProfileSection& section, const std::string& field) {
    return below(field, [&] { return make_profile(section.profile); });
}

// Checks that strips begin on the profile, not on the sides or the cut.
void check_from(const Surface& surface, double from, const std::string& field) {
    if (from >= -surface.before && from < surface.behind) return;
    throw InvalidArgument(field, "is " + number_text(from) + "; strips must begin on the profile, which reaches from " +
                                     short_text(-surface.before) + " to " + short_text(surface.behind) +
                                     " mm along its curve, measured from y = 0");
}

// Adds vertical sides from the ends of the surface to a level cut.
OutlineSection with_cut(Surface surface, double z, double from) {
    const SectionPoint begin = surface.start, end = std::get<SplineTo>(surface.parts.back().curve).through.back();
    Outline outline{begin, std::move(surface.parts)};
    outline.parts.push_back({LineTo{{end.y, z}}});
    outline.parts.push_back({LineTo{{begin.y, z}}, true});
    outline.parts.push_back({LineTo{begin}});
    return {.outside = std::move(outline), .part = surface.part_at_origin, .from = surface.from_origin + from};
}

}  // namespace

OutlineSection outline_of(const WheelRimSection& rim, double, const std::string& field) {
    const Profile wheel = make_profile({ProfileKind::wheel, S1002{}});
    Surface surface(wheel.curve, true);
    check_from(surface, rim.from, field + ".rim_s1002.from");
    return with_cut(std::move(surface), rim.thickness, rim.from);
}

OutlineSection outline_of(const ProfileSection& section, double, const std::string& field) {
    const Profile profile = profile_of(section, field + ".profile_section");
    const bool wheel = profile.kind == ProfileKind::wheel;
    const auto& points = profile.curve.points();
    if (!(points.front().y < 0 && points.back().y > 0))
        throw InvalidArgument(field + ".profile_section.profile", "reaches from y = " + short_text(points.front().y) +
                                                                      " to " + short_text(points.back().y) +
                                                                      "; y = 0 must lie between its ends");
    for (const ProfilePoint& point : points)
        if (!((wheel ? -point.z : point.z) < section.depth))
            throw InvalidArgument(field + ".profile_section.depth",
                                  "is " + number_text(section.depth) + ", but the profile reaches " +
                                      place_text({point.y, -point.z}) + "; the cut must lie inside the body");
    Surface surface(profile.curve, wheel);
    check_from(surface, section.from, field + ".profile_section.from");
    return with_cut(std::move(surface), wheel ? section.depth : -section.depth, section.from);
}

}  // namespace contactd::geometry
